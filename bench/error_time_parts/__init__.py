"""Parts of ``bench/error_time.py``: families with their truths, sweeps, curves, fits, pictures."""

import provenance  # noqa: F401  (makes scenarios importable)
