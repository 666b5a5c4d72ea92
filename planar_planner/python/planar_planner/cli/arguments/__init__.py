"""Arguments that several commands share; light to import, since every start imports them."""
