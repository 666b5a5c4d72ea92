"""A problem is handed to the native core, and its answer becomes a result."""
