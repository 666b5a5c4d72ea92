"""The reader of DXF drawings; see `planar_planner.formats.readers.dxf.reading`."""

from planar_planner.formats.readers.dxf.reading import read

__all__ = ["read"]
