"""Attacks on the answers, by themselves: stress, fuzzing, rounding, determinism."""
