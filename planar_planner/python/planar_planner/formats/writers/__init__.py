"""One module an outside format, with a function `write` that turns `Parts` into files."""
