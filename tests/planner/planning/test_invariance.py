"""What must not change a verdict: where the scene lies, how it is drawn, which end is the start."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import shapely

from planar_planner import Options, solve
from worlds import simple_maps as maps
from worlds.maps import exchanged
from worlds.random_scenes import blob, random_scene
from worlds.scene import Scene, plain

OPTIONS = Options(max_cells=50_000)
SEEDS = range(400, 440)

# A quarter turn and a mirror keep the coordinates exactly; the others round them.
CHANGES: dict[str, Callable[[Scene], Scene]] = {
    "world turned": maps.quarter_turned,
    "robot redrawn": maps.turned_body,
    "mirrored": maps.mirrored,
    "moved": lambda scene: maps.translated(scene, (1234.5, -777.25)),
    "moved far": lambda scene: maps.translated(scene, (-1e6, 1e6)),
    "in thousandths": lambda scene: maps.scaled(scene, 1e-3),
    "in millions": lambda scene: maps.scaled(scene, 1e6),
    "ends exchanged": exchanged,
    "goal wound": maps.wound,
}


@pytest.fixture(scope="module")
def verdicts() -> dict[int, str]:
    """Verdicts of the scenes as they are."""
    found: dict[int, str] = {seed: solve(random_scene(seed), OPTIONS).verdict for seed in SEEDS}
    assert {"path", "no_path"} <= set(found.values())
    return found


@pytest.mark.parametrize("change", CHANGES)
def test_verdict_is_kept_or_left_open(change: str, verdicts: dict[int, str]) -> None:
    open_ones = 0
    for seed, verdict in verdicts.items():
        changed = solve(CHANGES[change](random_scene(seed)), OPTIONS)
        open_ones += changed.verdict == "undecided"
        assert changed.verdict in {verdict, "undecided"}, (seed, verdict)
    assert open_ones <= 1  # these scenes are not tight


def gate(width: float, obstacles: list[dict[str, Any]], robot: dict[str, Any]) -> Scene:
    """A wall across a room with a gate; narrower gates are larger obstacles."""
    walls = [
        shapely.box(5.0, 0.0, 5.5, 5.0 - 0.5 * width),
        shapely.box(5.0, 5.0 + 0.5 * width, 5.5, 10.0),
    ]
    scene: Scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "name": "gate",
        "description": "A gate.",
        "workspace": {"box": [0.0, 0.0, 10.0, 10.0]},
        "robot": robot,
        "obstacles": [*(shapely.geometry.mapping(wall) for wall in walls), *obstacles],
        "start": [2.0, 5.0, 0.3],
        "goal": [8.0, 5.0, -0.4],
    }
    return plain(scene)


@pytest.mark.parametrize("seed", range(4))
def test_verdicts_are_monotone_in_a_gate(seed: int) -> None:
    """Nested scenes: once there is a path, every wider gate has one too."""
    rng = np.random.default_rng(seed)
    robot = shapely.geometry.mapping(blob(rng, 1.5, convex=seed % 2 == 0))
    low, high = 1e-3, 4.0
    assert solve(gate(low, [], robot), OPTIONS).verdict == "no_path"
    assert solve(gate(high, [], robot), OPTIONS).verdict == "path"
    seen: list[tuple[float, str]] = []
    while high - low > 1e-3:
        middle = 0.5 * (low + high)
        verdict = solve(gate(middle, [], robot), OPTIONS).verdict
        seen.append((middle, verdict))
        if verdict == "undecided":
            break
        low, high = (low, middle) if verdict == "path" else (middle, high)
    widths = [
        *rng.uniform(0.1, 4.0, 12),
        *(high + 0.02 * rng.random(3)),
        *(low - 0.02 * rng.random(3)),
    ]
    seen += [(w, solve(gate(w, [], robot), OPTIONS).verdict) for w in widths]
    widest_closed = max(w for w, verdict in seen if verdict == "no_path")
    narrowest_open = min(w for w, verdict in seen if verdict == "path")
    assert widest_closed < narrowest_open
