"""Makes the benchmarks importable; importing `lib` does so for what they stand on."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

import lib  # noqa: F401
