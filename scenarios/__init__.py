"""Scenes shipped with the planner, and the families of scenes they are taken from."""
