"""SVG drawings: roles, transforms, curves on the right side, what is refused."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import shapely

from planar_planner import Scene, SceneError, load_scene, solve
from planar_planner.cli.main import main
from planar_planner.problem.make import make_problem
from support.format_help import convert, read, same_geometry
from worlds.outside_files.svg import BOX, ENDS, svg


def shape(scene: Scene, k: int = 0) -> shapely.Polygon:
    rings = scene.obstacles[k]["coordinates"]
    return shapely.Polygon(rings[0], rings[1:])


def test_y_is_turned_upwards_and_marks_show_direction(tmp_path: Path) -> None:
    scene = read(tmp_path / "d.svg", svg(BOX, ENDS, '<path id="obstacle" d="M20 -3h2v-9h-2z"/>'))
    assert shape(scene).bounds == (20.0, 3.0, 22.0, 12.0)
    assert scene.start == [10.0, 5.0, 0.0]
    assert scene.goal == [30.0, 5.0, math.pi / 2]
    assert solve(scene).verdict == "path"


def test_the_reference_point_is_the_origin_mark_or_the_middle(tmp_path: Path) -> None:
    outline = '<path id="robot" d="M4 0h4v-2h-4z"/>'
    plain = read(tmp_path / "a.svg", svg(outline, ENDS), allow_empty=True)
    assert shapely.Polygon(plain.robot["coordinates"][0]).bounds == (-2.0, -1.0, 2.0, 1.0)
    origin = '<circle id="origin" cx="5" cy="-1"/>'
    marked = read(tmp_path / "b.svg", svg(outline, ENDS, origin), allow_empty=True)
    assert shapely.Polygon(marked.robot["coordinates"][0]).bounds == (-1.0, -1.0, 3.0, 1.0)


def test_groups_classes_labels_and_options_give_roles(tmp_path: Path) -> None:
    inkscape = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    elements = (
        '<g id="obstacles" transform="translate(100 0)"><rect width="1" height="1"/></g>',
        '<rect class="big obstacle-3" x="200" width="1" height="1"/>',
        '<g inkscape:label="Obstacle layer"><polygon points="300,0 301,0 301,1"/></g>',
        '<g id="walls"><rect x="400" width="1" height="1"/></g>',
        '<rect x="500" width="1" height="1"/>',
        '<defs><rect id="obstacle9" x="600" width="1" height="1"/></defs>',
    )
    text = svg(BOX, ENDS, *elements, head=inkscape)
    scene = read(tmp_path / "d.svg", text)
    assert sorted(shape(scene, k).bounds[0] for k in range(3)) == [100, 200, 300]
    assert "elements without a role ignored: 2" in scene.notes
    more = read(tmp_path / "d.svg", text, roles=(("WALL*", "obstacle"), ("*-3", "ignore")))
    assert sorted(shape(more, k).bounds[0] for k in range(3)) == [100, 300, 400]


def test_transforms_nest(tmp_path: Path) -> None:
    inner = '<g transform="scale(2)"><rect id="obstacle" x="1" y="1" width="1" height="2"/></g>'
    outer = f'<g transform="translate(10,20) rotate(90)">{inner}</g>'
    scene = read(tmp_path / "d.svg", svg(BOX, ENDS, outer))
    assert shape(scene).bounds == pytest.approx((4.0, -24.0, 8.0, -22.0))


@pytest.mark.parametrize("side", ["outwards", "inwards"])
@pytest.mark.parametrize("tolerance", [0.5, 0.01])
def test_obstacles_grow_and_holes_shrink(side: str, tolerance: float, tmp_path: Path) -> None:
    ring = '<path id="obstacle" fill-rule="{}" d="M30 0a10 10 0 1 0 -20 0a10 10 0 1 0 20 0z {}"/>'
    hole = "M25 0a5 5 0 1 {0} -10 0a5 5 0 1 {0} 10 0z"
    for rule, sweep in (("evenodd", 0), ("evenodd", 1), ("nonzero", 1)):
        text = svg(BOX, ENDS, ring.format(rule, hole.format(sweep)))
        scene = read(tmp_path / "d.svg", text, flatten=side, tolerance=tolerance)
        outer, inner = (shapely.Polygon(r) for r in scene.obstacles[0]["coordinates"])
        for k in range(720):
            x, y = 20 + 10 * math.cos(k / 100), 10 * math.sin(k / 100)
            ix, iy = 20 + 5 * math.cos(k / 100), 5 * math.sin(k / 100)
            assert outer.covers(shapely.Point(x, y)) == (side == "outwards")
            assert inner.contains(shapely.Point(ix, iy)) == (side == "inwards")
        assert abs(outer.area - 100 * math.pi) < 2 * math.pi * 10 * tolerance
    solid = read(tmp_path / "d.svg", svg(BOX, ENDS, ring.format("nonzero", hole.format(0))))
    assert len(solid.obstacles[0]["coordinates"]) == 1


def test_the_workspace_goes_the_other_way(tmp_path: Path) -> None:
    text = svg(BOX, ENDS, '<circle id="workspace" cx="20" cy="0" r="50"/>')
    areas = {
        side: shapely.Polygon(
            read(tmp_path / "d.svg", text, flatten=side).workspace["coordinates"][0]
        ).area
        for side in ("outwards", "inwards")
    }
    assert areas["outwards"] < 2500 * math.pi < areas["inwards"]


def disc_in_a_slot(gap: float) -> str:
    """A disc of radius 1 and a slot as wide as its diameter plus `gap`, with round cheeks."""
    wall = "M15 {0} v{1} h10 v{2} c-3 {3} -7 {3} -10 0z"
    half = 1 + gap / 2
    return svg(
        '<circle id="robot" r="1"/><circle id="start" cx="5"/><circle id="goal" cx="35"/>',
        '<rect id="workspace" y="-10" width="40" height="20"/>',
        f'<path id="obstacle1" d="{wall.format(-half, -20, 20, 0)}"/>',
        f'<path id="obstacle2" d="{wall.format(half, 20, -20, 0)}"/>',
    )


def test_verdicts_carry_over_to_the_curves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Wide enough: a path outwards. Too narrow: a proof inwards. Doubt on the other sides."""
    file = tmp_path / "d.svg"
    for gap, side, verdict, doubt in (
        (0.05, "outwards", 0, False),
        (-0.0001, "outwards", 1, True),
        (-0.05, "inwards", 1, False),
        (-0.001, "inwards", 0, True),
    ):
        file.write_text(disc_in_a_slot(gap))
        options = ["--flatten", side, "--tolerance", "0.01", "--start", "5,0,0"]
        assert main(["solve", str(file), *options]) == verdict
        error = capsys.readouterr().err
        assert f"curves are flattened {side} within 0.01" in error
        assert ("curves were flattened" in error) == doubt


