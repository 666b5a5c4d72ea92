"""Polygonal bodies as users give them, and their convex pieces."""
