"""Parts of ``bench/targets.py``."""
