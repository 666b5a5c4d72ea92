"""Certificates of every shipped scene, through the command line and back; other queries too."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import pytest

from planar_planner.checker.verify import verify_certificate
from planar_planner.cli.main import main
from planar_planner.errors import CertificateRejected
from planar_planner.load import load_scene
from planar_planner.planning.certificate import make_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.planner import Planner
from planar_planner.problem.make import make_problem
from planar_planner.scene.builtin import builtin_scenes, manifest

SECONDS = {"gear-jammed": 10.0}  # at most; the others:
SECONDS_OTHERS = 60.0


@pytest.mark.parametrize("name", builtin_scenes())
def test_shipped_scenes(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(tmp_path / "certificate.json.gz")
    solved = main(["solve", name, "--certificate", file, "--quiet"])
    assert solved == {"path": 0, "no_path": 1}[manifest()[name]["expected"]]
    capsys.readouterr()
    began = time.monotonic()
    assert main(["verify", name, file, "--json", "-"]) == 0
    assert time.monotonic() - began < SECONDS.get(name, SECONDS_OTHERS)
    finding = json.loads(capsys.readouterr().out)
    assert (finding["finding"], finding["verdict"]) == ("valid", manifest()[name]["expected"])


def test_a_certificate_is_of_its_query_alone() -> None:
    planner = Planner(load_scene("gear"))
    there = planner.solve(certificate=True).certificate
    assert there is not None
    scene = load_scene("gear").to_dict()
    back = planner.solve(scene["goal"], scene["start"], certificate=True).certificate
    assert back is not None
    swapped = {**scene, "start": scene["goal"], "goal": scene["start"]}
    assert verify_certificate(scene, there).verdict == "path"
    assert verify_certificate(swapped, back).verdict == "path"
    for wrong in ((scene, back), (swapped, there)):
        with pytest.raises(CertificateRejected, match="scene"):
            verify_certificate(*wrong)


def test_ends_moved_off_contact_need_the_same_tolerance() -> None:
    scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 10]},
        "robot": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1]]]},
        "obstacles": [
            {"type": "Polygon", "coordinates": [[[4, 0], [5, 0], [5, 5], [4, 5]]]},
        ],
        "start": [3 + 2**-12, 2, 0],  # a little inside the obstacle
        "goal": [8, 3, 1],
    }
    result = Planner(load_scene(scene)).solve(
        options=Options(contact_tolerance=1e-3), certificate=True
    )
    certificate = result.certificate
    assert certificate is not None
    with pytest.raises(CertificateRejected, match="contact_tolerance"):
        verify_certificate(scene, certificate)
    assert verify_certificate(scene, certificate, contact_tolerance=1e-3).verdict == "path"


@pytest.mark.parametrize(
    ("changed", "place"),
    [
        ({"start": [4.5, 2, 0]}, "start"),
        ({"goal": [4.5, 2, 1]}, "goal"),
        ({"goal": [9.9, 2, 1]}, "goal"),
        ({"reference_bounds": [3, 1, 9, 9]}, "start"),
    ],
)
def test_ends_that_are_not_free(changed: dict[str, Any], place: str) -> None:
    """The planner refuses them; the core behind it answers, with a certificate."""
    square = {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1]]]}
    scene = {
        "format": "planar-planner/scene",
        "version": 1,
        "workspace": {"box": [0, 0, 10, 10]},
        "robot": square,
        "obstacles": [{"type": "Polygon", "coordinates": [[[4, 0], [5, 0], [5, 5], [4, 5]]]}],
        "start": [2, 2, 0],
        "goal": [8, 3, 1],
    } | changed
    problem = make_problem(load_scene(scene))
    core = make_core(problem)
    ask(core, problem, Options())
    certificate = make_certificate(problem, core.evidence(), 0.0)
    assert certificate is not None
    assert (certificate["claim"], certificate["end"]) == ("end", place)
    assert verify_certificate(scene, certificate).proof == "end"
