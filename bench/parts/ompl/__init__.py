"""Parts of ``bench/ompl_compare.py``."""
