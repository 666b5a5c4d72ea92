"""Random puzzles in which most things touch: ``python tests/attacks/exact_fits.py``.

Robots that may not turn, at the four quarter turns: every verdict is compared with a flood fill in
fractions, on integer grids, with one coordinate off by a last place or by 2^-k, on decimal grids
far from the origin, and turned, mirrored or scaled by a power of two. Certificates are checked.
Robots that may turn, with ends at any angle: certificates are checked, a verdict may not change if
the whole scene is turned or mirrored, and the share that is decided is counted.

Options: ``--scenes 100000 --turning 400 --first 0 --certified 0.05``.
"""

from __future__ import annotations

import argparse
import math
import random
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

sys.path.extend(str(Path(__file__).resolve().parents[k]) for k in (1, 2))  # tests and scenarios

from oracles.rectilinear import is_joined
from planar_planner import Options, SceneError, load_scene, solve, verify_certificate

Content = dict[str, Any]
Ring = list[list[Any]]
ROBOTS: dict[str, Ring] = {
    "square": [[0, 0], [1, 0], [1, 1], [0, 1]],
    "bar": [[0, 0], [2, 0], [2, 1], [0, 1]],
    "L": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]],
}
ENDS = ("start", "goal")
FEW = Options(max_cells=20_000)


def polygon(ring: Ring) -> Content:
    return {"type": "Polygon", "coordinates": [ring]}


def rectangle(x: float, y: float, width: float, height: float) -> Ring:
    return [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]


