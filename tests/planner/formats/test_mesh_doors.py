"""Meshes at the door: a bare world is obstacles; what is not read is refused by name."""

from __future__ import annotations

from pathlib import Path

import pytest
import shapely

from planar_planner import SceneError, load_scene
from planar_planner.cli.main import main
from planar_planner.formats.outlines import merge
from planar_planner.formats.parts import ImportOptions, Notes
from worlds.outside_files.ompl_app import WALLS, dae

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
ENDS = ["--start", "5,5,0", "--goal", "15,5,0"]
SQUARE = "[[-1,-1],[1,-1],[1,1],[-1,1]]"


@pytest.mark.parametrize(
    "arguments",
    [
        [FAULTS / "both.cfg"],
        [FAULTS / "world.dae", "--robot", FAULTS / "robot.dae", *ENDS],
        [FAULTS / "world.dae", "--footprint", SQUARE, *ENDS],
    ],
)
def test_a_bare_world_is_obstacles(arguments: list[str]) -> None:
    assert main(["solve", *map(str, arguments)]) == 1


def test_a_mesh_alone_says_what_is_missing(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", str(FAULTS / "world.dae"), *ENDS]) == 2
    assert "missing robot" in capsys.readouterr().err


def test_controllers_are_refused(tmp_path: Path) -> None:
    text = dae(WALLS).replace("instance_geometry", "instance_controller")
    (tmp_path / "skin.dae").write_text(text)
    with pytest.raises(SceneError, match="skinned or morphed"):
        load_scene(tmp_path / "skin.dae", ImportOptions(footprint=SQUARE, start=[0.0] * 3))


def test_pieces_that_geos_cannot_unite_stay_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    def give_up(_: object) -> None:
        raise shapely.errors.GEOSException("TopologyException: side location conflict")

    monkeypatch.setattr(shapely, "union_all", give_up)
    pieces = [[(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], [(1.0, 0.0), (3.0, 0.0), (1.0, 2.0)]]
    notes = Notes()
    assert len(merge.merged(pieces, "world", notes)) == 2
    assert any("kept apart" in line for line in notes.as_lines())
