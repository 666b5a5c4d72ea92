"""One module an outside format, with a function `read` that turns a file into `Parts`."""
