"""What a search has left, as arrays: cells, the wall of a proof, and its thinnest place."""
