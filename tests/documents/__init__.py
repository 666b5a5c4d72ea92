"""What the pages show, taken from their text and run."""
