"""What is scaled: each family with its values, and the scene of a value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from scenarios import corner, field, gear, maze
from scenarios.model import Scene
from worlds import growing as worlds

# Bracketed to [1.663358689789, 1.663358689845] by bench/families.py.
GEAR_CRITICAL = 1.663358689817
NEAR_FIELD = 400  # obstacles of the field beside which the irrelevant ones lie
MAZE_SEEDS = (14, 15, 16)


@dataclass(frozen=True)
class Family:
    """Scenes of one parameter.

    Attributes
    ----------
    name, parameter : str
        What is measured, and what grows.
    values : tuple of float
        Ascending; `quick` of them in a quick run.
    make : callable
        Scene of a value.
    expected : str
        The true verdict of all.
    logarithmic : bool
        Growth is expected with the logarithm of the value: also fitted per decade.
    """

    name: str
    parameter: str
    values: tuple[float, ...]
    quick: int
    make: Callable[[float], Scene]
    expected: str = "path"
    logarithmic: bool = False


def _decades(first: int, last: int) -> tuple[float, ...]:
    """Return 1 and 3 times powers of ten."""
    steps = [s * 10.0**k for k in range(first, last) for s in (1.0, 3.0)]
    return (*steps, 10.0**last)


def _whole(make: Callable[[int], Scene]) -> Callable[[float], Scene]:
    return lambda value: make(int(value))


def _clearance(make: Callable[[float], Scene], critical: float, sign: int) -> Any:
    """Return scenes of 1 / clearance."""
    return lambda inverse: make(critical + sign / inverse)


def families() -> list[Family]:
    """Return all of them, in the order in which they are run."""
    inverses = tuple(10.0**k for k in range(1, 10))
    corner_critical = corner.critical_length(corner.DEFAULT_WIDTH)
    pieces = (1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0)
    clearances = [
        Family(f"{name}, {verdict}", "1 / clearance", inverses, 5, make, verdict, True)
        for name, verdict, make in (
            ("corner", "path", _clearance(corner.corner, corner_critical, -1)),
            ("corner", "no_path", _clearance(corner.corner, corner_critical, 1)),
            ("gear", "path", _clearance(gear.gear, GEAR_CRITICAL, 1)),
            ("gear", "no_path", _clearance(gear.gear, GEAR_CRITICAL, -1)),
        )
    ]
    mazes = [
        Family(
            f"maze, seed {seed}",
            "side, cells of the maze",
            (4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0),
            4,
            _whole(partial(_maze, seed)),
        )
        for seed in MAZE_SEEDS
    ]
    return [
        Family("fixed channel", "obstacles", _decades(1, 5), 4, _whole(worlds.fixed_channel)),
        Family("growing channel", "obstacles", _decades(1, 5), 4, _whole(worlds.growing_channel)),
        Family("field", "obstacles", _decades(1, 5), 4, _whole(field.field)),
        Family("irrelevant", "far obstacles", _decades(1, 5), 4, _whole(_irrelevant)),
        Family("robot", "pieces", pieces, 4, _whole(partial(_toothed, 1.6))),
        Family("robot too long", "pieces", pieces, 4, _whole(partial(_toothed, 2.8)), "no_path"),
        *mazes,
        *clearances,
    ]


def _maze(seed: int, size: int) -> Scene:
    return maze.maze(size, seed)


def _irrelevant(far: int) -> Scene:
    return field.field(NEAR_FIELD, far=far)


def _toothed(length: float, pieces: int) -> Scene:
    return worlds.toothed(pieces, length)
