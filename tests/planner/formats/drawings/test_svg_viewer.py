"""What a viewer shows of an SVG drawing, and where, is what is read; else it is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
import shapely

from planar_planner import Scene, SceneError
from support.format_help import read
from worlds.outside_files.svg import BOX, ENDS, svg

BLOCK = '<rect id="obstacle" x="40" y="10" width="10" height="20"{}/>'
LINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"'


def drawn(tmp_path: Path, *elements: str, head: str = 'viewBox="0 0 100 100"') -> Scene:
    return read(tmp_path / "d.svg", svg(BOX, ENDS, *elements, head=f"{LINK} {head}"))


def boxes(scene: Scene) -> list[tuple[float, ...]]:
    """Return the boxes of all obstacles, y downwards as drawn: (x0, y0, x1, y1)."""
    found = []
    for obstacle in scene.obstacles:
        x0, y0, x1, y1 = shapely.Polygon(obstacle["coordinates"][0]).bounds
        found.append((x0, -y1, x1, -y0))
    return sorted(found)


def style(text: str, more: str = "") -> str:
    return f"<style{more}>{text}</style>"


HERE = (40, 10, 50, 30)


@pytest.mark.parametrize(
    ("elements", "box"),
    [
        (BLOCK.format(' style="transform:translate(5px,1%)"'), (45, 11, 55, 31)),
        (style("rect.a{transform:translateX(2px)}") + BLOCK.format(' class="a"'), (42, 10, 52, 30)),
        (BLOCK.format(' transform="scale(9)" style="transform:none"'), HERE),
        (
            BLOCK.format(' style="translate:5px;scale:2;transform-origin:40px 10px"'),
            (45, 10, 65, 50),
        ),
        (BLOCK.format(' transform="rotate(90)" transform-origin="40 10"'), (20, 10, 40, 20)),
        (BLOCK.format(' transform="rotate(-90 40,10)"'), (40, 0, 60, 10)),
        (BLOCK.format(' transform="matrix(1 0 0 1 30-10)"'), (70, 0, 80, 20)),
        (BLOCK.format(' transform="translate(10-5)"'), (50, 5, 60, 25)),
        (BLOCK.format(' style="width:30px!important;width:5px"'), (40, 10, 70, 30)),
        (style("#obstacle{x:0}rect{x:9px}") + BLOCK.format(""), (0, 10, 10, 30)),
        (style("rect:not(.b){x:0}") + BLOCK.format(' class="b"'), HERE),
        (style("@media print{rect{x:0}}") + BLOCK.format(""), HERE),
        (style("@media screen{#obstacle{x:0}}") + BLOCK.format(""), (0, 10, 10, 30)),
        (style("rect{x:0}", ' media="print"') + BLOCK.format(""), HERE),
        (f"<defs>{style('<![CDATA[#obstacle{x:0}]]>')}</defs>" + BLOCK.format(""), (0, 10, 10, 30)),
        ('<rect id="obstacle" x="1in" width="25.4mm" height="72pt"/>', (96, 0, 192, 96)),
        ('<rect id="obstacle" width="50%" height="10%"/>', (0, 0, 50, 10)),
        ('<polygon id="obstacle" points="10-10,20-10,20-20,10-20"/>', (10, -20, 20, -10)),
        ('<path id="obstacle" d="M10 10A0 5 0 0 1 20 10v10h-10"/>', (10, 10, 20, 20)),
        ('<path id="obstacle" d="M1 2h3v4"/>', (1, 2, 4, 6)),
    ],
)
def test_frames_and_styles(elements: str, box: tuple[float, ...], tmp_path: Path) -> None:
    assert boxes(drawn(tmp_path, elements)) == [pytest.approx(box)]


@pytest.mark.parametrize(
    ("elements", "box"),
    [
        (
            '<defs><rect id="s" width="4" height="5"/></defs><use id="obstacle" href="#s" x="20"/>',
            (20, 0, 24, 5),
        ),
        (
            '<symbol id="obstacle"><rect width="4" height="5"/></symbol>'
            '<use xlink:href="#obstacle"/>',
            (0, 0, 4, 5),
        ),
        (
            '<symbol id="s" viewBox="0 0 10 10"><rect width="10" height="10"/></symbol>'
            '<use id="obstacle" href="#s" x="20" y="10" width="40" height="20"/>',
            (30, 10, 50, 30),
        ),
        (
            '<g id="obstacle"><svg x="10" width="40" height="20" viewBox="0 0 10 10" '
            'preserveAspectRatio="none"><rect width="5" height="5"/></svg></g>',
            (10, 0, 30, 10),
        ),
    ],
)
def test_uses_and_nested_viewports(elements: str, box: tuple[float, ...], tmp_path: Path) -> None:
    assert boxes(drawn(tmp_path, elements)) == [pytest.approx(box)]


@pytest.mark.parametrize(
    "hidden",
    [
        ' display="none"',
        ' style="display:none"',
        ' visibility="hidden"',
        ' opacity="0"',
        ' style="fill-opacity:0%"',
        ' fill="none"',
        ' fill="#1230"',
        ' fill="url(#nothing)"',
        ' fill="none" stroke="red" stroke-width="0"',
        ' transform="scale(0)"',
        ' systemLanguage="de"',
        ' requiredExtensions="http://x.example/"',
    ],
)
def test_what_is_not_shown_is_left_out_and_counted(hidden: str, tmp_path: Path) -> None:
    scene = drawn(tmp_path, BLOCK.format(""), BLOCK.replace("40", "70").format(hidden))
    assert boxes(scene) == [HERE]
    assert "elements that a viewer does not show are left out: 1" in scene.notes


@pytest.mark.parametrize(
    ("around", "count"),
    [
        ('<g display="none">{}</g>', 1),
        ('<g visibility="hidden"><g>{}</g></g>', 1),
        ("<layer>{}</layer>", 1),
        ('<svg width="0">{}</svg>', 1),
        ('<switch><g systemLanguage="fr"/><g/>{}</switch>', 1),
        ("<defs>{}</defs>", 0),
        ('<x:g xmlns:x="http://x.example/">{}</x:g>', 0),
        ("<metadata>{}</metadata>", 0),
    ],
)
def test_groups_that_are_not_shown(around: str, count: int, tmp_path: Path) -> None:
    scene = drawn(tmp_path, BLOCK.format(""), around.format(BLOCK.replace("40", "70").format("")))
    assert boxes(scene) == [HERE]
    said = [line for line in scene.notes if "does not show" in line]
    assert said == ["elements that a viewer does not show are left out: 1"] * count


@pytest.mark.parametrize(("group", "x"), [('x="20"', 0), ('style="x:20px"', 20)])
def test_a_group_has_no_place_to_inherit_unless_css_states_it(
    group: str, x: int, tmp_path: Path
) -> None:
    inside = '<rect id="obstacle" x="inherit" y="2" width="3" height="4"/>'
    assert boxes(drawn(tmp_path, f"<g {group}>{inside}</g>")) == [(x, 2, x + 3, 6)]


def test_a_visible_child_of_a_hidden_group_is_shown(tmp_path: Path) -> None:
    inside = BLOCK.format(' visibility="visible"')
    assert boxes(drawn(tmp_path, f'<g visibility="hidden">{inside}</g>')) == [HERE]


@pytest.mark.parametrize(
    ("elements", "problem"),
    [
        (BLOCK.format(' clip-path="url(#c)"'), "clip-path of rect 'obstacle'"),
        ('<g style="mask:url(#m)">' + BLOCK.format("") + "</g>", "mask of g"),
        (style("rect{filter:blur(2px)}") + BLOCK.format(""), "filter of rect"),
        ('<pattern id="p"/>' + BLOCK.format(' fill="url(#p)"'), "pattern is not read"),
        (
            '<linearGradient id="p"><stop stop-opacity="0"/></linearGradient>'
            + BLOCK.format(' fill="url(#p)"'),
            "gradient with transparency",
        ),
        (
            '<rect id="p"><stop/></rect><linearGradient id="q" href="#p"/>'
            + BLOCK.format(' fill="url(#q)"'),
            "gradient with transparency",
        ),
        (
            '<defs systemLanguage="ru"><linearGradient id="p"><stop/></linearGradient></defs>'
            + BLOCK.format(' fill="url(#p)"'),
            "gradient that may not fill all",
        ),
        ('<svg width="45" height="90">' + BLOCK.format("") + "</svg>", "cut off by a nested svg"),
        (BLOCK.format(' style="width:calc(1px + 2px)"'), "width: is computed"),
        (style("@import 'a.css';"), "@import, which is not read"),
        (style("@media (min-width:9px){rect{x:0}}"), "medium that is not read"),
        (BLOCK.format(' style="transform:rotate3d(1,1,1,5deg)"'), "not a transform of the plane"),
        (
            BLOCK.format(' transform="rotate(9)" style="transform-box:fill-box"'),
            "transform-box: other boxes",
        ),
        ('<use id="obstacle" href="other.svg#a"/>', "another file"),
        ('<rect id="obstacle" width="2em" height="1"/>', "unit that is not read"),
        ('<rect id="obstacle" width="9" height="9" rx="auto" ry="2"/>', "differently by viewers"),
        ('<line id="obstacle" x2="9" y2="9" stroke="red"/>', "line without area"),
        (
            '<rect id="obstacle" width="9" height="9"><animate attributeName="x"/></rect>',
            "animation",
        ),
    ],
)
def test_what_changes_the_area_and_is_not_read_is_refused(
    elements: str, problem: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError) as raised:
        drawn(tmp_path, elements)
    assert problem in str(raised.value)


def test_uses_of_uses_are_bounded(tmp_path: Path) -> None:
    levels = "".join(f'<g id="a{k + 1}">' + f'<use href="#a{k}"/>' * 10 + "</g>" for k in range(12))
    bomb = f'<defs><g id="a0">{BLOCK.format("")}</g>{levels}</defs><use href="#a12"/>'
    with pytest.raises(SceneError, match="draws more than 200000 elements"):
        drawn(tmp_path, bomb)


@pytest.mark.parametrize("loop", ['<use id="u" href="#u"/>', '<g id="u"><use href="#u"/></g>'])
def test_uses_of_themselves_are_left_out(loop: str, tmp_path: Path) -> None:
    scene = drawn(tmp_path, BLOCK.format(""), loop)
    assert boxes(scene) == [HERE]
    assert "use elements without a target in the file are left out: 1" in scene.notes


@pytest.mark.parametrize("name", ["original2", "startled", "goalpost", "Robotics-lab"])
def test_words_that_begin_like_a_role_have_none(name: str, tmp_path: Path) -> None:
    shape = f'<g class="obstacle"><rect id="{name}" width="4" height="5"/></g>'
    assert boxes(drawn(tmp_path, shape)) == [(0, 0, 4, 5)]


def test_shapes_without_area_are_left_out_and_counted(tmp_path: Path) -> None:
    empty = ('<path class="obstacle" d=""/>', '<rect class="obstacle" width="0" height="3"/>')
    scene = drawn(tmp_path, BLOCK.format(""), *empty)
    assert boxes(scene) == [HERE]
    assert "elements without area are left out: 2" in scene.notes


@pytest.mark.parametrize("selector", ["circle ~ rect", "rect:nth-child(3)"])
def test_selectors_of_quadratic_cost_are_bounded(selector: str, tmp_path: Path) -> None:
    many = '<rect class="obstacle" width="1" height="1"/>' * 2001
    with pytest.raises(SceneError, match="compares more than 2000 elements"):
        drawn(tmp_path, style(f"{selector}{{fill:red}}"), f"<g>{many}</g>")


def test_first_of_a_switch_is_taken_as_browsers_do(tmp_path: Path) -> None:
    for first, count in (("<title>t</title>", 2), ('<g systemLanguage="de"/>', 1)):
        body = f"<switch>{first}{BLOCK.format('')}{BLOCK.format('')}</switch>"
        other = '<rect class="obstacle" x="90" width="1" height="1"/>'
        scene = drawn(tmp_path, body, other)
        assert f"elements that a viewer does not show are left out: {count}" in scene.notes
        assert len(scene.obstacles) == 3 - count


@pytest.mark.parametrize(
    ("elements", "problem"),
    [
        (BLOCK.format(' style="transform:translate(1px),scale(2)"'), "comma or space that CSS"),
        (BLOCK.format(' transform="translate(1),"'), "transform"),
        (BLOCK.format(' style="fill:color-mix(in srgb, red, blue)"'), "colour that is not read"),
        (BLOCK.format(' style="display:contents"'), "display:contents"),
        ('<path id="obstacle" d="M9,,9h9v9z"/>', "path data cannot be read"),
        ('<path id="obstacle" d="M9 9a5 5 0 2 1 9 9z"/>', "path data cannot be read"),
        ('<path id="obstacle" d="M9\u00a09h9v9z"/>', "path data cannot be read"),
        ('<path id="obstacle" d="M9 9h2_0v9z"/>', "path data cannot be read"),
        ('<polygon id="obstacle" points=",1 2 3 4 5 9"/>', "must be numbers"),
        ('<rect id="obstacle" width="20 px" height="9"/>', "must be a length"),
        (BLOCK.format(' style="width:-9px"'), "must not be negative in CSS"),
        (BLOCK.format(' style="x:auto"'), "must be a length"),
        (
            '<radialGradient id="p" fx="0.9" fr="0.1"><stop/></radialGradient>'
            + BLOCK.format(' fill="url(#p)"'),
            "may not fill all",
        ),
        ('<rect id="obstacle" width="20." height="1"/>', "must be a length"),
        ('<path id="obstacle" d="M1. 1h9v9z"/>', "path data cannot be read"),
        ('<g id="obstacle"><svg style="width:9px"><path d="M0 0h1v1z"/></svg></g>', "frame in CSS"),
    ],
)
def test_what_viewers_drop_or_read_differently_is_refused(
    elements: str, problem: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError) as raised:
        drawn(tmp_path, elements)
    assert problem in str(raised.value)


def test_what_is_never_drawn_needs_no_role(tmp_path: Path) -> None:
    """Files of Inkscape hold views, metadata and gradients beside the shapes."""
    names = (
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'
    )
    text = svg(
        '<sodipodi:namedview id="base"/><metadata id="m"/><desc id="d">t</desc>',
        '<defs id="defs1"><linearGradient id="g1"><stop/></linearGradient></defs>',
        '<rect id="part" width="3" height="2"/><g id="start"><circle cx="9"/></g>',
        head=names,
    )
    scene = read(
        tmp_path / "d.svg",
        text,
        roles=(("start", "start"), ("*", "obstacle")),
        footprint="[[-1,-1],[1,-1],[1,1],[-1,1]]",
        goal=[20.0, 0.0, 0.0],
    )
    assert boxes(scene) == [(0, 0, 3, 2)]
