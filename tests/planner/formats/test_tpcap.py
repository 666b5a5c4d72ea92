"""Parking-competition cases of our own making: bays, a kerb, coordinates in the billions."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from planar_planner import SceneError, load_scene, solve
from support.format_help import convert, read
from worlds.outside_files.tpcap import BAY, LOT, NEXT, box, case

PARALLEL = case(
    (-6.0, 2.5, 0.0),
    (-1.5, -1.2, 0.0),
    box(-12.0, -2.3, -3.0, -0.1),
    box(3.0, -2.3, 12.0, -0.1),
    box(-12.0, -3.0, 12.0, -2.4),
)
WALLED = case(
    (-6.0, 0.0, 0.0),
    (6.0, 0.0, 0.0),
    box(-12.0, 4.0, 12.0, 5.0),
    box(-12.0, -5.0, 12.0, -4.0),
    box(-12.0, -5.0, -11.0, 5.0),
    box(11.0, -5.0, 12.0, 5.0),
    box(-0.5, 0.9, 0.5, 4.0),
    box(-0.5, -4.0, 0.5, -0.9),
)


@pytest.mark.parametrize(
    ("text", "verdict"), [(BAY, "path"), (PARALLEL, "path"), (WALLED, "no_path")]
)
def test_cases_are_decided(text: str, verdict: str, tmp_path: Path) -> None:
    scene = read(tmp_path / "case.csv", text)
    assert solve(scene).verdict == verdict
    assert any("states no bounds" in note for note in scene.notes)


def test_the_car_stands_on_its_rear_axle(tmp_path: Path) -> None:
    scene = read(tmp_path / "case.csv", BAY)
    xs, ys = zip(*scene.robot["coordinates"][0], strict=True)
    assert (min(xs), max(xs)) == (-0.929, 3.76)
    assert (min(ys), max(ys)) == (-0.971, 0.971)
    assert scene.start == [-6.0, 2.0, 0.0]


def test_a_column_reads_like_a_row(tmp_path: Path) -> None:
    row = read(tmp_path / "row.csv", BAY)
    column = read(tmp_path / "column.csv", BAY.replace(",", "\n"))
    assert row.obstacles == column.obstacles


def test_a_case_is_written_as_it_was_read(tmp_path: Path) -> None:
    before = read(tmp_path / "case.csv", WALLED)
    assert convert(tmp_path / "case.csv", tmp_path / "again.csv") == 0
    after = load_scene(tmp_path / "again.csv")
    assert (before.obstacles, before.start, before.goal) == (
        after.obstacles,
        after.start,
        after.goal,
    )


def test_coordinates_in_the_billions_stay_as_they_are(tmp_path: Path) -> None:
    far = 5e9
    rings = [[(x + far, y + far) for x, y in ring] for ring in (LOT, NEXT)]
    start = (far - 6.0, far + 2.0, 0.0)
    scene = read(tmp_path / "far.csv", case(start, (far, far + 7.5, math.pi / 2), *rings))
    assert any("a million times larger" in note for note in scene.notes)
    assert scene.obstacles[0]["coordinates"][0][0] == list(rings[0][0])
    result = solve(scene)
    assert result.verdict == "path"
    assert tuple(result.path[0]) == start


def test_repeated_vertices_are_dropped_and_told(tmp_path: Path) -> None:
    ring = [LOT[0], LOT[0], *LOT[1:], LOT[3], LOT[0]]
    flat = [(20.0, 0.0), (21.0, 0.0), (20.0, 0.0)]
    scene = read(tmp_path / "case.csv", case((-6, 2, 0), (6, 2, 0), ring, LOT, flat))
    assert len(scene.obstacles) == 1
    assert len(scene.obstacles[0]["coordinates"][0]) == 5
    assert "repeated vertices dropped: 2" in scene.notes
    assert "copies of other obstacles dropped: 1" in scene.notes
    assert "rings without area dropped: 1" in scene.notes


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", "seven numbers"),
        ("1,2,3,4,5", "seven numbers"),
        ("0,0,0,1,1,0,2,4", "value 9 (vertices of obstacle 2)"),
        ("0,0,0,1,1,0,1,4,0,0,1,0,1,1", "14 values, but it announces 16"),
        ("0,0,zero,1,1,0,0", "value 3"),
        ("0,0,nan,1,1,0,0", "value 3"),
        ("0,0,0,1,1,0,1.5", "value 7"),
        ("0,0,0,1,1,0,-1", "value 7"),
        ("0,0,0,1,1,0,1,4,0,0,1,1,1,0,0,inf", "value 16"),
        ("0,0,0,1,1,0,1,4,0,0,1,1,1,0,0,1", "obstacle 1"),
        ("0,0,0,1,1,0,9e99", "value 7"),
    ],
)
def test_malformed_cases_say_where(text: str, place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "bad.csv", text)
    assert place in str(raised.value)
    assert str(raised.value).startswith(str(tmp_path / "bad.csv"))
