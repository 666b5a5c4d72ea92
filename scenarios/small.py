"""Small scenes, each made for one feature of the format or of the planner."""

import math

from scenarios.model import Scene, box, box_ring, polygon, regular_ring, scene


def open_floor() -> Scene:
    """Return a scene that one straight move solves."""
    return scene(
        "open",
        "A rectangle on an open floor: a straight move is free.",
        workspace=(0.0, 0.0, 10.0, 6.0),
        robot=box(-0.5, -0.25, 0.5, 0.25),
        obstacles=[box(4.0, 0.0, 5.0, 1.5), polygon([(6.0, 6.0), (7.5, 6.0), (7.0, 4.5)])],
        start=(1.5, 3.0, 0.0),
        goal=(8.5, 3.0, 1.5),
    )


def window(*, rotation: bool = True, name: str = "window") -> Scene:
    """Return a bar that fits through a window only crosswise to its start and goal.

    Without rotation there is no path; with it there is.
    """
    return scene(
        name,
        "A bar of 1.6 must pass a window 1.0 high"
        + (" by turning." if rotation else ", but it may not turn."),
        workspace=(-4.0, -2.5, 4.0, 2.5),
        rotation=rotation,
        robot=box(-0.2, -0.8, 0.2, 0.8),
        obstacles=[box(-0.3, 0.5, 0.3, 2.5), box(-0.3, -2.5, 0.3, -0.5)],
        start=(-2.5, 0.0, 0.0),
        goal=(2.5, 0.0, 0.0),
    )


def slide(*, blocked: bool = False, name: str = "slide") -> Scene:
    """Return a U-shaped part that translates along a rail; turning is not allowed."""
    pegs = [(-2.2, 0.6), (2.2, 0.6)]
    top = 3.4 if blocked else 2.2
    return scene(
        name,
        "A U-shaped part, which may not turn, must be lifted off one peg and put on another"
        + (", but the bar between them reaches too high." if blocked else "."),
        workspace=(-4.0, 0.0, 4.0, 4.0),
        rotation=False,
        robot=polygon(
            [
                (-0.6, 0.0),
                (-0.3, 0.0),
                (-0.3, 0.8),
                (0.3, 0.8),
                (0.3, 0.0),
                (0.6, 0.0),
                (0.6, 1.1),
                (-0.6, 1.1),
            ]
        ),
        obstacles=[
            *(box(x - 0.15, 0.0, x + 0.15, height) for x, height in pegs),
            box(-0.4, 0.0, 0.4, top),
        ],
        start=(-2.2, 0.1, 0.0),
        goal=(2.2, 0.1, 0.0),
    )


def courtyard() -> Scene:
    """Return a polygonal workspace, with a hole, that is its own obstacle."""
    return scene(
        "courtyard",
        "A triangle in an octagonal workspace with a square hole, to the other side of the hole.",
        workspace=polygon(
            [
                (-5.0, -2.0),
                (-2.0, -5.0),
                (2.0, -5.0),
                (5.0, -2.0),
                (5.0, 2.0),
                (2.0, 5.0),
                (-2.0, 5.0),
                (-5.0, 2.0),
            ],
            list(reversed(box_ring(-2.0, -2.5, 2.5, 2.0))),
        ),
        robot=polygon([(-0.7, -0.6), (0.9, 0.0), (-0.7, 0.6)]),
        obstacles=[box(-0.3, -5.0, 0.3, -3.4)],
        start=(-3.5, 0.0, 0.5 * math.pi),
        goal=(3.75, -0.5, -1.0),
    )


def fence() -> Scene:
    """Return a scene with bounds as in OMPL: they apply to the reference point only."""
    return scene(
        "fence",
        "The reference point is bounded, the body may stick out: a path round a fence.",
        reference_bounds=(-4.0, -2.0, 4.0, 2.0),
        robot=polygon([(-0.2, -0.2), (1.4, -0.2), (1.4, 0.2), (0.2, 0.2), (0.2, 0.9), (-0.2, 0.9)]),
        obstacles=[box(-0.2, -1.4, 0.2, 1.4), box(1.8, 1.2, 3.0, 2.4)],
        start=(-2.5, 0.0, 0.0),
        goal=(2.5, 0.0, 3.0),
    )


def disc(gap: float = 1.2, name: str = "disc") -> Scene:
    """Return a disc-like robot (a 32-gon of radius 0.5) among pegs: turning never helps it."""
    pegs = [
        polygon(regular_ring(12, 0.6, (-2.4 + 4.8 * column, y), 0.1))
        for column in range(2)
        for y in (-1.8 - gap, 0.0, 1.8 + gap)
    ]
    gate = [box(-0.2, 0.5 * gap, 0.2, 5.0), box(-0.2, -5.0, 0.2, -0.5 * gap)]
    return scene(
        name,
        f"A 32-gon of radius 0.5 among pegs and through a gate {gap} wide.",
        workspace=(-5.0, -5.0, 5.0, 5.0),
        robot=polygon(regular_ring(32, 0.5)),
        obstacles=[*pegs, *gate],
        start=(-4.0, 0.0, 0.0),
        goal=(4.0, 0.0, 0.0),
    )
