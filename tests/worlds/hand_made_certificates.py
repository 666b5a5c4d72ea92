"""Small scenes and their certificates, written by hand from docs/certificate.md alone."""

from __future__ import annotations

import copy
from math import cos, pi, sin
from typing import Any

from planar_planner.load import load_scene
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.make import make_problem

Json = dict[str, Any]

SQUARE = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
SMALL = [[-0.25, -0.25], [0.25, -0.25], [0.25, 0.25], [-0.25, 0.25]]
DIAMOND = [[0.0, -0.5], [0.5, 0.0], [0.0, 0.5], [-0.5, 0.0]]
DISC = [[0.45 * cos(pi * k / 8), 0.45 * sin(pi * k / 8)] for k in range(16)]
# Nothing refers to it: too far to the right for any of the paths and separations below.
FAR_L = [[9.0, 1.0], [9.75, 1.0], [9.75, 1.25], [9.25, 1.25], [9.25, 1.75], [9.0, 1.75]]


def rectangle(xmin: float, ymin: float, xmax: float, ymax: float) -> list[list[float]]:
    return [[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]]


def signed(scene: Json, certificate: Json) -> Json:
    """Return the certificate with the hash of the scene."""
    return {**certificate, "scene": fingerprint(make_problem(load_scene(scene)))}


def _scene(robot: list[Any], obstacles: list[Any], **fields: Any) -> Json:
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 4]},
        "robot": {"type": "Polygon", "coordinates": [robot]},
        "obstacles": [{"type": "Polygon", "coordinates": [ring]} for ring in obstacles],
        "start": [2, 1, 0],
        "goal": [8, 1, 0],
    } | fields


def _certificate(
    scene: Json, robot: list[Any], obstacles: Json, **fields: Any
) -> tuple[Json, Json]:
    common = {
        "format": "planar-planner/certificate",
        "version": 1,
        "made_by": "hand",
        "robot_pieces": {"0": [robot]},
        "obstacle_pieces": obstacles,
    }
    return scene, signed(scene, common | fields)


def _separation(**fields: Any) -> Json:
    # 7/16, so that the robot, which reaches 1/2 from its reference point, is beyond the walls there
    domain = {"low": [[7, -4], [7, -4]], "size": [[146, -4], [50, -4]]}
    common = {"verdict": "no_path", "claim": "separation", "domain": domain, "full_faces": []}
    return common | fields


WHOLE = [0, 0]
PAIR = [0, 0, 0, 0]
WALL = rectangle(4.5, 0, 5.5, 4)  # from floor to ceiling


def _before_wall(**fields: Any) -> tuple[Json, Json]:
    """A square that may turn before the wall."""
    return _certificate(_scene(SQUARE, [WALL]), SQUARE, {"0": [WALL]}, **fields)


def fixed_wall() -> tuple[Json, Json]:
    """A square that may not turn, a wall from floor to ceiling, an L that nothing refers to."""
    scene = _scene(SQUARE, [WALL, FAR_L], rotation=False)
    return _certificate(
        scene,
        SQUARE,
        {"0": [WALL]},
        **_separation(
            start_side=[[[2, 0], WHOLE, WHOLE], [[3, 2], WHOLE, WHOLE], [[4, 6], WHOLE, WHOLE]],
            full=[{"box": [[4, 7], [1, 0], WHOLE], "pair": PAIR}],
            full_faces=[{"box": [[4, 7], [1, 1], WHOLE], "axis": 0, "pair": PAIR}],
        ),
    )


def turning_wall() -> tuple[Json, Json]:
    """The same with turning; the start's side is cut at half a turn, so the seam matters."""
    return _before_wall(
        **_separation(
            start_side=[[[1, 0], WHOLE, [1, 0]], [[1, 0], WHOLE, [1, 1]]],
            full=[{"box": [[5, 16], WHOLE, WHOLE], "pair": PAIR}],
        ),
    )


