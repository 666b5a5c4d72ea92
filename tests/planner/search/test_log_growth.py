"""Cells grow with the logarithm of the clearance, on both sides of a critical parameter."""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest

from planar_planner import DecidedBy, Options, load_scene, solve, verify_certificate

CLEARANCES = (1e-2, 1e-4, 1e-6, 1e-8)


def box(x0: float, y0: float, x1: float, y1: float) -> dict[str, Any]:
    ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]
    return {"type": "Polygon", "coordinates": [ring]}


def scene(**parts: Any) -> dict[str, Any]:
    return {"format": "planar-planner/scene", "version": 1, **parts}


def gate(clearance: float) -> dict[str, Any]:
    """A 3 x 1 rectangle and a gate 2 long, wider than the rectangle by `clearance`."""
    half = (1.0 + clearance) / 2
    return scene(
        workspace={"box": [0, 0, 20, 10]},
        robot=box(-1.5, -0.5, 1.5, 0.5),
        obstacles=[box(9, -1, 11, 5 - half), box(9, 5 + half, 11, 11)],
        start=[4, 5, 0.3],
        goal=[16, 5, 0.3],
    )


def corner(clearance: float) -> dict[str, Any]:
    """A rectangle 0.1 wide round a right-angled corner, shorter than critical by `clearance`."""
    length = 2 * (math.sqrt(2) - 0.1) - clearance
    return scene(
        workspace={"box": [0, 0, 4, 4]},
        robot=box(-length / 2, -0.05, length / 2, 0.05),
        obstacles=[box(1, 1, 4, 4)],
        start=[0.5, 2.5, -math.pi / 2],
        goal=[2.5, 0.5, 0],
    )


@pytest.mark.parametrize("family", [gate, corner])
@pytest.mark.parametrize(("side", "verdict"), [(1, "path"), (-1, "no_path")])
def test_cells_grow_by_steps_not_by_factors(family: Any, side: int, verdict: str) -> None:
    cells = []
    for clearance in CLEARANCES:
        result = solve(load_scene(family(side * clearance)), Options(resolution=1e-12))
        assert result.verdict == verdict, clearance
        cells.append(result.stats.cells)
    # Two more decimals cost about the same number of cells each time; a power law would make each
    # step ten times the one before (or a hundred times).
    steps = [after - before for before, after in itertools.pairwise(cells)]
    assert max(steps) < 2000, cells
    assert cells[-1] < 4000, cells


@pytest.mark.parametrize("gap", [1.5, 1.1, 1.02])
def test_contact_on_a_cell_boundary_starves_no_other_channel(gap: float) -> None:
    # The contact surface y = 5 lies on a boundary of cells: those below it stay mixed for ever, and
    # a channel along them must not outbid the open gate just above.
    content = scene(
        rotation=False,
        workspace={"box": [0, 0, 10, 10]},
        robot=box(-0.5, -0.5, 0.5, 0.5),
        obstacles=[box(4.5, 0, 5.5, 4.5), box(4.5, 4.5 + gap, 5.5, 10)],
        start=[2, 2, 0],
        goal=[8, 2, 0],
    )
    result = solve(load_scene(content))
    assert result.verdict == "path"
    assert result.stats.cells < 2000


def test_exactly_fitting_gate_is_passed_by_turning_before_and_after() -> None:
    """A robot that has to turn on its way through a gate that fits at one angle only."""
    scene = load_scene({**gate(0.0), "start": [4, 5, 0.3], "goal": [16, 5, 0.3]})
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert result.stats.decided_by is DecidedBy.JOINED_LAYERS
    assert result.stats.cells < 5000
    assert result.certificate is not None
    verify_certificate(scene, result.certificate)


@pytest.mark.parametrize("rotation", [True, False])
def test_exactly_fitting_gate_is_passed_without_turning(rotation: bool) -> None:
    content = {**gate(0.0), "rotation": rotation, "start": [4, 5, 0], "goal": [16, 5, 0]}
    scene = load_scene(content)
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert result.stats.cells < 5000
    assert result.certificate is not None
    verify_certificate(scene, result.certificate)
