"""The harness of the stress tests itself: what it must catch is planted, in every part."""

from __future__ import annotations

import importlib
import json
import random
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from planar_planner import NoPath, Options, PathFound, SceneError, Undecided
from planar_planner.planning.result import Result

PARTS = ("invariance", "random_scenes", "contact", "critical", "false_no_path")
CERTIFIED = ("random_scenes", "contact", "critical")
OTHER = {"path": NoPath, "no_path": PathFound, "undecided": Undecided}


def run(part: str, tmp_path: Path, plant: Callable[..., Any] | None = None, most: int = 1) -> Any:
    from attacks.stress_parts.common import Settings, planner

    settings = Settings(quick=True, most=most, failures=tmp_path / "failures")
    if plant is not None:
        settings = replace(settings, solver=plant(planner))
    return list(importlib.import_module(f"attacks.stress_parts.{part}").run(settings))


def failures(rows: Any) -> list[str]:
    return [line for row in rows for line in row.failures]


def each_answer(change: Callable[[Mapping[str, Any], Result], Result]) -> Callable[..., Any]:
    """Return a plant: a solver whose answers are changed."""

    def plant(solver: Any) -> Any:
        def queries(scene: Mapping[str, Any]) -> Any:
            query = solver(scene)
            return lambda options, certificate: change(scene, query(options, certificate))

        return queries

    return plant


def flipped(result: Result) -> Result:
    kind: Any = OTHER[result.verdict]
    changed: Result = kind(
        result.scene, "planted", result.path, result.stats, certificate=result.certificate
    )
    return changed


def fickle(scene: Mapping[str, Any], result: Result) -> Result:
    """Lie about some scenes, depending on how they are drawn."""
    return flipped(result) if random.Random(json.dumps(scene)).random() < 0.5 else result


def crashing(_solver: Any) -> Any:
    def queries(scene: Mapping[str, Any]) -> Any:
        def query(options: Options, certificate: bool) -> Result:
            raise ZeroDivisionError("planted")

        return query

    return queries


def refusing(_solver: Any) -> Any:
    def queries(scene: Mapping[str, Any]) -> Any:
        raise SceneError("planted")

    return queries


@pytest.mark.parametrize("part", PARTS)
def test_the_planner_passes(part: str, tmp_path: Path) -> None:
    rows = run(part, tmp_path)
    assert failures(rows) == []
    assert sum(row.path for row in rows) > 0
    if part in ("random_scenes", "critical"):  # the first cases of the others have paths
        assert sum(row.no_path for row in rows) > 0
    assert not (tmp_path / "failures").exists()


@pytest.mark.parametrize("part", PARTS)
def test_wrong_verdicts_are_caught(part: str, tmp_path: Path) -> None:
    rows = run(part, tmp_path, each_answer(lambda _, result: flipped(result)))
    found = failures(rows)
    decided = sum(row.path + row.no_path for row in rows)
    assert len(found) >= 0.5 * decided > 0
    files = list((tmp_path / "failures").iterdir())
    assert files
    assert {"robot", "obstacles", "start", "goal"} <= set(json.loads(files[0].read_text()))


