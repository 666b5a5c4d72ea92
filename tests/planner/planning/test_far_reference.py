"""Robots whose reference point lies far from their body: the same answers at the same cost."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planar_planner import (
    CertificateError,
    CertificateRejected,
    Options,
    Planner,
    load_scene,
    solve,
    verify_certificate,
)
from planar_planner.explain.about_point import path_of_point
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem
from worlds.random_scenes import random_scene
from worlds.simple_maps import gridded, moved_origin

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
OPTIONS = Options(max_cells=50_000)
SEEDS = tuple(s for s in range(500, 540) if "reference_bounds" not in random_scene(s))


def far(distance: int, width: float) -> dict[str, Any]:
    content: dict[str, Any] = json.loads((FAULTS / f"far_{distance}_{width}.json").read_text())
    return content


@pytest.mark.parametrize("distance", [10, 100, 300, 1000])
def test_a_far_reference_point_costs_nothing(distance: int) -> None:
    near, scene = solve(far(0, 0.98)), far(distance, 0.98)
    result = solve(scene, certificate=True)
    assert result.verdict == near.verdict == "no_path"
    assert result.stats.labelled_cells <= 2 * near.stats.labelled_cells
    assert result.certificate is not None
    assert result.certificate["reference"] == [distance, 0.0]
    assert verify_certificate(scene, result.certificate).proof == "separation"


def test_a_way_of_a_far_reference_point_is_certified() -> None:
    scene = far(1000, 1.02)
    result = solve(scene, certificate=True)
    assert result.verdict == "path"
    assert np.array_equal(result.path[0], scene["start"])
    assert np.array_equal(result.path[-1][:2], scene["goal"][:2])
    assert result.stats.least_clearance > 0.005
    assert result.certificate is not None
    assert "reference" not in result.certificate  # the path is of the scene's own point
    assert verify_certificate(scene, result.certificate).verdict == "path"
    assert len(result.path) < 400  # about sqrt(1000) a radian, more where there is less room


@pytest.mark.parametrize("seed", SEEDS)
def test_verdicts_do_not_depend_on_the_origin(seed: int) -> None:
    """The slow oracle: the same scene with its origin on the body."""
    scene = gridded(random_scene(seed))
    expected = solve(scene, OPTIONS)
    for by in ((64.0, -16.0), (-4096.0, 1024.0)):
        moved = moved_origin(scene, by)
        result = solve(moved, OPTIONS, certificate=True)
        assert result.verdict == expected.verdict, by
        if result.certificate is not None:
            assert verify_certificate(moved, result.certificate).verdict == result.verdict


@pytest.mark.parametrize("seed", SEEDS[:8])
def test_answers_about_the_body_are_those_in_the_own_frame(seed: int) -> None:
    """The slow oracle: the same question without the shift; what it finds, both find."""
    problem = make_problem(load_scene(moved_origin(gridded(random_scene(seed)), (8.0, 6.0))))
    limits = Options(max_cells=200_000)
    own = ask(make_core(problem, ["shift"]), problem, limits)["verdict"]
    shifted = ask(make_core(problem), problem, limits)["verdict"]
    assert own in {shifted, "undecided"}


def test_a_path_is_certified_in_the_own_frame_too() -> None:
    scene = far(1000, 1.02)
    result = solve(scene, OPTIONS)
    core = make_core(make_problem(load_scene(scene)), ["shift"])
    assert core.check_path(result.path)["valid"]


@pytest.mark.parametrize("by", [(0.5, 0.0), (0.0, 1.0), (-1000.0, 0.0)])
def test_another_reference_in_the_certificate_is_rejected(by: tuple[float, float]) -> None:
    scene = far(1000, 0.98)
    certificate = copy.deepcopy(solve(scene, certificate=True).certificate)
    assert certificate is not None
    x, y = certificate["reference"]
    certificate["reference"] = [x + by[0], y + by[1]]
    with pytest.raises(CertificateRejected):
        verify_certificate(scene, certificate)


def test_a_path_names_no_reference() -> None:
    scene = far(1000, 1.02)
    certificate = copy.deepcopy(solve(scene, certificate=True).certificate)
    assert certificate is not None
    certificate["reference"] = [1000.0, 0.0]
    with pytest.raises(CertificateError):
        verify_certificate(scene, certificate)


@pytest.mark.parametrize("width", [0.98, 1.02])
def test_bounds_of_a_far_reference_point_are_kept(width: float) -> None:
    scene = {**far(1000, width), "reference_bounds": [-1200.0, -1200.0, 1200.0, 1200.0]}
    result = solve(scene, certificate=True)
    assert result.verdict == ("path" if width > 1 else "no_path")
    assert result.stats.labelled_cells < 2000
    assert result.certificate is not None
    assert verify_certificate(scene, result.certificate).verdict == result.verdict


def test_a_way_out_of_the_bounds_of_a_far_reference_point_is_not_taken() -> None:
    """There is a way for the body, but not within these bounds: the certificate counts them."""
    scene = far(1000, 1.02)
    (x, y, _), (u, v, _) = scene["start"], scene["goal"]
    scene["reference_bounds"] = [min(x, u) - 1, min(y, v) - 1, max(x, u) + 1, max(y, v) + 1]
    result = solve(scene, Options(max_cells=20_000), certificate=True)
    assert result.verdict == "no_path"
    assert result.certificate is not None
    assert "reference" not in result.certificate
    assert verify_certificate(scene, result.certificate).verdict == "no_path"


def test_cells_say_which_point_they_are_of() -> None:
    planner = Planner(far(100, 0.98))
    assert planner.solve().verdict == "no_path"
    cells, wall, bottleneck = planner.cells(), planner.wall(), planner.bottleneck()
    assert wall is not None
    assert bottleneck is not None
    assert cells.point == wall.point == (100.0, 0.0)
    middle = path_of_point(bottleneck.at[None, :], cells.point)[0]
    assert np.abs(middle[:2] - [3.5, 5.0]).max() < 1.5  # the body is in the door
    assert cells[:3].point == cells.point


def test_the_origin_of_a_body_that_holds_it_stays() -> None:
    planner = Planner("gear")
    planner.solve()
    assert planner.cells().point == (0.0, 0.0)


@pytest.mark.parametrize("tolerance", [0.0, 1e-3])
def test_a_contact_is_left(tolerance: float) -> None:
    scene = far(1000, 1.02)
    scene["start"] = [-999.4, 2.0, 0.0]  # the body, 1.2 wide, touches the left wall
    result = solve(scene, Options(contact_tolerance=tolerance), certificate=True)
    assert result.verdict == "path"
    assert result.certificate is not None
    assert verify_certificate(scene, result.certificate, tolerance).verdict == "path"
