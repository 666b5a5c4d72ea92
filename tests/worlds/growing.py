"""Scenes that grow in one respect and in nothing else."""

from __future__ import annotations

import math
import random

from scenarios.model import Geometry, Scene, box, polygon, regular_ring, scene

SEED = 3

# Corridor that does not change, obstacles beside it that get more and smaller.
SIDE = 40.0
HALF_CHANNEL = 0.9
FILLED = 0.45  # radius of an obstacle over the distance to the next

# Baffles one after another: the way grows with their number.
PITCH = 3.0
HEIGHT = 4.0
OPENING = 1.2
BAFFLE = 0.2
CHICANE = ((13.0, 1), (27.0, -1))  # baffles of the fixed channel: x, side that they come from


def _bar() -> Geometry:
    return polygon([(-0.8, -0.2), (0.8, -0.2), (0.8, 0.2), (-0.8, 0.2)])


def fixed_channel(count: int) -> Scene:
    """Return a bar that must go along a lane, past two baffles, between `count` small obstacles.

    They stand on a jittered grid on both sides, closer together than the bar is wide from some
    hundred on: the lane stays what it is, about sqrt(count) of them line it.
    """
    rng = random.Random(SEED)
    rows = max(1, math.isqrt(count // 2))
    columns = math.ceil(count / (2 * rows))
    dx, dy = SIDE / columns, (0.5 * SIDE - HALF_CHANNEL) / rows
    radius = FILLED * min(dx, dy)
    obstacles = []
    for number in range(count):
        side, place = divmod(number, rows * columns)
        row, column = divmod(place, columns)
        y = HALF_CHANNEL + radius + row * dy + rng.uniform(0.0, dy - 2.0 * radius)
        x = column * dx + radius + rng.uniform(0.0, dx - 2.0 * radius)
        ring = regular_ring(rng.randint(3, 7), radius, (x, y if side == 0 else -y), rng.random())
        obstacles.append(polygon(ring))
    for x, sign in CHICANE:
        low, high = sorted((-0.2 * sign, 21.0 * sign))
        obstacles.append(box(x - 0.5 * BAFFLE, low, x + 0.5 * BAFFLE, high))
    return scene(
        f"lane-{count}",
        f"A bar in a lane between {count} small obstacles.",
        workspace=(0.0, -0.5 * SIDE, SIDE, 0.5 * SIDE),
        robot=_bar(),
        obstacles=obstacles,
        start=(2.0, 0.0, 0.5 * math.pi),
        goal=(SIDE - 2.0, 0.0, 0.5 * math.pi),
    )


def growing_channel(count: int) -> Scene:
    """Return a bar that must pass `count` baffles, open at the top and at the bottom in turn."""
    obstacles = []
    for k in range(count):
        x = PITCH * (k + 1)
        low, high = (-1.0, HEIGHT - OPENING) if k % 2 == 0 else (OPENING, HEIGHT + 1.0)
        obstacles.append(box(x - 0.5 * BAFFLE, low, x + 0.5 * BAFFLE, high))
    length = PITCH * (count + 1)
    middle = 0.5 * HEIGHT
    return scene(
        f"baffles-{count}",
        f"A bar past {count} baffles, one after another.",
        workspace=(0.0, 0.0, length, HEIGHT),
        robot=_bar(),
        obstacles=obstacles,
        start=(0.5 * PITCH, middle, 0.5 * math.pi),
        goal=(length - 0.5 * PITCH, middle, 0.5 * math.pi),
    )


def toothed(pieces: int, length: float) -> Scene:
    """Return a bar with ``pieces - 1`` teeth that must turn a corner of unit corridors.

    The teeth share the bar's length, so the outline's extent does not depend on their number.
    """
    half, extent = 0.5 * length, 4.0
    ring = [(-half, -0.2), (half, -0.2), (half, -0.1)]
    teeth = pieces - 1
    pitch = length / max(teeth, 1)
    for k in reversed(range(teeth)):
        left = -half + (k + 0.25) * pitch
        right = left + 0.5 * pitch
        ring += [(right, -0.1), (right, 0.2), (left, 0.2), (left, -0.1)]
    ring.append((-half, -0.1))
    middle_of_arm = 0.5 * (1.0 + extent)
    return scene(
        f"toothed-{pieces}",
        f"A bar with {teeth} teeth, {length} long, must turn a corner.",
        workspace=(0.0, 0.0, extent, extent),
        robot=polygon(ring),
        obstacles=[box(1.0, 1.0, extent, extent)],
        start=(0.5, middle_of_arm, -0.5 * math.pi),
        goal=(middle_of_arm, 0.5, 0.0),
    )