def gap() -> tuple[Json, Json]:
    """A diamond of height 1 and a gap of 0.97 above the floor: only jointly obstructed."""
    block = rectangle(4, 0.97, 6, 4)
    scene = _scene(DIAMOND, [block], rotation=False)
    return _certificate(
        scene,
        DIAMOND,
        {"0": [block]},
        **_separation(
            start_side=[[[1, 0], WHOLE, WHOLE]],
            full=[{"box": [[6, 32], [1, 1], WHOLE], "pair": PAIR}],
            full_faces=[
                {"box": [[1, 1], [2, 1], WHOLE], "axis": 0, "pair": PAIR},
                {"box": [[1, 1], [6, 0], WHOLE], "axis": 0, "wall": "y_min"},
                {
                    "box": [[1, 1], [2, 0], WHOLE],
                    "axis": 0,
                    "joint": {
                        "axes": [{"pair": PAIR, "edges": [["obstacle", 0]]}],
                        "sums": [
                            [
                                {"wall": "y_min", "vertex": [0.0, -0.5], "weight": 1.0},
                                {
                                    "pair": PAIR,
                                    "owner": "obstacle",
                                    "edge": 0,
                                    "vertex": 2,
                                    "weight": 0.5,  # the edge is 2 long
                                },
                            ]
                        ],
                    },
                },
            ],
        ),
    )


def disc() -> tuple[Json, Json]:
    """The turning square again, replaced by a disc inside it."""
    return _before_wall(
        **_separation(
            claim="disc",
            disc=DISC,
            inside=[0, 0],
            start_side=[[[1, 0], WHOLE, WHOLE]],
            full=[],
            full_faces=[{"box": [[1, 1], WHOLE, WHOLE], "axis": 0, "pair": PAIR}],
        ),
    )


def blocked_start() -> tuple[Json, Json]:
    """The start overlaps an obstacle."""
    block = rectangle(1, 0, 3, 2)
    scene = _scene(SQUARE, [block])
    end = {"verdict": "no_path", "claim": "end", "end": "start", "pair": PAIR}
    return _certificate(scene, SQUARE, {"0": [block]}, **end)


def goal_in_wall() -> tuple[Json, Json]:
    """The goal is partly beyond the workspace."""
    scene = _scene(SQUARE, [], goal=[9.75, 2, 0.5])
    end = {"verdict": "no_path", "claim": "end", "end": "goal", "wall": "x_max"}
    return _certificate(scene, SQUARE, {}, **end)


def goal_out_of_bounds() -> tuple[Json, Json]:
    """The goal's reference point is outside its bounds."""
    scene = _scene(SQUARE, [], reference_bounds=[1, 1, 7, 3])
    end = {"verdict": "no_path", "claim": "end", "end": "goal", "reference_bounds": True}
    return _certificate(scene, SQUARE, {}, **end)


def _interval(begin: float, end: float, *apart: list[Any]) -> Json:
    return {"from": begin, "to": end, "apart": [list(each) for each in apart]}


def over_block(**fields: Any) -> tuple[Json, Json]:
    """Over a triangle along its slopes, and a turn at the end."""
    block = [[3, 0], [7, 0], [5, 2]]
    scene = _scene(SMALL, [block, FAR_L], **{"goal": [8, 1, 1.5]} | fields)
    right, left = ([*PAIR, "obstacle", edge] for edge in (1, 2))
    return _certificate(
        scene,
        SMALL,
        {"0": [block]},
        verdict="path",
        contact_tolerance=0.0,
        waypoints=[[2, 1, 0, 0], [5, 3, 0, 0], [8, 1, 0, 0], [8, 1, 1.5, 0]],
        segments=[
            [_interval(0, 0.5, left), _interval(0.5, 1, left)],
            [_interval(0, 0.5, right), _interval(0.5, 1, right)],
            [_interval(k / 8, (k + 1) / 8) for k in range(8)],
        ],
    )


