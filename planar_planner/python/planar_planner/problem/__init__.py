"""The gate: a raw scene becomes a valid problem, or a message that says what is wrong."""
