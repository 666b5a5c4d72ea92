"""A second, independent reader of every outside format, held against the planner's importers."""