def bounded_path() -> tuple[Json, Json]:
    """The same with bounds of the reference point."""
    return over_block(reference_bounds=[1, 0.5, 9, 3.25])


def fixed_path() -> tuple[Json, Json]:
    """The same without turning."""
    scene, certificate = over_block(rotation=False, goal=[8, 1, 0])
    certificate["waypoints"].pop()
    certificate["segments"].pop()
    return scene, signed(scene, certificate)


def bent_workspace() -> tuple[Json, Json]:
    """Round the corner of an L-shaped workspace; what is outside it has five pieces."""
    ring = [[0, 0], [10, 0], [10, 2], [4, 2], [4, 4], [0, 4]]
    scene = _scene(SQUARE, [], start=[2, 3, 0])
    scene["workspace"] = {"type": "Polygon", "coordinates": [ring]}
    outside = [
        rectangle(-1, -1, 0, 5),
        rectangle(10, -1, 11, 5),
        rectangle(0, -1, 10, 0),
        rectangle(0, 4, 4, 5),
        rectangle(4, 2, 10, 5),
    ]
    return _certificate(
        scene,
        SQUARE,
        {"0": outside},
        outside=[-1, -1, 11, 5],
        verdict="path",
        contact_tolerance=0.0,
        waypoints=[[2, 3, 0, 0], [2, 1, 0, 0], [8, 1, 0, 0]],
        segments=[[_interval(0, 1)], [_interval(0, 1)]],
    )


def _chain(*links: Json) -> Json:
    return {"verdict": "no_path", "claim": "odd_chain", "chain": list(links)}


CEILING, FLOOR, LEFT_SIDE = {"side": "y_max"}, {"side": "y_min"}, {"side": "x_min"}


def chained_wall() -> tuple[Json, Json]:
    """The square that may not turn, and the wall as the link between ceiling and floor."""
    scene = _scene(SQUARE, [WALL, FAR_L], rotation=False)
    chain = _chain(CEILING, {"pair": PAIR}, FLOOR, LEFT_SIDE)
    return _certificate(scene, SQUARE, {"0": [WALL]}, **chain)


def bounded_chain() -> tuple[Json, Json]:
    """A block that bounds of the reference point make a wall; the ring round it is not needed."""
    block = rectangle(4.5, 1, 5.5, 3)
    scene = _scene(SQUARE, [block], rotation=False, reference_bounds=[1, 0.75, 9, 3.25])
    chain = _chain(CEILING, LEFT_SIDE, FLOOR, {"pair": PAIR})
    return _certificate(scene, SQUARE, {"0": [block]}, **chain)


def exact_gate(**fields: Any) -> tuple[Json, Json]:
    """Through a gate as high as the square, which touches both blocks on its way."""
    below, above = rectangle(4, 0, 6, 0.5), rectangle(4, 1.5, 6, 4)
    scene = _scene(SQUARE, [below, above], **fields)
    lines = [[0, 0, 0, 0, "right"], [0, 0, 1, 0, "left"]]
    return _certificate(
        scene,
        SQUARE,
        {"0": [below], "1": [above]},
        verdict="path",
        contact_tolerance=0.0,
        waypoints=[[2, 1, 0, 0], [5, 1, 0, 0], [8, 1, 0, 0]],
        segments=[
            [{**_interval(0, 1), "along": lines}],
            [_interval(0, 1, [0, 0, 0, 0, "obstacle", 2], [0, 0, 1, 0, "robot", 2])],
        ],
    )


def fixed_exact_gate() -> tuple[Json, Json]:
    """The same without turning."""
    return exact_gate(rotation=False)


BAR = rectangle(-0.5, -1, 0.5, 1)
"""As wide as the square, and twice as high; at a quarter turn it is as high as the square."""


