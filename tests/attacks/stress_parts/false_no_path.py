"""Limits never make a path disappear: no setting of any limit gives "no path" where there is one.

Planners that subdivide to a resolution ε and then say "no path" find one at a smaller ε: on the
bug trap of [SSS] none at ε = 5, one at ε = 4, in a world of 512. Here every scene with a path is
asked at many resolutions, the two among them, and with tiny cell, time and memory limits; on a
planner of its own each time, and again and again on one that keeps the cells of coarser queries.
"""

from __future__ import annotations

import random
from collections.abc import Iterator

from attacks.stress_parts.common import Row, Settings, expect, kept
from planar_planner import Options, load_scene
from planar_planner.scene.builtin import manifest
from scenarios import bug_trap
from worlds.critical import families
from worlds.scene import Scene, plain

PART = "false none"
SSS_WORLD = 512.0  # [SSS] states ε in a square world of this side
SSS_EPSILONS = (8.0, 6.0, 5.0, 4.5, 4.0, 3.0, 2.0, 1.0)
NECKS = (0.8, 0.6, 0.51, 0.501, 0.5001, 0.500001, 0.50000001)
FULL, QUICK = 60, 12  # values of each limit


def run(settings: Settings) -> list[Row]:
    """Sweep the limits over scenes with a path, and over some without."""
    rows: dict[str, Row] = {}
    for name, scene, truth, share in _scenes(settings):
        for limit, options in _limits(settings, share, name):
            case = f"{name}; {limit}"
            row = rows.setdefault(case, Row(PART, case))
            expect(settings, row, scene, {truth}, options)
        case = f"{name}; one planner, limits in any order"
        row = rows.setdefault(case, Row(PART, case))
        query = kept(settings, scene)
        for _, options in _shuffled(settings, share, name):
            expect(settings, row, scene, {truth}, options, query=query)
    return list(rows.values())


def _scenes(settings: Settings) -> Iterator[tuple[str, Scene, str, float]]:
    """Yield name of the row, scene, truth, and the share of all values of a limit to try."""
    for neck in NECKS[: settings.most]:
        yield (
            "bug trap",
            {**plain(bug_trap.bug_trap(neck)), "name": f"bug-trap-{neck}"},
            "path",
            1.0,
        )
    shipped = [(name, str(entry["expected"])) for name, entry in manifest().items()]
    for name, truth in shipped[: settings.most]:
        row = "shipped, with a path" if truth == "path" else "shipped, without"
        yield row, load_scene(name).to_dict(), truth, 0.3
    for family in list(families())[: settings.most]:
        for relative in (-1e-3, 1e-3, -1e-6, 1e-6):
            parameter = family.near(relative)
            if family.has_path(parameter):
                scene = {**family.make(parameter), "name": f"{family.name} at {parameter!r}"}
                yield "nearly critical, with a path", scene, "path", 0.1


def _shuffled(settings: Settings, share: float, name: str) -> list[tuple[str, Options]]:
    limits = list(_limits(settings, share, name))
    random.Random(f"{settings.seed} {name}").shuffle(limits)
    return limits


def _limits(settings: Settings, share: float, name: str) -> Iterator[tuple[str, Options]]:
    """Yield kinds of limits and options."""
    count = max(1, round(share * settings.count(FULL, QUICK)))
    rng = random.Random(f"{settings.seed} {name}")
    most = 5_000 if settings.quick else 20_000
    epsilons = [epsilon / SSS_WORLD for epsilon in SSS_EPSILONS[:count]]
    spread = [10.0 ** (-12.0 * (k + rng.random()) / count) for k in range(count)]
    for resolution in epsilons + spread:
        yield "resolution 1 ... 1e-12", Options(resolution=resolution, max_cells=most, timeout=5.0)
    for k in range(count):
        cells = int(10.0 ** (4.0 * (k + rng.random()) / count))
        yield "1 ... 10,000 cells", Options(max_cells=cells, timeout=5.0)
    for k in range(count):
        seconds = 10.0 ** (-6.0 + 5.0 * (k + rng.random()) / count)
        yield "1 us ... 0.1 s", Options(timeout=seconds, max_cells=most)
    for k in range(count):
        size = int(10.0 ** (7.0 * (k + rng.random()) / count))
        yield "1 B ... 10 MB of memory", Options(max_memory=size, max_cells=most, timeout=5.0)
