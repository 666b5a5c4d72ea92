"""Depths of planar bodies: values, bounds, brackets, the C-obstacle query and motions."""
