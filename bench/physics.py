"""All shipped scenes before the Chipmunk physics engine: paths replayed, robots pushed.

``python bench/physics.py`` replays the path of every scene that has one, and pushes four robots for
twenty simulated seconds in every scene that has none. It asks Chipmunk about pairs of small integer
polygons, too, many of which touch exactly, and compares with ``pdg``, and about random
configurations in all scenes, and compares with the planner. It fails if a path is not witnessed, a
robot reaches its goal, or answers differ, and writes ``bench/results/physics_*.csv``.
"""

from __future__ import annotations

import math
import sys
import time
from collections import Counter

import numpy as np
from scipy.spatial import ConvexHull, QhullError

import pdg
from lib import provenance
from planar_planner import load_scene, solve
from planar_planner.physics import push, replay
from planar_planner.physics.contacts import reported, touched
from planar_planner.physics.replay import outside, problem_of
from planar_planner.physics.world import engine_name, make_world, rounding
from planar_planner.planning.engine import make_core
from planar_planner.problem.make import ends
from worlds.shipped import with_point_goals

SECONDS, TRIES, SEED = 20.0, 4, 0
PAIRS, PLACES = 400, 150
CONFIGURATIONS = 1000  # in each scene
NEAR = 1e-7  # of the polygons' extent of 8: above what asking aside leaves open, 2^-30 of the reach
QUARTERS = (0.0, math.pi / 2, math.pi, -math.pi / 2)


def replays() -> tuple[list[list[object]], list[str]]:
    """Return a row for each scene with a path, and the scenes whose path is not witnessed."""
    rows: list[list[object]] = []
    failed = []
    for name, entry in with_point_goals().items():
        if entry["expected"] != "path":
            continue
        result = solve(load_scene(name))
        began = time.perf_counter()
        found = replay(name, result.path)
        seconds = time.perf_counter() - began
        rows.append(
            [
                name,
                len(found.configurations),
                f"{found.step:.3g}",
                len(found.contacts),
                f"{found.deepest:.3g}",
                f"{found.accuracy:.2g}",
                found.doubted,
                f"{result.stats['least_clearance']:.3g}",
                f"{seconds:.2f}",
            ]
        )
        print(*rows[-1], flush=True)
        if not found.witnessed:
            failed.append(f"{name}: not witnessed")
    return rows, failed


def pushes() -> tuple[list[list[object]], list[str]]:
    """Return a row for each scene without a path, and the scenes where a robot reached its goal."""
    rows: list[list[object]] = []
    failed = []
    for name, entry in with_point_goals().items():
        if entry["expected"] != "no_path":
            continue
        began = time.perf_counter()
        found = push(name, seconds=SECONDS, tries=TRIES, seed=SEED)
        seconds = time.perf_counter() - began
        rows.append(
            [
                name,
                f"{found.distance:.3g}",
                f"{min(run.nearest for run in found.tries):.3g}",
                f"{max(run.farthest for run in found.tries):.3g}",
                f"{sum(run.length for run in found.tries):.3g}",
                f"{found.deepest:.2g}",
                f"{found.step:.2g}",
                f"{found.thinnest:.2g}",
                sum(run.undone for run in found.tries),
                "yes" if found.reached else "no",
                f"{seconds:.1f}",
            ]
        )
        print(*rows[-1], flush=True)
        if found.reached or found.may_have_tunnelled:
            failed.append(f"{name}: a robot reached its goal, or may have tunnelled")
    return rows, failed


def polygon(random: np.random.Generator) -> np.ndarray:
    """Return a convex polygon with corners on a grid of 9 by 9."""
    while True:
        points = random.integers(-4, 5, size=(random.integers(3, 8), 2)).astype(float)
        try:
            return np.array(points[ConvexHull(points).vertices])
        except QhullError:
            continue