def turned_gate() -> tuple[Json, Json]:
    """Through the gate with the bar, which fits at a quarter turn only."""
    below, above = rectangle(4, 0, 6, 0.5), rectangle(4, 1.5, 6, 4)
    scene = _scene(BAR, [below, above], start=[2, 1, pi / 2], goal=[8, 1, 5 * pi / 2])
    return _certificate(
        scene,
        BAR,
        {"0": [below], "1": [above]},
        verdict="path",
        contact_tolerance=0.0,
        waypoints=[[2, 1, pi / 2, 0], [8, 1, pi / 2, 0]],
        # The bar's right side, edge 1, is above it then.
        segments=[[_interval(0, 1, [0, 0, 0, 0, "obstacle", 2], [0, 0, 1, 0, "robot", 1])]],
    )


def turned_chain() -> tuple[Json, Json]:
    """The bar at three quarter turns, which may not turn, between walls it just does not pass."""
    below, above = rectangle(4, 0, 6, 0.5), rectangle(4, 1.5 - 2**-30, 6, 4)
    ends = {"start": [2, 1, 3 * pi / 2], "goal": [8, 1, 3 * pi / 2]}
    scene = _scene(BAR, [below, above], rotation=False, **ends)
    chain = _chain(CEILING, {"pair": [0, 0, 1, 0]}, {"pair": PAIR}, FLOOR, LEFT_SIDE)
    return _certificate(scene, BAR, {"0": [below], "1": [above]}, **chain)


def decimal_gate() -> tuple[Json, Json]:
    """A gate of 0.1 for a square of 0.1: in doubles, 0.3 + 0.1 is more than 0.4."""
    square = rectangle(0, 0, 0.1, 0.1)
    below, above = rectangle(0.4, 0, 0.6, 0.3), rectangle(0.4, 0.4, 0.6, 0.9)
    ends = {"start": [0.1, 0.3, 0], "goal": [0.8, 0.3, 0]}
    scene = _scene(square, [below, above], workspace={"box": [0, 0, 1, 0.9]}, **ends)
    return _certificate(
        scene,
        rectangle(0, 0, 1, 1),
        {"0": [rectangle(4, 0, 6, 3)], "1": [rectangle(4, 4, 6, 9)]},
        decimal_places=1,
        verdict="path",
        contact_tolerance=0.0,
        waypoints=[[1, 3, 0, 0], [8, 3, 0, 0]],
        segments=[[_interval(0, 1, [0, 0, 0, 0, "obstacle", 2], [0, 0, 1, 0, "robot", 2])]],
    )


def decimal_chain() -> tuple[Json, Json]:
    """The same for a square of 0.101 that may not turn, which does not pass."""
    square = rectangle(0, 0, 0.101, 0.101)
    below, above = rectangle(0.4, 0, 0.6, 0.3), rectangle(0.4, 0.4, 0.6, 0.9)
    ends = {"start": [0.1, 0.3, 0], "goal": [0.8, 0.3, 0], "rotation": False}
    scene = _scene(square, [below, above], workspace={"box": [0, 0, 1, 0.9]}, **ends)
    return _certificate(
        scene,
        rectangle(0, 0, 101, 101),
        {"0": [rectangle(400, 0, 600, 300)], "1": [rectangle(400, 400, 600, 900)]},
        decimal_places=3,
        **_chain(CEILING, {"pair": [0, 0, 1, 0]}, {"pair": PAIR}, FLOOR, LEFT_SIDE),
    )


HAND_MADE = {
    make.__name__: make
    for make in (
        fixed_wall,
        turning_wall,
        gap,
        disc,
        blocked_start,
        goal_in_wall,
        goal_out_of_bounds,
        over_block,
        bounded_path,
        fixed_path,
        bent_workspace,
        chained_wall,
        bounded_chain,
        exact_gate,
        fixed_exact_gate,
        turned_gate,
        turned_chain,
        decimal_gate,
        decimal_chain,
    )
}


def hand_made(name: str) -> tuple[Json, Json]:
    """Return scene and certificate, which the caller may change."""
    scene, certificate = HAND_MADE[name]()
    return copy.deepcopy(scene), copy.deepcopy(certificate)
