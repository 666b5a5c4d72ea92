"""Comb family: a robot with holes and prongs, moved from one rack to another.

The comb starts with its prongs between the pegs of one rack, leaves it lengthways, passes a gate in
a wall and ends, turned by half a turn, between the pegs of another rack.
In the jammed twin a post stands in one of the holes of the comb.
"""

import math

from scenarios.model import Geometry, Scene, box, box_ring, polygon, scene

PRONGS = 5
PITCH = 0.5  # between prongs
PRONG = 0.2  # width of a prong
PRONG_LENGTH = 0.8
PEG = 0.16  # width of a rack's peg: 0.07 of play on either side
GATE = 1.9


def comb_polygon() -> Geometry:
    """Return the comb: a back 2.4 x 0.7 with two holes, about the origin; five prongs down."""
    half = 0.5 * (PRONGS - 1) * PITCH + 0.5 * PRONG + 0.1
    bottom, top = -0.35, 0.35
    outer = [(half, bottom), (half, top), (-half, top), (-half, bottom)]
    for k in range(PRONGS):
        x = (k - 0.5 * (PRONGS - 1)) * PITCH
        left, right = round(x - 0.5 * PRONG, 6), round(x + 0.5 * PRONG, 6)
        outer += [
            (left, bottom),
            (left, bottom - PRONG_LENGTH),
            (right, bottom - PRONG_LENGTH),
            (right, bottom),
        ]
    holes = [box_ring(-0.9, -0.15, -0.2, 0.15), box_ring(0.2, -0.15, 0.9, 0.15)]
    return polygon(outer, *(list(reversed(hole)) for hole in holes))


def rack(x: float, base: float, tip: float) -> list[Geometry]:
    """Return four pegs about x, between a wall at ``base`` and ``tip`` (either may be lower)."""
    low, high = min(base, tip), max(base, tip)
    middles = [x + (k - 0.5 * (PRONGS - 2)) * PITCH for k in range(PRONGS - 1)]
    return [box(round(m - 0.5 * PEG, 6), low, round(m + 0.5 * PEG, 6), high) for m in middles]


def comb(*, post: bool = False, name: str = "comb") -> Scene:
    """Comb scene; with ``post`` a post stands in a hole of the comb at the start, which jams it."""
    obstacles = [
        *rack(-3.5, -3.0, -2.2),
        *rack(3.5, 3.0, 2.2),
        box(-0.15, -3.0, 0.15, -0.5 * GATE),
        box(-0.15, 0.5 * GATE, 0.15, 3.0),
    ]
    start_y = -1.7  # prong tips at -2.85, pegs from -3 to -2.2
    if post:
        obstacles.append(box(-4.15, start_y - 0.1, -3.95, start_y + 0.1))
    return scene(
        name,
        "A comb with two holes must leave one rack, pass a gate and enter another rack upside down"
        + (", but a post stands in one of its holes." if post else "."),
        workspace=(-6.0, -3.0, 6.0, 3.0),
        robot=comb_polygon(),
        obstacles=obstacles,
        start=(-3.5, start_y, 0.0),
        goal=(3.5, -start_y, math.pi),
    )
