"""Arguments that several commands share; light to import: every start pays for them."""
