"""Parts of ``bench/error_time.py``: families with their truths, sweeps, curves, fits, pictures."""

from provenance import make_scenarios_importable

make_scenarios_importable()
