"""The page as text: complete, closed to the outside, the same twice, and safe against its scene."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planar_planner import Planner, load_scene
from planar_planner.errors import OptionsError
from planar_planner.explain.cells import LABELS, theta_slice
from planar_planner.films import cell_bytes
from planar_planner.films.cell_bytes import packed_cells
from planar_planner.films.film import film_frames
from planar_planner.films.material import Material, gather
from planar_planner.films.pace import Pace
from planar_planner.films.page import page_text, write_page
from worlds.goal_worlds import slot

NAMES = ("</script><script>alert(1)</script>", "<!-- <script>", '$title & "quotes"', "a\nb")


class Elements(HTMLParser):
    """Every element with its attributes, and the text of scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.texts: dict[int, str] = {}
        self.inner: int | None = None  # the element whose text comes
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.inner = len(self.tags)
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        self.inner = None

    def handle_data(self, data: str) -> None:
        if self.inner is not None:
            self.texts[self.inner] = self.texts.get(self.inner, "") + data

    def inside(self, tag: str) -> list[str]:
        return [self.texts.get(k, "") for k, (name, _) in enumerate(self.tags) if name == tag]


def content_of(text: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="material">(.*?)</script>', text)
    assert found is not None
    return dict(json.loads(found[1]))


def material_of(scene: Any) -> Material:
    planner = Planner(scene)
    return gather(planner, planner.solve())


@pytest.fixture(scope="module")
def gear() -> Material:
    return material_of("gear")


def test_the_same_query_gives_the_same_bytes(gear: Material, tmp_path: Path) -> None:
    for name, material in (("a.html", gear), ("b.html", material_of("gear"))):
        write_page(material, tmp_path / name, Pace())
    assert (tmp_path / "a.html").read_bytes() == (tmp_path / "b.html").read_bytes()


def test_nothing_is_loaded_from_anywhere(gear: Material) -> None:
    text = page_text(gear, Pace())
    elements = Elements(text)
    assert "http://" not in text
    assert "https://" not in text
    assert "url(" not in text
    assert "@import" not in text
    assert not any(
        {"src", "srcset", "action"} & attributes.keys() for _, attributes in elements.tags
    )
    assert [a["href"] for _, a in elements.tags if "href" in a] == ["data:,"]
    assert not any(name.startswith("on") for _, attributes in elements.tags for name in attributes)


def test_only_its_own_script_and_style_may_run(gear: Material) -> None:
    text = page_text(gear, Pace())
    elements = Elements(text)
    policy = next(a["content"] for tag, a in elements.tags if tag == "meta" and "http-equiv" in a)
    data, script = elements.inside("script")
    (style,) = elements.inside("style")
    for part in (script, style):
        digest = base64.b64encode(hashlib.sha256(part.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in policy
    assert "unsafe" not in policy
    assert "default-src 'none'" in policy
    assert json.loads(data)["name"] == "gear"


def test_every_part_of_the_player_is_in_the_page(gear: Material) -> None:
    text = page_text(gear, Pace())
    parts = [p for p in (files("planar_planner.films") / "player").iterdir() if p.is_file()]
    assert len(parts) >= 10
    for part in parts:
        if not part.name.endswith(".html"):
            assert part.read_text(encoding="utf-8") in text, part.name


@pytest.mark.parametrize("name", NAMES)
def test_a_hostile_name_is_only_data(name: str) -> None:
    material = material_of(load_scene("open").to_dict() | {"name": name})
    text = page_text(material, Pace())
    elements = Elements(text)
    assert len(elements.inside("script")) == 2
    assert content_of(text)["name"] == name
    assert " ".join(elements.inside("title")[0].split()) == " ".join(name.split())


def test_the_content_is_the_answer(gear: Material) -> None:
    content = content_of(page_text(gear, Pace(speed=2.0), (900, 500)))
    assert np.array(content["path"]) == pytest.approx(gear.result.path, rel=1e-8)
    assert content["seconds"] == pytest.approx(content["travel"][-1] / 2.0)
    assert content["size"] == [900, 500]
    assert content["cells"]["count"] == len(gear.cells) == gear.result.stats["cells"]
    assert content["verdict"].startswith("path found")
    rows = dict(content["statistics"])
    assert rows["waypoints"] == str(len(gear.result.path))
    assert rows["cells"] == f"{gear.result.stats['cells']:,}"
    rings = [len(ring) for polygon in content["world"]["obstacles"] for ring in polygon]
    assert sum(rings) == 2 * len(gear.problem.obstacles.coords)


def unpacked(packed: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """Corners (N, 6) in units of the space, and labels, as the player reads them."""
    data = base64.b64decode(packed["data"])
    shown = packed["shown"]
    assert len(data) == 13 * shown
    corners = np.frombuffer(data[: 12 * shown], dtype="<u2").reshape(6, shown).T / 65535.0
    low, high = np.array(packed["box"])
    return np.tile(low, 2) + corners * np.tile(high - low, 2), np.frombuffer(
        data[12 * shown :], dtype=np.uint8
    )


def test_packed_cells_are_the_cells(gear: Material) -> None:
    packed = packed_cells(gear.cells, rotation=True)
    assert packed is not None
    corners, labels = unpacked(packed)
    assert packed["shown"] == len(gear.cells)
    wanted = np.hstack([gear.cells.lower, gear.cells.upper])
    step = np.ptp(wanted, axis=0).max() / 65535.0
    assert np.abs(corners - wanted).max() <= step
    assert (labels == gear.cells.label).all()
    counts = [packed["labels"][name] for name in LABELS]
    assert counts == np.bincount(gear.cells.label, minlength=4).tolist()


def test_a_crowd_of_cells_is_cut_to_the_largest(
    gear: Material, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cell_bytes, "MAX_SHOWN", 100)
    packed = packed_cells(gear.cells, rotation=True)
    assert packed is not None
    assert (packed["count"], packed["shown"]) == (len(gear.cells), 100)
    corners, _ = unpacked(packed)
    volumes = np.prod(corners[:, 3:] - corners[:, :3], axis=1)
    all_volumes = np.sort(np.prod(gear.cells.upper - gear.cells.lower, axis=1))
    assert volumes.min() >= 0.9 * all_volumes[-100]


def test_a_robot_that_may_not_turn_has_one_slice() -> None:
    material = material_of("window-fixed")
    content = content_of(page_text(material, Pace()))
    assert content["rotation"] is False
    shown = theta_slice(material.cells, material.problem.start[2])
    assert content["cells"]["shown"] == len(shown) == len(material.cells)
    assert "faces are not drawn" in content["note"]


def test_cells_of_a_second_search_are_called_so() -> None:
    content = content_of(page_text(material_of("open"), Pace()))
    assert "second search" in content["note"]
    assert dict(content["statistics"])["cells"] == "0"


def test_sizes_are_bounded(gear: Material) -> None:
    with pytest.raises(OptionsError, match="160 to 4096"):
        page_text(gear, Pace(), (0, 0))


@pytest.mark.parametrize("height", [1.0, 0.3])
def test_a_goal_that_is_a_region_is_shown(height: float) -> None:
    square = {"type": "Polygon", "coordinates": [[[7, 7], [9, 7], [9, 9], [7, 9]]]}
    material = material_of(slot(height, {"region": square, "theta": [1.0, 2.0]}))
    content = content_of(page_text(material, Pace()))
    assert content["region"]["outline"] == [[[7.0, 7.0, 9.0, 7.0, 9.0, 9.0, 7.0, 9.0]]]
    assert "θ in [1, 2]" in content["region"]["text"]
    found = material.result.verdict == "path"
    assert found == (height > 0.5)
    assert content["goal"] == (pytest.approx(material.result.path[-1]) if found else None)
    frames = film_frames(material, Pace(seconds=0.4, fps=5.0), (240, 200))
    assert len(list(frames)) >= 2
