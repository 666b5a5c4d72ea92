"""Writers: one module per format, with a function `write` that turns `Parts` into files."""
