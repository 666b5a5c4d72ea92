"""A second, independent reader of every imported format, held against the planner's importers."""
