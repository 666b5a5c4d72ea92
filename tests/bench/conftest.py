"""Makes ``bench/`` and the generators importable, after anything that is installed."""

import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

for folder in (ROOT / "bench", ROOT):
    if str(folder) not in sys.path:
        sys.path.append(str(folder))
