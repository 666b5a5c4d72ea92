"""Readers: one module per format, with a function `read` that turns a file into `Parts`."""
