"""One module per command that defines its arguments; light to import: every start pays for them."""
