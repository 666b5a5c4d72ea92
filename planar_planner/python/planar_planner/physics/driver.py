"""The driver of a robot with mass: it applies random pushes and advances time in small steps."""

from __future__ import annotations

import math
import random
from typing import TYPE_CHECKING

import numpy as np

from planar_planner.physics.goals import nearest_goal
from planar_planner.physics.shapes import slabs
from planar_planner.physics.world import World, engine
from planar_planner.planning.path_samples import reach
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Box, Configuration
from planar_planner.tolerances import ASIDE

if TYPE_CHECKING:
    import pymunk

SPEED = 2.0
"""Top speed of the centre of gravity and of the outermost point about it, in reaches per second."""

ACCELERATION = 4.0 * SPEED
"""Acceleration by a push, in reaches per second squared: it gives top speed in a quarter second."""

DAMPING = 0.5
"""Share of its velocity that a robot keeps after a second without pushes."""

PUSH_SECONDS = (0.25, 1.5)
"""Range of the random duration of a push, in seconds: from a short start to a travel of three
reaches."""

GOALWARDS = 0.5
"""Share of pushes that are towards the goal; the others have a random direction and torque."""

ITERATIONS = 30
"""Iterations of Chipmunk's contact solver per step; with its default of 10 corners overlap."""

KEPT_OVERLAP = 0.8
"""Share of an overlap that is left after a step: Chipmunk's collision_bias, per step."""

FASTEST = 4.0
"""Factor on the motion of a step at top speed. A larger motion is a fault of Chipmunk. Motion about
a reference point away from the centre of gravity can seem three times as fast, and the push out of
an overlap adds a fifth of it."""