@pytest.mark.parametrize("name", ["corner", "gear", "bug-trap", "window-fixed", "slot-jammed"])
def test_shipped_scenes_come_back_exactly(name: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.svg"
    assert convert(name, file) == 0
    before, after = load_scene(name), load_scene(file)
    same_geometry(before, after)
    ours, theirs = make_problem(before), make_problem(after)
    assert ours.workspace_box == theirs.workspace_box
    assert ours.reference_bounds == theirs.reference_bounds
    assert ours.rotation == theirs.rotation
    assert solve(before).verdict == solve(after).verdict


@pytest.mark.parametrize(
    ("element", "place"),
    [
        ('<path id="obstacle" fill="none" stroke="red" d="M0 0h1v1"/>', "path 'obstacle': is open"),
        ('<path id="obstacle" d="M0 0 Q"/>', "path 'obstacle': path data cannot be read"),
        ('<path id="obstacle" d="nonsense"/>', "path 'obstacle'"),
        ('<path id="origin" d=""/>', "path 'origin': is empty"),
        ('<path id="obstacle" d="M0 0 L2 2 L2 0 L0 2z"/>', "outline crosses itself"),
        ('<path id="obstacle" d="M0 0 c 90 50 -80 50 9 0z"/>', "crosses itself when flattened"),
        ('<rect id="obstacle" width="wide" height="1"/>', "rect 'obstacle', width"),
        ('<circle id="obstacle" r="-1"/>', "radius: must not be negative"),
        ('<polygon id="obstacle" points="1 2 3"/>', "odd number"),
        ('<text id="obstacle">wall</text>', "cannot be read as obstacle"),
        ('<rect id="obstacle" width="1" height="1" transform="rotate(x)"/>', "transform"),
        ('<circle id="start"/>', "second mark for start"),
        ('<rect id="obstacle" width="1e99" height="1"/>', "magnitude"),
        (
            '<circle id="workspace" r="50"/><rect id="workspace2" width="1" height="1"/>',
            "workspace",
        ),
    ],
)
def test_what_cannot_be_read_says_where(element: str, place: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "d.svg", svg(BOX, ENDS, element))
    assert place in str(raised.value)
    assert str(raised.value).startswith(str(tmp_path / "d.svg"))


def test_a_drawing_without_roles_says_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="--role"):
        read(tmp_path / "d.svg", svg('<rect width="1" height="1"/>'))


