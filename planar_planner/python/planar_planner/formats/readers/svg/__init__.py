"""The reader of SVG drawings: what a viewer fills, with the roles that ids and labels state.

`document` holds what is read once a file, `style` the cascade of CSS, `lengths`, `transforms` and
`viewports` the frames, `paint` what is seen, `shapes` and `path_grammar` the outlines, `figures`
what becomes of them, and `walk` the way through all elements. svgpathtools parses path data;
tinycss2 and cssselect2 parse style sheets.
"""

from planar_planner.formats.readers.svg.walk import read

__all__ = ["read"]
