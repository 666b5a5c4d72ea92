"""Truths in exact numbers: integers, fractions, and decimals of 50 places."""
