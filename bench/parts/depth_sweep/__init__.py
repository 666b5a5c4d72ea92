"""Parts of ``bench/depth_sweep.py``."""
