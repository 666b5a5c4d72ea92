"""Every public function takes a scene in each form that `solve` takes, and means the same by it."""

from __future__ import annotations

import importlib
import inspect
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import planar_planner
from planar_planner import Planner, load_scene, margin, pictures
from planar_planner.pictures.style import save_picture

SCENE = "slot"
BLOCKED = "corner-too-long"


def forms(name: str, folder: Path) -> dict[str, Any]:
    scene = load_scene(name)
    file = folder / f"{name}.json"
    file.write_text(json.dumps(scene.to_dict()))
    return {
        "scene": scene,
        "name": name,
        "path": file,
        "string": str(file),
        "mapping": scene.to_dict(),
    }


def _scene(scene: Any) -> Any:
    return pictures.draw_scene(scene, Planner(scene).solve())


def _filmstrip(scene: Any) -> Any:
    return pictures.draw_filmstrip(scene, Planner(scene).solve())


def _slices(scene: Any) -> Any:
    planner = Planner(scene, cells_only=True)
    planner.solve()
    return pictures.draw_slices(scene, planner.cells(), [0.0, 0.5])


def _space(scene: Any) -> Any:
    planner = Planner(scene, cells_only=True)
    planner.solve()
    return pictures.draw_space(scene, planner.cells())


def _wall(scene: Any) -> Any:
    planner = Planner(scene)
    result = planner.solve()
    wall, bottleneck = planner.wall(), planner.bottleneck()
    assert wall is not None and bottleneck is not None
    return pictures.draw_wall(scene, wall, bottleneck, result=result)


def _margin(scene: Any) -> Any:
    return pictures.draw_margin(scene, margin(scene, width=0.1))


DRAWN: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "draw_scene": (SCENE, _scene),
    "draw_filmstrip": (SCENE, _filmstrip),
    "draw_slices": (SCENE, _slices),
    "draw_space": (SCENE, _space),
    "draw_wall": (BLOCKED, _wall),
    "draw_margin": (SCENE, _margin),
}


@pytest.mark.parametrize("name", DRAWN)
def test_every_form_draws_the_same_picture(name: str, tmp_path: Path) -> None:
    scene, draw = DRAWN[name]
    drawn = set()
    for form in forms(scene, tmp_path).values():
        save_picture(draw(form), tmp_path / "p.png", ".png")
        drawn.add((tmp_path / "p.png").read_bytes())
    assert len(drawn) == 1


def test_films_of_physics_take_every_form(tmp_path: Path) -> None:
    pytest.importorskip("pymunk")
    from planar_planner.films.physics import save_push, save_replay
    from planar_planner.physics import push, replay

    path = np.array([(0.0, 0.0, 0.0), (0.1, 0.0, 0.0)])
    films = set()
    for form in forms(SCENE, tmp_path).values():
        found = replay(form, path + np.array(load_scene(SCENE).start))
        save_replay(form, found, tmp_path / "r.gif", ".gif")
        save_push(form, push(form, seconds=0.1, tries=1), tmp_path / "p.gif", ".gif")
        films.add((tmp_path / "r.gif").read_bytes() + (tmp_path / "p.gif").read_bytes())
    assert len(films) == 1


ROOMS = ("", "pictures", "films.physics", "physics", "ompl")


@pytest.mark.parametrize("room", ROOMS)
def test_no_public_function_asks_for_a_loaded_scene(room: str) -> None:
    """A parameter called scene has the type of `solve`'s, alone or beside a valid problem."""
    needs = {"films.physics": "pymunk", "physics": "pymunk", "ompl": "ompl"}
    if room in needs:
        pytest.importorskip(needs[room])
    module = importlib.import_module(f"planar_planner.{room}".rstrip("."))
    takers = []
    for name in getattr(module, "__all__", vars(module)):
        found = getattr(module, name)
        function = found.__init__ if inspect.isclass(found) else found
        if name.startswith("_") or not inspect.isfunction(function):
            continue
        if not function.__module__.startswith("planar_planner"):
            continue
        scene = inspect.signature(function).parameters.get("scene")
        if scene is None or scene.annotation is str or scene.annotation == "str":
            continue  # results keep the name of their scene
        takers.append(name)
        if name != "verify_certificate":
            assert "SceneLike" in str(scene.annotation), (module.__name__, name, scene.annotation)
    assert takers


def test_the_checker_takes_every_form(tmp_path: Path) -> None:
    """It names its types itself, because it shares no more with the planner than it must."""
    evidence = planar_planner.solve(SCENE, certificate=True).certificate
    assert evidence is not None
    for form in forms(SCENE, tmp_path).values():
        assert planar_planner.verify_certificate(form, evidence).verdict == "path"
