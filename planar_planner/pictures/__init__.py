"""Pictures of scenes, paths, cells and walls; `planar_planner.plot` is their public side."""
