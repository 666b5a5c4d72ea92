"""Parts of ``bench/error_time.py``: families with their truths, sweeps, curves, fits, pictures."""
