"""Escape families: a round body in a cage with a mouth, and a hook that has to leave a housing."""

from scenarios.model import Geometry, Scene, box, polygon, regular_ring, scene

# A convex body passes a gap if and only if the gap is at least as wide as the body between some two
# parallel lines: for the regular 16-gon about a circle of radius 1, cos(pi / 16) 2 = 1.9616.
OPEN_MOUTH = 2.0
CAGING_MOUTH = 1.9
# The critical slit is between 1.3485 and 1.3486, by the planner.
OPEN_SLIT = 1.42
JAMMED_SLIT = 1.25


def cage(mouth: float = CAGING_MOUTH, name: str = "cage") -> Scene:
    """Return a 16-gon of diameter 2 in a C-shaped cage with a given mouth."""
    if not 0.0 < mouth < 6.0:
        raise ValueError(f"cage: mouth is {mouth}, must be in (0, 6)")
    low, high = 4.0 - 0.5 * mouth, 4.0 + 0.5 * mouth
    return scene(
        name,
        f"A round body of diameter 2 in a cage whose mouth is {mouth} wide: does it get out?",
        reference_bounds=(-3.0, -3.0, 11.0, 11.0),
        robot=polygon(regular_ring(16, 1.0)),
        obstacles=[
            polygon(
                [
                    *[(0.0, 0.0), (8.0, 0.0), (8.0, low), (7.0, low), (7.0, 1.0), (1.0, 1.0)],
                    *[(1.0, 7.0), (7.0, 7.0), (7.0, high), (8.0, high), (8.0, 8.0), (0.0, 8.0)],
                ]
            )
        ],
        start=(3.0, 4.0, 0.0),
        goal={"escape": box(-1.0, -1.0, 9.0, 9.0)},  # the cage grown by the body: clear of it
    )


def disassembly(slit: float = OPEN_SLIT, name: str = "disassembly") -> Scene:
    """Return a hook whose foot is behind the lips of a housing with a given slit."""
    if not 0.0 < slit < 6.0:
        raise ValueError(f"disassembly: slit is {slit}, must be in (0, 6)")
    left, right = 3.0 - 0.5 * slit, 3.0 + 0.5 * slit
    housing: Geometry = polygon(
        [
            *[(-1.0, -1.0), (7.0, -1.0), (7.0, 4.0), (right, 4.0), (right, 3.0), (6.0, 3.0)],
            *[(6.0, 0.0), (0.0, 0.0), (0.0, 3.0), (left, 3.0), (left, 4.0), (-1.0, 4.0)],
        ]
    )
    return scene(
        name,
        f"A hook is to be taken out of a housing through a slit {slit} wide, wherever to.",
        reference_bounds=(-9.0, -9.0, 15.0, 15.0),
        robot=polygon(
            [(-0.3, -1.2), (2.2, -1.2), (2.2, -0.6), (0.3, -0.6), (0.3, 5.0), (-0.3, 5.0)]
        ),
        obstacles=[housing],
        start=(3.0, 1.6, 0.0),
        goal="escape",
    )
