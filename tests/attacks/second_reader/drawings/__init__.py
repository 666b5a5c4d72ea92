"""Seeded generators of drawings, one module a format."""
