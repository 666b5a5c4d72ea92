"""What all benchmarks share. Importing it makes what they stand on importable.

That is the tests' oracles and worlds, and the generators of scenes. Their folders are appended, so
that the installed planner is the one that is measured.
"""

import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
sys.path.extend(str(folder) for folder in (_ROOT, _ROOT / "tests") if str(folder) not in sys.path)
