"""A decided answer has a certificate, which the checker accepts; otherwise it is undecided."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from planar_planner import (
    CertificateRejected,
    Planner,
    StopReason,
    margin,
    solve,
    verify_certificate,
)
from planar_planner.cli.main import main

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"


def _scenes() -> list[dict[str, Any]]:
    single = [json.loads((FAULTS / f"nocert{n}.json").read_text()) for n in ("", "_straight")]
    return [*single, *json.loads((FAULTS / "nocert_more.json").read_text())]


@pytest.mark.parametrize("scene", _scenes())
def test_a_path_with_room_of_rounding_only(scene: dict[str, Any], tmp_path: Path) -> None:
    result = solve(scene, certificate=True)
    plain = solve(scene)
    assert plain.verdict == result.verdict, "whether a certificate is asked for changes nothing"
    if result.verdict == "undecided":
        assert result.stop_reason in (StopReason.NO_EVIDENCE, StopReason.RESOLUTION)
        assert result.certificate is None and not len(result.path)
        assert result.stats.decided_by is None and result.stats.waypoints == 0
        assert result.stats.path_length == 0.0 and result.least_clearance == 0.0
    else:
        assert result.certificate is not None
        assert verify_certificate(scene, result.certificate).verdict == result.verdict
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(scene))
    certificate = tmp_path / "certificate.json"
    status = main(["solve", str(file), "--certificate", str(certificate), "--quiet"])
    assert certificate.exists() == (status in (0, 1))


def test_all_are_decided() -> None:
    """Their evidence comes nearer to touching than rounding allows, so it is checked exactly."""
    results = [solve(scene, certificate=True) for scene in _scenes()]
    assert {result.verdict for result in results} == {"path"}


def test_close_evidence_that_the_checker_rejects_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    def reject(*_: object) -> None:
        raise CertificateRejected("segments", "an edge may not separate")

    scene = _scenes()[5]  # whose evidence is checked
    planner = Planner(scene)
    with monkeypatch.context() as patch:
        patch.setattr("planar_planner.planning.planner.verify_problem", reject)
        result = planner.solve()
    assert (result.verdict, result.stop_reason) == ("undecided", StopReason.NO_EVIDENCE)
    near = [scene["start"][0] + 0.01, *scene["start"][1:]]
    found = planner.solve(goal=near, certificate=True)
    assert found.verdict == "path" and found.certificate is not None
    assert planner.bottleneck() is None and planner.wall() is None


def test_margins_are_of_certified_paths() -> None:
    found = margin(_scenes()[0])
    assert found.lower < 1e-12 < found.upper + found.width  # the slot has 1e-13 of room