class Driver:
    """Owns a robot in its space: it pushes the robot, advances time and limits the speed.

    Parameters
    ----------
    problem : Problem
        Gives start, goal and bounds of the reference point.
    world : World
        Has a dynamic robot; the driver takes ownership of it.
    chance : random.Random
        Source of the random pushes.
    """

    def __init__(self, problem: Problem, world: World, chance: random.Random) -> None:
        self._problem, self._world, self._chance = problem, world, chance
        self._space, self._body = world.space, world.robot
        x, y, theta = problem.start
        self._body.position = x * world.scale, y * world.scale
        self._body.angle = theta
        self._space.add(self._body, *self._body.shapes)
        self._space.damping = DAMPING
        self._space.iterations = ITERATIONS
        self._space.collision_slop = 0.0  # Chipmunk's default, 0.1, is a length that it ignores
        self._reach = reach(problem.robot) * world.scale
        self._lever = _lever(self._body)
        if problem.reference_bounds is not None:
            _confine(world, problem.reference_bounds, self._reach / world.scale)
        self.undone = 0
        self._until = 0.0
        self._force, self._torque, self._goalwards = (0.0, 0.0), 0.0, False
        self._time = 0.0

    def advance(self, time_step: float) -> None:
        """Push for one step.

        Chipmunk moves the robot, finds contacts and then changes velocities, so the contacts belong
        to the new configuration.
        """
        if self._time >= self._until:
            self._new_push()
        if self._goalwards:
            self._aim()
        self._body.force = self._force
        self._body.torque = self._torque
        self._space.collision_bias = KEPT_OVERLAP ** (1.0 / time_step)  # Chipmunk's is per second
        before = self.configuration()
        self._space.step(time_step)
        if self._moved(before) > FASTEST * 2.0 * SPEED * self._reach * time_step:
            self._take_back(before)
        self._limit_speed()
        self._time += time_step

    def configuration(self) -> Configuration:
        """Return the robot's configuration, in the scene's unit and radians."""
        x, y = self._body.position
        return x / self._world.scale, y / self._world.scale, self._body.angle

    def depth(self) -> float:
        """Return the deepest penetration of the robot's shapes now, in the scene's unit."""
        found = [0.0]
        self._body.each_arbiter(_note_depth, found)
        return found[0] / self._world.scale

    def _moved(self, before: Configuration) -> float:
        """Return a bound on how far a point of the robot has moved, in lengths of the space."""
        now = self.configuration()
        shift = math.dist(before[:2], now[:2]) * self._world.scale
        return shift + self._reach * abs(now[2] - before[2])

    def _take_back(self, before: Configuration) -> None:
        """Put the robot at rest at a random place a billionth of its reach from where it was.

        Chipmunk throws a robot when it misjudges a contact of edges that touch to the last bit
        (`planar_planner.physics.contacts`); at the random place the edges do not touch in this way.
        """
        self.undone += 1
        x, y, theta = before
        aside = self._chance.uniform(0.0, math.tau)
        self._body.position = (
            x * self._world.scale + ASIDE * math.cos(aside),
            y * self._world.scale + ASIDE * math.sin(aside),
        )
        self._body.angle = theta
        self._body.velocity = (0.0, 0.0)
        self._body.angular_velocity = 0.0

    def _new_push(self) -> None:
        chance = self._chance
        self._until = self._time + chance.uniform(*PUSH_SECONDS)
        self._goalwards = chance.random() < GOALWARDS
        angle, share = chance.uniform(0.0, math.tau), chance.random()
        self._force = self._shove(share * math.cos(angle), share * math.sin(angle))
        self._torque = self._twist(chance.uniform(-1.0, 1.0))

    def _aim(self) -> None:
        """Push the reference point to the goal, and turn the shorter way; softer when near."""
        x, y, theta = self.configuration()
        goal = nearest_goal(self._problem, (x, y, theta))
        dx, dy = (goal[0] - x) * self._world.scale, (goal[1] - y) * self._world.scale
        far = max(self._reach, math.hypot(dx, dy))
        self._force = self._shove(dx / far, dy / far)
        self._torque = self._twist(max(-1.0, min(1.0, goal[2] - theta)))

    def _shove(self, x: float, y: float) -> tuple[float, float]:
        strength = self._body.mass * ACCELERATION * self._reach
        return x * strength, y * strength

    def _twist(self, share: float) -> float:
        if not self._problem.rotation:
            return 0.0
        return share * self._body.moment * ACCELERATION * self._reach / self._lever

    def _limit_speed(self) -> None:
        most = SPEED * self._reach
        speed = self._body.velocity.length
        if speed > most:
            self._body.velocity = self._body.velocity * (most / speed)
        spin = most / self._lever
        self._body.angular_velocity = max(-spin, min(spin, self._body.angular_velocity))


def _note_depth(arbiter: pymunk.Arbiter, found: list[float]) -> None:
    if any(shape.filter.mask == _POINT for shape in arbiter.shapes):
        return  # the disc about the reference point is not a part of the robot
    for point in arbiter.contact_point_set.points:
        found[0] = max(found[0], -point.distance)


def _lever(body: pymunk.Body) -> float:
    """Return the greatest distance of a vertex from the centre of gravity."""
    vertices = np.concatenate([shape.get_vertices() for shape in body.shapes])
    return float(np.hypot(*(vertices - np.array(body.center_of_gravity)).T).max())


_BODIES, _POINT = 0b01, 0b10  # categories of shapes; a shape collides only with its own category


def _confine(world: World, bounds: Box, radius: float) -> None:
    """Keep the reference point in its bounds: a disc about it meets walls one radius outside."""
    pymunk = engine()
    bodies = pymunk.ShapeFilter(categories=_BODIES, mask=_BODIES)
    point = pymunk.ShapeFilter(categories=_POINT, mask=_POINT)
    for shape in (*world.robot.shapes, *world.space.static_body.shapes):
        shape.filter = bodies
    x0, y0, x1, y1 = bounds
    around = (x0 - radius, y0 - radius, x1 + radius, y1 + radius)
    walls = [
        pymunk.Poly(world.space.static_body, (wall * world.scale).tolist())
        for wall in slabs(around, 4.0 * radius)
    ]
    disc = pymunk.Circle(world.robot, radius * world.scale)
    for shape in (*walls, disc):
        shape.filter = point
        shape.friction = shape.elasticity = 0.0
        world.space.add(shape)
