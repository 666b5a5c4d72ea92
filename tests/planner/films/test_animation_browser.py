"""The player in a real browser: it plays, obeys mouse, keys and fingers, and asks for nothing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planar_planner import Planner, load_scene
from planar_planner.explain.cells import LABEL_COLOURS, LABELS, theta_slice
from planar_planner.films.material import gather
from planar_planner.films.pace import Pace
from planar_planner.films.page import write_page
from planar_planner.pictures import MIDWAY
from planar_planner.planning.path_samples import configurations_at, reach, travel

pytest.importorskip("selenium", reason="needs selenium: pip install selenium")
from support import chromium

FOUND = chromium.found()
pytestmark = pytest.mark.skipif(FOUND is None, reason="needs chromium and chromedriver")

DESKTOP, PHONE = (1280, 800), (390, 844)
SHIFT = 8  # of the DevTools protocol
HOSTILE = "</script><script>hacked=1</script><img src=x onerror=hacked=1>$title&amp;"


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    with chromium.started(*FOUND) as browser:
        yield browser


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("pages")
    urls = {}
    for name in ("gear", "gear-jammed", "hostile"):
        scene = load_scene("open" if name == "hostile" else name)
        content = scene.to_dict() | ({"name": HOSTILE} if name == "hostile" else {})
        planner = Planner(content)
        file = folder / f"{name}.html"
        write_page(gather(planner, planner.solve()), file, Pace(seconds=5.0))
        urls[name] = Path(file).as_uri()
    return urls


@pytest.fixture
def opened(chrome: Any, pages: dict[str, str]) -> Iterator[Any]:
    """Open a page in a window; afterwards the console must be silent and nothing asked for."""
    urls = []
    chromium.said(chrome)
    chromium.requested(chrome)

    def open_page(name: str, window: tuple[int, int] = DESKTOP, **media: str) -> Any:
        width, height = window
        phone = window == PHONE
        chrome.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone},
        )
        chrome.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": phone})
        features = [{"name": k.replace("_", "-"), "value": v} for k, v in media.items()]
        chrome.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        urls.append(pages[name])
        return chromium.Page(chrome, pages[name])

    yield open_page
    assert chromium.said(chrome) == []
    # Chromium's own first tab may still be asking for its own resources.
    own = ("data:", "chrome:")
    assert [url for url in chromium.requested(chrome) if not url.startswith(own)] == urls


def seek(page: Any, share: float) -> None:
    page.run(
        "const scrub = document.getElementById('scrub'); scrub.value = arguments[0];"
        "scrub.dispatchEvent(new Event('input'))",
        share,
    )


def like(picture: np.ndarray, colour: str) -> np.ndarray:
    wanted = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])
    return (np.abs(picture - wanted) <= 8).all(axis=2)


def test_it_plays_and_the_robot_moves(opened: Any) -> None:
    page = opened("gear")
    page.until(lambda: page.state()["share"] > 0.02, "it plays by itself")
    page.key(" ", "Space")
    assert not page.state()["playing"]
    stopped = page.state()["share"]
    assert page.state()["share"] == stopped
    seek(page, 0.0)
    page.state()
    first = page.picture("#world")
    page.key(" ", "Space")
    page.until(lambda: page.state()["share"] > 0.1, "it plays again")
    page.key(" ", "Space")
    assert not page.state()["playing"]
    second = page.picture("#world")
    places = [np.argwhere(like(picture, MIDWAY)) for picture in (first, second)]
    assert all(len(place) > 500 for place in places)
    moved = places[1].mean(axis=0) - places[0].mean(axis=0)
    assert moved[1] > 10.0  # to the right, where the goal is


def test_the_slice_shows_cells_in_their_colours_and_follows_the_angle(opened: Any) -> None:
    page = opened("gear", prefers_reduced_motion="reduce")
    seek(page, 0.45)
    assert page.state()["cells"] > 10
    picture = page.picture("#slice")
    for label in ("FREE", "STAR", "FULL", "MIXED"):
        assert like(picture, LABEL_COLOURS[label]).sum() > 20, label
    assert like(picture, MIDWAY).sum() > 50  # the robot, and its reference point on the path
    seek(page, 0.7)
    page.state()
    assert (page.picture("#slice") != picture).any(axis=2).mean() > 0.01


def test_positions_are_those_of_the_library(opened: Any) -> None:
    planner = Planner("gear")
    path = planner.solve().path
    radius = reach(planner.problem.robot)
    page = opened("gear", prefers_reduced_motion="reduce")
    for share in (0.0, 0.31, 0.5, 1.0):
        seek(page, share)
        q = configurations_at(path, radius, [share * travel(path, radius)[-1]])[0]
        assert page.state()["configuration"] == pytest.approx(q, abs=1e-6)


def test_keys(opened: Any) -> None:
    page = opened("gear", prefers_reduced_motion="reduce")
    assert not page.state()["playing"]  # as the system asks
    page.key("ArrowRight", "ArrowRight")
    assert page.state()["share"] == pytest.approx(0.01)
    page.key("ArrowRight", "ArrowRight", SHIFT)
    assert page.state()["share"] == pytest.approx(0.11)
    page.key("ArrowLeft", "ArrowLeft")
    assert page.state()["share"] == pytest.approx(0.10)
    page.key("End", "End")
    assert page.state()["share"] == 1.0
    page.key("Home", "Home")
    assert page.state()["share"] == 0.0
    page.key("+", "Equal", SHIFT)
    assert page.state()["zoom"] == pytest.approx(1.25)
    page.key("-", "Minus")
    page.key("-", "Minus")
    assert page.state()["zoom"] == pytest.approx(0.8)
    page.key("0", "Digit0")
    assert page.state()["zoom"] == 1.0


@pytest.mark.parametrize("window", [(1280, 560), (1600, 1000), (800, 1000)])
def test_views_and_controls_are_on_one_screen(opened: Any, window: tuple[int, int]) -> None:
    page = opened("gear-jammed", window, prefers_reduced_motion="reduce")
    page.state()
    assert page.run("return document.scrollingElement.scrollWidth") <= window[0]
    for part in ("#world", "#slice", "#play", "#legend"):
        _, y = page.middle(part)
        assert 0 < y < window[1], part
        size = page.run("return document.querySelector(arguments[0]).clientWidth", part)
        assert size > 20, part


def test_following_keeps_the_robot_in_the_middle(opened: Any) -> None:
    page = opened("gear", prefers_reduced_motion="reduce")
    seek(page, 0.3)
    page.key("f", "KeyF")
    near = page.state()
    assert near["zoom"] == 3.0
    assert near["centre"] == pytest.approx(near["configuration"][:2])
    seek(page, 0.8)
    there = page.state()
    assert there["centre"] == pytest.approx(there["configuration"][:2])
    assert there["centre"] != near["centre"]


def label_at(name: str, x: float, y: float, theta: float) -> str:
    """Return the name of the label of the cell at a configuration."""
    planner = Planner(name)
    planner.solve()
    cells = theta_slice(planner.cells(), theta)
    here = np.all((cells.lower[:, :2] <= (x, y)) & ((x, y) < cells.upper[:, :2]), axis=1)
    return LABELS[int(cells.label[here].item())]


def test_wheel_zooms_where_it_points_dragging_pans_and_pointing_probes(opened: Any) -> None:
    page = opened("gear", prefers_reduced_motion="reduce")
    page.state()
    x, y = page.middle("#slice")
    page.mouse("mouseMoved", x, y)
    assert page.state()["probe"] == pytest.approx([0.0, 0.0], abs=0.05)
    page.mouse("mouseMoved", x + 17, y + 13)  # off the lines between cells
    state = page.state()
    told = page.run("return document.getElementById('probe').textContent")
    assert label_at("gear", *state["probe"], state["configuration"][2]) in told
    page.mouse("mouseWheel", x + 100, y, deltaX=0, deltaY=-120)
    page.until(lambda: page.state()["zoom"] > 1.4, "zoom by wheel")
    zoomed = page.state()
    assert zoomed["centre"][0] > 0.3  # towards the mouse
    page.mouse("mousePressed", x, y, button="left", clickCount=1)
    page.mouse("mouseMoved", x - 60, y, button="left")
    page.mouse("mouseReleased", x - 60, y, button="left", clickCount=1)
    assert page.state()["centre"][0] > zoomed["centre"][0] + 0.3
    page.run("document.getElementById('fit').click()")
    assert page.state()["centre"] == pytest.approx([0.0, 0.0])


def test_fingers_on_a_phone(opened: Any) -> None:
    page = opened("gear", PHONE, prefers_reduced_motion="reduce")
    page.state()
    assert page.run("return document.scrollingElement.scrollWidth") <= PHONE[0]
    for part in ("#world", "#slice", "#play", "#scrub"):
        _, y = page.middle(part)
        assert 0 < y < PHONE[1], part
    x, y = page.middle("#world")
    page.touch("touchStart", [(x - 30, y), (x + 30, y)])
    page.touch("touchMove", [(x - 60, y), (x + 60, y)])
    page.touch("touchEnd", [])
    pinched = page.state()
    assert pinched["zoom"] == pytest.approx(2.0, rel=0.05)
    page.touch("touchStart", [(x, y)])
    page.touch("touchMove", [(x - 40, y)])
    page.touch("touchMove", [(x - 80, y)])
    page.touch("touchEnd", [])
    assert page.state()["centre"][0] > pinched["centre"][0] + 0.5
    assert page.state()["probe"] is None
    x, y = page.middle("#slice")
    page.touch("touchStart", [(x, y)])
    page.touch("touchEnd", [])
    page.until(lambda: page.state()["probe"] is not None, "a tap on the slice")
    x, y = page.middle("#play")
    page.touch("touchStart", [(x, y)])
    page.touch("touchEnd", [])
    page.until(lambda: page.state()["share"] > 0.01, "it plays after a tap")


def test_without_a_path_the_angle_goes_round(opened: Any) -> None:
    page = opened("gear-jammed", prefers_reduced_motion="reduce")
    assert "no path" in page.run("return document.getElementById('verdict').textContent")
    seek(page, 0.25)
    assert page.state()["configuration"][2] == pytest.approx(np.pi / 2)
    before = page.picture("#slice")
    seek(page, 0.3)
    page.state()
    assert (page.picture("#slice") != before).any()
    rows = page.run("return document.getElementById('statistics').textContent")
    assert f"cells{Planner('gear-jammed').solve().stats['cells']:,}" in rows


def test_dark(opened: Any) -> None:
    light = opened("gear", prefers_reduced_motion="reduce", prefers_color_scheme="light")
    light.state()
    bright = light.picture("#world").mean()
    dark = opened("gear", prefers_reduced_motion="reduce", prefers_color_scheme="dark")
    dark.state()
    assert dark.picture("#world").mean() < 0.6 * bright


def test_a_hostile_name_is_only_text(opened: Any) -> None:
    page = opened("hostile")
    page.state()
    assert page.run("return document.getElementById('name').textContent") == HOSTILE
    assert page.run("return document.title") == HOSTILE
    assert page.run("return typeof hacked") == "undefined"
    assert page.run("return document.images.length") == 0