def judgements() -> tuple[list[list[object]], list[str]]:
    """Count Chipmunk's wrong answers about integer polygons, asked once and asked aside."""
    random = np.random.default_rng(3)
    counts: Counter[tuple[str, str]] = Counter()
    for _ in range(PAIRS):
        robot, obstacle = polygon(random), polygon(random)
        rings = [[*ring.tolist(), ring[0].tolist()] for ring in (robot, obstacle)]
        scene = {
            "format": "planar-planner/scene",
            "version": 1,
            "robot": {"type": "Polygon", "coordinates": [rings[0]]},
            "obstacles": [{"type": "Polygon", "coordinates": [rings[1]]}],
            "reference_bounds": [-50, -50, 50, 50],
            "start": [30, 30, 0],
            "goal": [40, 40, 0],
        }
        world = make_world(problem_of(scene), dynamic=False)
        for _ in range(PLACES):
            x, y = map(float, random.integers(-8, 9, size=2))
            q = (x, y, float(random.choice(QUARTERS)))
            depth = pdg.translational_depth(robot, obstacle, q).depth
            kind = "overlap" if depth > NEAR else "apart" if depth < -NEAR else "touch"
            counts[kind, "pairs"] += 1
            for how, answer in (("once", reported(world, q)), ("aside", touched(world, q)[0])):
                wrong = abs(max(answer.values(), default=0.0) - max(depth, 0.0)) > NEAR
                counts[kind, how] += wrong
    kinds = ("apart", "touch", "overlap")
    rows: list[list[object]] = [
        [kind, *(counts[kind, how] for how in ("pairs", "once", "aside"))] for kind in kinds
    ]
    for row in rows:
        print(*row)
    return rows, [f"{row[0]}: {row[3]} wrong answers" for row in rows if row[3]]


def placements() -> tuple[list[list[object]], list[str]]:
    """Compare with the planner whether the robot is free at random configurations."""
    random = np.random.default_rng(SEED)
    rows: list[list[object]] = []
    failed = []
    for name in with_point_goals():
        problem = problem_of(name)
        core, world = make_core(problem), make_world(problem, dynamic=False)
        at_ends = [q[:2] for q in ends(problem).values()]
        corners = np.concatenate([problem.obstacles.coords, at_ends])
        low, high = corners.min(axis=0), corners.max(axis=0)
        free = differ = 0
        for _ in range(CONFIGURATIONS):
            x, y = random.uniform(low, high).tolist()
            q = (x, y, random.uniform(-math.pi, math.pi) if problem.rotation else problem.start[2])
            ours = core.placement(q)["state"] in ("free", "touching")
            depth = max(touched(world, q)[0].values(), default=0.0)
            out = outside(problem.reference_bounds, np.array([q]))
            free += ours
            differ += ours != (max(depth, out) <= rounding(problem, np.array([q])))
        rows.append([name, CONFIGURATIONS, free, differ])
        print(*rows[-1], flush=True)
        if differ:
            failed.append(f"{name}: {differ} configurations judged otherwise by the planner")
    return rows, failed


def main() -> int:
    """Replay, push, judge, place, write."""
    facts = provenance.print_provenance() | {"engine": engine_name()}
    rows, failed = replays()
    header = ["scene", "configurations", "step", "touched", "deepest", "accuracy", "doubted"]
    provenance.write_csv("physics_replays.csv", facts, [*header, "clearance", "seconds"], rows)
    rows, more = pushes()
    failed += more
    header = ["scene", "distance", "nearest", "farthest", "travel", "deepest", "step", "thinnest"]
    provenance.write_csv(
        "physics_pushes.csv",
        facts | {"push": f"{TRIES} tries of {SECONDS:g} s, seed {SEED}"},
        [*header, "undone", "reached", "seconds"],
        rows,
    )
    rows, more = judgements()
    failed += more
    header = ["kind", "pairs", "wrong_asked_once", "wrong_asked_aside"]
    provenance.write_csv("physics_judgements.csv", facts, header, rows)
    rows, more = placements()
    failed += more
    header = ["scene", "configurations", "free", "judged_otherwise"]
    provenance.write_csv("physics_placements.csv", facts, header, rows)
    print(*failed or ["all as it should be"], sep="\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
