"""Outside formats: one module a format, all behind `planar_planner.formats.registry`.

A reader turns a file into `Parts`; `planar_planner.formats.assemble` makes a scene of them. What
each format guarantees is in ``docs/formats.md``.
"""
