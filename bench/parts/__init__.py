"""Parts of benchmarks that are too long for one file, a folder for each question."""
