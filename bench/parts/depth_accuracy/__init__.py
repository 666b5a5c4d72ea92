"""Parts of ``bench/depth_accuracy.py``: bodies, and oracles that share nothing with the library."""