def puzzle(draw: random.Random) -> Content:
    """Return a scene of small integers; its robot may not turn, and mostly its ends are free.

    Half of them are drawn until there is no path, if that comes about soon.
    """
    n = draw.randint(4, 9)
    obstacles = [
        rectangle(draw.randint(0, n), draw.randint(0, n), draw.randint(1, 3), draw.randint(1, 3))
        for _ in range(draw.randint(2, n * n // 4))
    ]
    content: Content = {
        "format": "planar-planner/scene",
        "version": 1,
        "robot": polygon(draw.choice(list(ROBOTS.values()))),
        "obstacles": [polygon(ring) for ring in obstacles],
        "workspace": {"box": [0, 0, n, n]},
        "rotation": False,
    }
    wanted = {False} if draw.random() < 0.5 else {False, True}
    for _ in range(12):
        ends = {end: [draw.randint(0, n - 1), draw.randint(0, n - 1), 0] for end in ENDS}
        if is_joined({**content, **ends}) in wanted:
            break
    return {**content, **ends}


def mapped(content: Content, of_point: Callable[[Any, Any], list[Any]]) -> Content:
    """Return the scene with a map of the plane applied to obstacles, workspace and ends."""
    x0, y0, x1, y1 = content["workspace"]["box"]
    (a, b), (c, d) = of_point(x0, y0), of_point(x1, y1)
    return {
        **content,
        "obstacles": [
            polygon([of_point(x, y) for x, y in o["coordinates"][0]]) for o in content["obstacles"]
        ],
        "workspace": {"box": [min(a, c), min(b, d), max(a, c), max(b, d)]},
        "start": [*of_point(*content["start"][:2]), content["start"][2]],
        "goal": [*of_point(*content["goal"][:2]), content["goal"][2]],
    }


def with_robot(content: Content, of_point: Callable[[Any, Any], list[Any]]) -> Content:
    ring = content["robot"]["coordinates"][0]
    return {**content, "robot": polygon([of_point(x, y) for x, y in ring])}


def quarter(x: Any, y: Any) -> list[Any]:
    return [-y, x]


def turned(content: Content, quarters: int) -> Content:
    """Return the scene turned as a whole; the robot is the same, at another angle."""
    for _ in range(quarters):
        content = mapped(content, quarter)
    angle = 90 * quarters
    return {**content, **{e: [*content[e][:2], _more(content[e][2], angle)] for e in ENDS}}


def _more(theta: Any, degrees: int) -> Any:
    """Return an angle turned on: exactly, if it is written in degrees."""
    if theta == 0 or isinstance(theta, str):
        own = 0 if theta == 0 else int(theta.removesuffix("deg"))
        return f"{own + degrees}deg"
    return theta + math.radians(degrees)


def at_quarters(content: Content, quarters: int) -> Content:
    """Return the same free set of a robot that is drawn turned back and placed turned."""
    for _ in range(quarters):
        content = with_robot(content, lambda x, y: [y, -x])
    return {**content, **{e: [*content[e][:2], f"{90 * quarters}deg"] for e in ENDS}}


def nudged(content: Content, draw: random.Random) -> Content:
    """Return the scene with one coordinate of an obstacle a little off; doubles are meant."""
    made = mapped(content, lambda x, y: [float(x), float(y)])
    ring = draw.choice(made["obstacles"])["coordinates"][0]
    axis = draw.randrange(2)
    value = draw.choice(ring)[axis]
    by = draw.choice([math.ulp(max(value, 1.0)), 2.0 ** -draw.randint(20, 50)]) * draw.choice(
        [-1, 1]
    )
    for point in ring:
        if point[axis] == value:
            point[axis] = value + by
    return {**made, "numbers": "doubles"}


def decimal(content: Content, draw: random.Random) -> tuple[Content, int]:
    """Return the scene on a decimal grid somewhere else, and its decimal places."""
    places, dx, dy = draw.randint(1, 4), draw.randint(0, 10**5), draw.randint(-(10**3), 10**3)

    def number(value: int) -> float:
        return float(Fraction(value, 10**places))

    moved = mapped(content, lambda x, y: [number(x + dx), number(y + dy)])
    return with_robot(moved, lambda x, y: [number(x), number(y)]), places


def verdict_of(content: Content, certified: bool) -> bool | None:
    """Return whether there is a path; None if an end is not free. Undecided is an error here."""
    scene = load_scene(content)
    try:
        result = solve(scene, certificate=certified)
    except SceneError as error:
        if "collides" in str(error) or "outside the workspace" in str(error):
            return None
        raise
    if result.certificate is not None:
        verify_certificate(scene, result.certificate)
    if result.verdict == "undecided":
        raise AssertionError(f"undecided: {result.reason}")
    return result.verdict == "path"


def attack_fixed(seed: int, share_certified: float) -> list[str]:
    """Return what was compared, by kind and answer; raise where an answer is wrong."""
    draw = random.Random(seed)
    content = puzzle(draw)
    truth = is_joined(content)
    near = nudged(content, draw)
    grid, places = decimal(content, draw)
    k = draw.randrange(4)
    tried = {
        "integers": (content, truth),
        "quarter turns": (at_quarters(content, k), truth),
        "off by little": (near, is_joined(near)),
        "decimals": (grid, truth),
        "turned scene": (turned(content, k), truth),
        "mirrored": (
            with_robot(mapped(content, lambda x, y: [-x, y]), lambda x, y: [-x, y]),
            truth,
        ),
        "powers of two": (_scaled(content, 2.0 ** draw.randint(-40, 30)), truth),
    }
    assert is_joined(grid, places) == truth, seed
    done = []
    for kind, (scene, expected) in tried.items():
        try:
            found = verdict_of(scene, draw.random() < share_certified)
        except Exception as error:
            raise AssertionError(f"seed {seed}, {kind}: {error}") from error
        if found != expected:
            raise AssertionError(f"seed {seed}, {kind}: {found}, but the oracle says {expected}")
        done.append(f"{kind}: {NAMES[found]}")
    return done


NAMES = {True: "path", False: "no path", None: "an end is not free"}


def _scaled(content: Content, by: float) -> Content:
    def scale(x: Any, y: Any) -> list[Any]:
        return [x * by, y * by]

    return with_robot(mapped(content, scale), scale)


def attack_region(seed: int) -> str:
    """Return how a puzzle whose goal is a region was decided; raise where that is wrong."""
    draw = random.Random(2 * 10**6 + seed)
    content = puzzle(draw)
    n = content["workspace"]["box"][2]
    rings = [
        rectangle(draw.randint(0, n - 1), draw.randint(0, n - 1), draw.randint(1, 3), 1)
        for _ in range(draw.randint(1, 2))
    ]
    shapes = [[ring] for ring in rings]
    content["goal"] = {"region": {"type": "MultiPolygon", "coordinates": shapes}}
    expected = is_joined(content)
    scene = load_scene(content)
    try:
        result = solve(scene, FEW, certificate=True)
    except SceneError:
        assert expected is None, f"region, seed {seed}: the start is free"
        return NAMES[None]
    if result.certificate is not None:
        verify_certificate(scene, result.certificate)
    if result.verdict != "undecided":
        assert (result.verdict == "path") == expected, f"region, seed {seed}: {result}"
        return NAMES[expected]
    return str(result.stop_reason)


def attack_turning(seed: int, angles: Sequence[Any]) -> str:
    """Return how a puzzle with a robot that may turn was decided, as it is and turned."""
    draw = random.Random(10**6 + seed)
    content = {**puzzle(draw), "rotation": True}
    for end in ENDS:
        content[end][2] = draw.choice(angles)
    found = []
    for scene in (content, turned(content, 1)):
        loaded = load_scene(scene)
        try:
            result = solve(loaded, FEW, certificate=True)
        except SceneError:
            return NAMES[None]
        if result.certificate is not None:
            verify_certificate(loaded, result.certificate)
        found.append(result)
    decided = {result.verdict for result in found} - {"undecided"}
    assert len(decided) <= 1, f"seed {seed}: {decided}"
    first = found[0]
    return str(first.stop_reason if first.verdict == "undecided" else first.verdict)


ANGLES: dict[str, list[Any]] = {
    "angle 0": [0],
    "quarter turns": [0, "90deg", "180deg", "270deg"],
    "any angle": [0, "90deg", 0.3, 1.0, -0.7, 2.5],
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the attack and print what was compared."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=100_000)
    parser.add_argument("--turning", type=int, default=400)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--certified", type=float, default=0.05)
    given = parser.parse_args(arguments)
    fixed: Counter[str] = Counter()
    for seed in range(given.first, given.first + given.scenes // 7 + 1):
        fixed.update(attack_fixed(seed, given.certified))
    for kind, count in sorted(fixed.items()):
        print(f"{count:8,}  {kind}")
    print(f"{fixed.total():,} scenes without turning: every answer is the oracle's")
    regions = Counter(attack_region(given.first + k) for k in range(given.turning))
    print(f"goal regions: no wrong answer; {dict(regions)}")
    for name, angles in ANGLES.items():
        found = Counter(attack_turning(given.first + k, angles) for k in range(given.turning))
        asked = found.total() - found[NAMES[None]]
        decided = found["path"] + found["no_path"]
        print(f"turning, ends at {name}: {decided} of {asked} decided; {dict(found)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