def test_features_smaller_than_the_tolerance_are_refused(tmp_path: Path) -> None:
    near = svg(
        BOX,
        ENDS,
        '<path id="obstacle" fill-rule="evenodd" d="M30 0a10 10 0 1 0 -20 0a10 10 0 1 0 20 0z'
        'M29.9 0a9.9 9.9 0 1 0 -19.8 0a9.9 9.9 0 1 0 19.8 0z"/>',
    )
    with pytest.raises(SceneError, match="tolerance"):
        read(tmp_path / "d.svg", near, tolerance=0.5)
    assert len(read(tmp_path / "d.svg", near, tolerance=0.01).obstacles) == 1


def test_what_has_no_name_at_all_fits_the_pattern_for_any(tmp_path: Path) -> None:
    nameless = '<rect x="40" width="3" height="2"/><g><rect x="50" width="3" height="2"/></g>'
    text = svg(BOX, ENDS, nameless)
    known = tuple((f"{role}*", role) for role in ("robot", "start", "goal"))
    scene = read(tmp_path / "d.svg", text, roles=(*known, ("*", "obstacle")))
    assert sorted(shape(scene, k).bounds[0] for k in range(2)) == [40, 50]
    with pytest.raises(SceneError, match="no obstacles"):
        read(tmp_path / "d.svg", text, roles=(("wall*", "obstacle"),))


@pytest.mark.parametrize(
    ("path", "plain"),
    [
        ("M20 -3A5 5 0 0 1 20 -3L24-3v-4h-4z", "M20 -3L24-3v-4h-4z"),
        ("M20 -3a5,5 0 010 0 4 0h4v-4h-4z", None),
        ("M20-3 24-3a9 2 30 1 1 0 0l0-4h-4zm0 0a1 1 0 0 0 0 0", "M20-3 24-3l0-4h-4z"),
        ("m20-3h4v-4h-4z a2 2 0 0 1 0 0", "M20-3h4v-4h-4z"),
        ("M20-3C21-9 23-9 24-3A1 1 0 0 0 24-3S20 9 20-3z", "M20-3C21-9 23-9 24-3C24-3 20 9 20-3z"),
    ],
)
def test_arcs_from_a_point_to_itself_are_left_out(
    path: str, plain: str | None, tmp_path: Path
) -> None:
    """SVG 2, section 9.5.1: the arc is omitted; a reflected control point is the point itself."""
    text = svg(BOX, ENDS, f'<path id="obstacle" d="{path}"/>')
    if plain is None:
        with pytest.raises(SceneError, match="path data cannot be read"):
            read(tmp_path / "d.svg", text)
        return
    expected = read(tmp_path / "e.svg", svg(BOX, ENDS, f'<path id="obstacle" d="{plain}"/>'))
    assert read(tmp_path / "d.svg", text).obstacles == expected.obstacles
