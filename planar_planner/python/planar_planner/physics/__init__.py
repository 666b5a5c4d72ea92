"""Checks of paths and proofs by the physics engine Chipmunk, used through pymunk.

`replay` places the robot at configurations along a path among the obstacles' shapes. `push` drives
a robot by random forces and reports whether it reaches the goal. This folder decides no query, and
no claim of the planner rests on it. Calling either function imports pymunk (docs/physics.md).
"""

from planar_planner.physics.push import push
from planar_planner.physics.replay import replay
from planar_planner.physics.report import Contact, Push, Replay, Try

__all__ = ["Contact", "Push", "Replay", "Try", "push", "replay"]
