"""Pictures: what is drawn, not how it looks."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.collections import PathCollection

from planar_planner.load import load_scene
from planar_planner.margins.find import margin
from planar_planner.pictures import draw_scene, polygon_paths, save_picture
from planar_planner.pictures.margin import draw_margin
from planar_planner.planning.path_samples import equal_steps
from planar_planner.planning.result import NoPath, PathFound, Undecided
from planar_planner.problem.make import make_problem

PATH = np.array([(1.0, 1.0, 0.0), (1.0, 9.0, 1.0), (9.0, 9.0, 0.0)])


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_writes_a_picture(tmp_path: Path, scene_dict: dict[str, Any], suffix: str) -> None:
    file = tmp_path / f"picture{suffix}"
    draw_scene(load_scene(scene_dict), PathFound("small", "channel", PATH, {}), file)
    assert file.stat().st_size > 1000


def test_title_states_the_verdict(scene_dict: dict[str, Any]) -> None:
    scene, none = load_scene(scene_dict), np.empty((0, 3))
    cases = [
        (None, "small"),
        (PathFound("small", "channel", PATH, {}), "small – path found"),
        (NoPath("small", "separation", none, {}), "small – no path: proven"),
        (Undecided("small", "timeout", none, {}), "small – undecided: timeout"),
    ]
    for result, title in cases:
        assert draw_scene(scene, result).axes[0].get_title() == title


def test_a_name_is_no_formula(tmp_path: Path, scene_dict: dict[str, Any]) -> None:
    scene_dict["name"] = r"$\foo$ & <b>"
    scene = load_scene(scene_dict)
    file = tmp_path / "picture.svg"
    for figure in (draw_scene(scene), draw_margin(scene, margin(scene_dict))):
        save_picture(figure, file)  # an unknown symbol is an error when it is drawn


def test_picture_shows_the_query_that_was_answered(scene_dict: dict[str, Any]) -> None:
    scene = load_scene(scene_dict)
    figure = draw_scene(scene, start=(2.0, 2.0, 0.0))
    collections = [c for c in figure.axes[0].collections if isinstance(c, PathCollection)]
    centres = [tuple(c.get_paths()[0].vertices[:-1].mean(axis=0)) for c in collections]
    assert (2.0, 2.0) in centres
    assert (9.0, 9.0) in centres


def test_holes_are_filled_as_holes(scene_dict: dict[str, Any]) -> None:
    """Outer ring and hole turn in opposite senses, whatever the file says."""
    outer = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]]
    hole = [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0], [1.0, 1.0]]
    for rings in ([outer, hole], [outer[::-1], hole], [outer, hole[::-1]]):
        scene_dict["robot"] = {"type": "Polygon", "coordinates": rings}
        (path,) = polygon_paths(make_problem(load_scene(scene_dict)).robot)
        first, second = np.asarray(path.vertices)[:5], np.asarray(path.vertices)[5:]
        areas = [float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) for x, y in (first.T, second.T)]
        assert areas[0] > 0.0 > areas[1]


def test_ghosts_stand_at_equal_steps() -> None:
    ghosts = equal_steps(PATH, radius=0.7, step=0.5)
    assert np.array_equal(ghosts[0], PATH[0])
    assert np.allclose(ghosts[-1], PATH[-1])
    total = 8.0 + 8.0 + 0.7 * 2.0
    assert len(ghosts) == int(np.ceil(total / 0.5)) + 1


def test_a_path_without_motion_is_drawn(scene_dict: dict[str, Any]) -> None:
    still = PathFound("small", "start is goal", np.repeat(PATH[:1], 2, axis=0), {})
    draw_scene(load_scene(scene_dict), still)


def test_drawing_leaves_pyplot_alone() -> None:
    code = "import sys, planar_planner.pictures; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
