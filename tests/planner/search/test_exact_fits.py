"""Scenes that touch are decided exactly without turning, with certificates, as the cells do."""

from __future__ import annotations

import random
from collections import Counter
from typing import Any

import pytest

from planar_planner import DecidedBy, Options, SceneError, load_scene, solve, verify_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem

Content = dict[str, Any]
Ring = list[list[float]]
L_PIECE: Ring = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]
FEW = Options(max_cells=20_000)


def rectangle(x: float, y: float, width: float, height: float) -> Ring:
    return [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]


def polygon(ring: Ring) -> Content:
    return {"type": "Polygon", "coordinates": [ring]}


def scene(robot: Ring, obstacles: list[Ring], start: list[float], goal: list[float]) -> Content:
    return {
        "format": "planar-planner/scene",
        "version": 1,
        "robot": polygon(robot),
        "obstacles": [polygon(ring) for ring in obstacles],
        "start": [*start, 0],
        "goal": [*goal, 0],
    }


def puzzle(seed: int, *, slanted: bool = False) -> Content:
    """Return a random scene of small integers, in which most things touch."""
    draw = random.Random(seed)
    n = draw.randint(4, 9)

    def number(low: int, high: int) -> int:
        return draw.randint(low, high)

    def obstacle() -> Ring:
        if not slanted:
            return rectangle(number(0, n), number(0, n), number(1, 3), number(1, 3))
        while True:
            a, b, c = ([number(0, n), number(0, n)] for _ in range(3))
            if (b[0] - a[0]) * (c[1] - a[1]) != (b[1] - a[1]) * (c[0] - a[0]):
                return [a, b, c]

    robot = draw.choice([rectangle(0, 0, 1, 1), rectangle(0, 0, 2, 1), L_PIECE])
    obstacles = [obstacle() for _ in range(number(2, n * n // 4))]
    ends = [[number(0, n - 1), number(0, n - 1)] for _ in range(2)]
    content = scene(robot, obstacles, *ends) | {"rotation": draw.random() < 0.3}
    if draw.random() < 0.3:
        content["reference_bounds"] = [0, 0, number(n - 2, n), number(n - 2, n)]
    if draw.random() < 0.2:
        ring = [[0, 0], [n, 0], [n, n - 2], [n - 1, n], [0, n]]
        return content | {"workspace": polygon(ring)}
    return content | {"workspace": {"box": [0, 0, n, n]}}


@pytest.mark.parametrize("slanted", [False, True])
def test_random_puzzles_are_certified_and_never_against_the_cells(slanted: bool) -> None:
    found: Counter[tuple[str, object]] = Counter()
    for seed in range(2000 if slanted else 700):
        loaded = load_scene(puzzle(seed, slanted=slanted))
        try:
            result = solve(loaded, FEW, certificate=True)
        except SceneError:  # an end collides
            continue
        found[result.verdict, result.stats.decided_by or result.stop_reason] += 1
        if result.certificate is not None:
            verify_certificate(loaded, result.certificate)
        problem = make_problem(loaded)
        cells = ask(make_core(problem, without=["layers"]), problem, FEW)["verdict"]
        assert "undecided" in (cells, result.verdict) or cells == result.verdict, seed
    decided = sum(n for (verdict, _), n in found.items() if verdict != "undecided")
    assert decided >= 0.97 * found.total() and found.total() > 60
    assert found["path", DecidedBy.TAUT_PATH] > 20
    assert found["no_path", DecidedBy.ODD_CHAIN] >= 2


CORRIDOR = [rectangle(2, 0, 6, 1), rectangle(2, 2, 6, 3)]


def corridor(upper: float) -> Content:
    """Return a corridor as high as the block in it, but for where its upper wall begins."""
    walls = [CORRIDOR[0], rectangle(2, upper, 6, 3)]
    content = scene(rectangle(0, 0, 1, 1), walls, [0, 1], [9, 1])
    return content | {"workspace": {"box": [0, 0, 10, 5]}, "rotation": False}


@pytest.mark.parametrize(
    ("upper", "verdict"),
    [(2.0, "path"), (2.0 - 2**-52, "no_path"), (2.0 + 2**-51, "path"), (2.0 - 2**-20, "no_path")],
)
def test_an_ulp_decides(upper: float, verdict: str) -> None:
    loaded = load_scene(corridor(upper))
    result = solve(loaded, certificate=True)
    assert result.verdict == verdict
    assert result.certificate is not None
    assert verify_certificate(loaded, result.certificate).verdict == verdict


def test_a_slit_between_two_corners_is_passed() -> None:
    """The free translations are two squares that have one point in common."""
    walls = [rectangle(0, 3, 3, 3), rectangle(4, 0, 3, 2)]
    content = scene(rectangle(0, 0, 1, 1), walls, [0, 1], [5, 4])
    loaded = load_scene(content | {"workspace": {"box": [0, 0, 7, 6]}, "rotation": False})
    result = solve(loaded, certificate=True)
    assert result.verdict == "path"
    assert [3, 2] in result.path[:, :2].tolist()
    assert result.certificate is not None
    verify_certificate(loaded, result.certificate)


@pytest.mark.parametrize("rotation", [True, False])
def test_a_locked_block_has_no_way_out(rotation: bool) -> None:
    frame = [
        rectangle(0, 0, 3, 1),
        rectangle(0, 2, 3, 1),
        rectangle(0, 1, 1, 1),
        rectangle(2, 1, 1, 1),
    ]
    content = scene(rectangle(0, 0, 1, 1), frame, [1, 1], [4, 1]) | {"rotation": rotation}
    loaded = load_scene(content | {"workspace": {"box": [0, 0, 6, 4]}})
    result = solve(loaded, certificate=True)
    assert result.verdict == "no_path"
    assert result.certificate is not None
    verify_certificate(loaded, result.certificate)


def test_numbers_without_a_common_lattice_are_left_to_the_cells() -> None:
    content = corridor(2.0)
    content["start"] = [1e-30, 1, 0]
    assert solve(load_scene(content)).verdict == "undecided"


@pytest.mark.parametrize("size", [12, 31])
def test_a_maze_of_exact_fits(size: int) -> None:
    """A comb of walls with gaps as wide as the block, alternately at top and bottom."""
    walls = [rectangle(2 * k + 1, k % 2, 1, size - 1) for k in range(size)]
    content = scene(rectangle(0, 0, 1, 1), walls, [0, 0], [2 * size, 0])
    loaded = load_scene(content | {"workspace": {"box": [0, 0, 2 * size + 1, size]}})
    result = solve(loaded, certificate=True)
    assert result.verdict == "path"
    assert result.certificate is not None
    verify_certificate(loaded, result.certificate)
