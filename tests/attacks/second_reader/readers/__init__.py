"""The independent readers, one module a format."""