@pytest.mark.parametrize("part", PARTS)
def test_contradictions_are_caught(
    part: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without certificates, by what the other drawings of a scene say."""
    monkeypatch.setattr("attacks.stress_parts.common.certificate_failure", lambda *_: None)
    assert failures(run(part, tmp_path, each_answer(fickle), most=3))


@pytest.mark.parametrize("part", PARTS)
def test_crashes_are_caught(part: str, tmp_path: Path) -> None:
    rows = run(part, tmp_path, crashing)
    assert len(failures(rows)) >= sum(row.tried for row in rows) > 0


@pytest.mark.parametrize("part", ["invariance", "contact", "critical", "false_no_path"])
def test_refusals_of_good_scenes_are_caught(part: str, tmp_path: Path) -> None:
    assert failures(run(part, tmp_path, refusing))


@pytest.mark.parametrize("part", PARTS)
def test_rebuilt_searches_are_caught(part: str, tmp_path: Path) -> None:
    def rebuilt(_: Mapping[str, Any], result: Result) -> Result:
        return replace(result, stats={**result.stats, "search_rebuilds": 1})

    rows = run(part, tmp_path, each_answer(rebuilt))
    assert sum("search_rebuilds" in line for line in failures(rows)) > 0


@pytest.mark.parametrize("part", PARTS)
def test_overtime_is_caught(part: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("attacks.stress_parts.common.OVERTIME", -1e9)
    rows = run(part, tmp_path)
    assert sum("at a limit of" in line for line in failures(rows)) > 0


@pytest.mark.parametrize("part", CERTIFIED)
def test_bad_certificates_are_caught(part: str, tmp_path: Path) -> None:
    def emptied(_: Mapping[str, Any], result: Result) -> Result:
        if result.certificate is None:
            return result
        changed = dict(result.certificate)
        for evidence in ("full", "full_faces", "segments"):
            if evidence in changed:
                changed[evidence] = []
        return replace(result, certificate=changed)

    assert any("rejected" in line for line in failures(run(part, tmp_path, each_answer(emptied))))


@pytest.mark.parametrize("part", CERTIFIED)
def test_missing_certificates_are_caught(part: str, tmp_path: Path) -> None:
    def bare(_: Mapping[str, Any], result: Result) -> Result:
        return replace(result, certificate=None)

    assert failures(run(part, tmp_path, each_answer(bare)))


def test_an_undecided_answer_may_have_no_certificate() -> None:
    from attacks.stress_parts.certificates import certificate_failure
    from planar_planner import solve

    scene: dict[str, Any] = {"name": "unused"}
    found = solve("open", certificate=True)
    claim = Undecided("", "planted", found.path, found.stats, certificate=found.certificate)
    assert certificate_failure(scene, claim, 0.0)
    assert certificate_failure(scene, replace(claim, certificate=None), 0.0) is None


@pytest.mark.parametrize(("planted", "status"), [(False, 0), (True, 1)])
def test_exit_status(
    planted: bool,
    status: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from attacks import stress
    from attacks.stress_parts.common import Row

    def parts(name: str) -> Any:
        row = Row("part", "case", tried=3, failures=["part, case: planted"] * planted)
        return type("Part", (), {"run": staticmethod(lambda settings: [row])})

    monkeypatch.setattr(importlib, "import_module", parts)
    assert stress.main(["--quick", "--seed", "7", "--failures", str(tmp_path)]) == status
    shown = capsys.readouterr().out
    assert "seed:      7" in shown
    assert ("FAILED part, case: planted" in shown) == planted


def test_hanging_ends_the_run() -> None:
    code = (
        "import sys, time\n"
        f"sys.path += {[path for path in sys.path if path]!r}\n"
        "from attacks.stress_parts import common\n"
        "common.HANGING = 1.0 - common.LIMITS.timeout\n"
        "hanging = common.Settings(solver=lambda scene: lambda *_: time.sleep(60.0))\n"
        "common.ask(hanging, common.Row('part', 'case'), {})\n"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code],
        capture_output=True,
        text=True,
        timeout=50,
        check=False,
    )
    assert done.returncode == 1
    assert "Timeout" in done.stderr


def test_seeds_say_all(tmp_path: Path) -> None:
    from attacks.stress_parts.common import Row, Settings
    from attacks.stress_parts.random_scenes import drawn
    from worlds.random_kinds import KINDS

    for kind in KINDS:
        first, second = (
            drawn(Settings(failures=tmp_path), Row("random", kind), f"5 {kind}")[0]
            for _ in range(2)
        )
        assert first == second


def changes() -> Iterator[Any]:
    from worlds import redraw

    yield redraw.shuffled
    yield redraw.with_collinear
    yield redraw.with_duplicates
    yield redraw.obstacles_cut
    yield redraw.obstacles_cut_fine
    yield redraw.walls_drawn


def test_redrawings_cover_the_same_points() -> None:
    """Against shapely: the free world outside the obstacles, inside the box, is the same."""
    import shapely

    from planar_planner import load_scene
    from worlds.maps import snapped
    from worlds.redraw import polygons

    def solid(scene: Any, frame: Any) -> Any:
        parts = [part for shape in scene["obstacles"] for part in polygons(shape)]
        shapes = [shapely.Polygon(part[0], part[1:]) for part in parts]
        return shapely.union_all(shapes).intersection(frame)

    for name in ("gear", "slide", "slot", "comb"):
        scene = snapped(load_scene(name).to_dict())
        frame = shapely.box(*scene["workspace"]["box"])
        before = solid(scene, frame)
        for change in changes():
            drawn = change(scene, random.Random(3))
            assert drawn != scene
            difference = solid(drawn, frame).symmetric_difference(before).area
            assert difference <= 1e-12 * frame.area, (name, change.__name__)


def test_exact_maps_refuse_to_round() -> None:
    from planar_planner import load_scene
    from worlds.maps import RoundedError, Similarity, similar

    with pytest.raises(RoundedError):
        similar(load_scene("gear").to_dict(), Similarity(shift=1e9))
