"""One module a command: `add` defines its arguments, `run` returns the exit status."""
