"""Independent, slow answers that the tests compare the planner with. Nothing here imports it."""
