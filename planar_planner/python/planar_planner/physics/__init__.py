"""Paths and proofs before an outside witness: the Chipmunk physics engine, by pymunk.

`replay` puts the robot along a path among the obstacles' shapes; `push` lets a robot that forces
drive try to get to the goal. Nothing here decides a query, and no claim of the planner rests on it.
pymunk is imported when one of the two is called (docs/physics.md).
"""

from planar_planner.physics.push import push
from planar_planner.physics.replay import replay
from planar_planner.physics.report import Contact, Push, Replay, Try

__all__ = ["Contact", "Push", "Replay", "Try", "push", "replay"]
