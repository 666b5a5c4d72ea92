"""Scene files as they stand: the raw scene, its JSON, its fields. No geometry is judged."""
