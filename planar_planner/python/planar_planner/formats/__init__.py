"""Other file formats: one module per format, found through `planar_planner.formats.registry`.

A reader turns a file into `Parts`, and `planar_planner.formats.assemble` turns these into a scene.
``docs/formats.md`` states what each format guarantees.
"""
