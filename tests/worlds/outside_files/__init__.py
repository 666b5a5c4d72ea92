"""Files in other formats, written here: what the readers' tests and the fuzzing begin with."""
