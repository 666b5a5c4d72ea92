"""Pictures of cells, filmstrips and walls: artists, limits and files, not pixels."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from matplotlib.collections import PathCollection, PolyCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from planar_planner import Planner, theta_slice
from planar_planner.explain.cells import FULL, LABEL_COLOURS, LABELS
from planar_planner.pictures import (
    draw_filmstrip,
    draw_scene,
    draw_slices,
    draw_space,
    draw_wall,
    save_picture,
)
from planar_planner.pictures.boxes3d import MOST_BOXES, one_turn
from planar_planner.pictures.panels import columns_for
from planar_planner.pictures.slices import passes
from planar_planner.pictures.style import GOAL, MIDWAY, OBSTACLE, OVERLAP, START
from planar_planner.pictures.views import ViewError, draw_view
from planar_planner.planning.path_samples import reach
from planar_planner.planning.result import Result

Answered = tuple[Planner, Result]


@pytest.fixture(scope="module")
def corner() -> Answered:
    planner = Planner("corner", cells_only=True)
    return planner, planner.solve()


@pytest.fixture(scope="module")
def trap() -> Answered:
    planner = Planner("bug-trap-closed")
    return planner, planner.solve(certificate=True)


def wall_picture(answered: Answered) -> Figure:
    planner, result = answered
    wall, bottleneck = planner.wall(), planner.bottleneck()
    assert wall is not None
    assert bottleneck is not None
    return draw_wall(planner.scene, wall, bottleneck, result=result)


def drawn(view: str, corner: Answered, trap: Answered) -> Figure:
    planner, result = corner
    if view == "path":
        return draw_scene(planner.scene, result)
    if view == "filmstrip":
        return draw_filmstrip(planner.scene, result, frames=5)
    if view == "slices":
        return draw_slices(planner.scene, planner.cells(), [0.0, -0.7], result=result)
    if view == "space":
        return draw_space(planner.scene, planner.cells(), result=result)
    return wall_picture(trap)


VIEWS = ["path", "filmstrip", "slices", "space", "wall"]


@pytest.fixture(scope="module")
def figures(corner: Answered, trap: Answered) -> dict[str, Figure]:
    return {view: drawn(view, corner, trap) for view in VIEWS}


SIGNS = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}


@pytest.mark.parametrize("view", VIEWS)
def test_every_view_is_written_in_every_format(
    figures: dict[str, Figure], tmp_path: Path, view: str
) -> None:
    for suffix, sign in SIGNS.items():
        file = tmp_path / f"picture{suffix}"
        save_picture(figures[view], file, dpi=40)
        assert file.stat().st_size > 1000
        assert file.read_bytes().startswith(sign)


@pytest.mark.parametrize(
    ("view", "suffix"),
    [("path", ".png"), ("slices", ".svg"), ("slices", ".pdf"), ("space", ".svg"), ("wall", ".svg")],
)
def test_the_same_answer_gives_the_same_file(
    corner: Answered, trap: Answered, tmp_path: Path, view: str, suffix: str
) -> None:
    written = []
    for k in range(2):
        file = tmp_path / f"{k}{suffix}"
        save_picture(drawn(view, corner, trap), file, dpi=40)
        written.append(file.read_bytes())
    assert written[0] == written[1]


@pytest.mark.parametrize("view", ["path", "filmstrip", "slices", "wall"])
def test_scales_are_equal_and_axes_named(figures: dict[str, Figure], view: str) -> None:
    plane = [axes for axes in figures[view].axes if axes.name != "3d"]
    assert all(axes.get_aspect() == 1.0 for axes in plane)
    assert plane[0].get_ylabel() == "y"
    assert plane[-1].get_xlabel() == "x"


def test_space_has_equal_scales_in_the_plane(figures: dict[str, Figure]) -> None:
    for axes in figures["space"].axes:
        across, along, _ = axes._box_aspect
        extents = [high - low for low, high in (axes.get_xlim(), axes.get_ylim())]
        assert across / along == pytest.approx(extents[0] / extents[1], rel=1e-9)
    overview = figures["space"].axes[0]
    assert (overview.get_xlabel(), overview.get_ylabel(), overview.get_zlabel()) == ("x", "y", "θ")


@pytest.mark.parametrize("view", VIEWS)
def test_the_legend_covers_no_drawing(figures: dict[str, Figure], view: str) -> None:
    figure = figures[view]
    figure.canvas.draw()
    (legend,) = figure.legends
    box = legend.get_window_extent()
    for axes in figure.axes:
        assert not box.overlaps(axes.get_tightbbox())


def test_a_filmstrip_shows_equal_parts_of_the_way(
    corner: Answered, figures: dict[str, Figure]
) -> None:
    _, result = corner
    panels = figures["filmstrip"].axes
    assert len(panels) == 5
    assert panels[0].get_title().startswith("start")
    assert panels[-1].get_title().startswith("goal")
    points = [axes.lines[-1].get_xydata()[0] for axes in panels]
    assert np.allclose(points[0], result.path[0, :2])
    assert np.allclose(points[-1], result.path[-1, :2])


def test_a_slice_draws_each_cell_of_the_angle_in_its_colour(
    corner: Answered, figures: dict[str, Figure]
) -> None:
    planner, _ = corner
    for axes, theta in zip(figures["slices"].axes, [0.0, -0.7], strict=True):
        cells = theta_slice(planner.cells(), theta)
        (boxes,) = [c for c in axes.collections if type(c) is PolyCollection]
        assert len(boxes.get_paths()) == len(cells)
        wanted = [LABEL_COLOURS[LABELS[label]] for label in cells.label]
        seen = [to_hex(colour).upper() for colour in boxes.get_facecolor()]
        assert seen == wanted
        assert boxes.get_paths()[0].get_extents().x0 == pytest.approx(cells.lower[0, 0])


def test_slices_of_a_path_are_at_its_angles(corner: Answered) -> None:
    planner, result = corner
    figure = draw_slices(planner.scene, planner.cells(), result=result)
    first = math.degrees(result.path[0, 2]) % 360.0
    assert figure.axes[0].get_title() == f"θ = {first:.4g}°"
    assert len({axes.get_title() for axes in figure.axes}) == len(figure.axes)


def test_where_a_path_has_an_angle() -> None:
    path = np.array([(0.0, 0.0, 0.0), (4.0, 0.0, 2 * math.tau), (8.0, 0.0, 2 * math.tau)])
    there = passes(path, math.pi, turning=True)
    assert np.allclose(there, [(1.0, 0.0, math.pi), (3.0, 0.0, math.pi + math.tau)])
    assert len(passes(path, 0.0, turning=True)) == 4  # 0, 1 and 2 turns, and the last segment's


def test_a_path_in_space_is_cut_where_theta_goes_round() -> None:
    path = np.array([(0.0, 0.0, -1.0), (2.0, 0.0, 1.0), (3.0, 0.0, 1.0)])
    first, second = one_turn(path)
    assert np.allclose(first, [(0.0, 0.0, math.tau - 1.0), (1.0, 0.0, math.tau)])
    assert np.allclose(second, [(1.0, 0.0, 0.0), (2.0, 0.0, 1.0), (3.0, 0.0, 1.0)])


def test_space_draws_three_faces_a_box(corner: Answered, figures: dict[str, Figure]) -> None:
    planner, _ = corner
    cells = planner.cells()
    for axes, label in zip(figures["space"].axes[1:], range(4), strict=True):
        count = int((cells.label == label).sum())
        assert axes.get_title() == f"{LABELS[label]}: {count:,}"
        faces = [c for c in axes.collections if isinstance(c, Poly3DCollection)]
        assert sum(len(c.get_facecolor()) for c in faces) == 3 * count


def test_space_of_many_cells_shows_the_largest_and_says_so() -> None:
    planner = Planner("maze")
    planner.solve()
    figure = draw_space(planner.scene, planner.cells())
    mixed = figure.axes[-1]
    assert mixed.get_title().startswith(f"MIXED: the largest {MOST_BOXES:,} of ")


def test_a_flat_space_is_for_slices() -> None:
    planner = Planner("slide-blocked")
    result = planner.solve()
    with pytest.raises(ValueError, match="may not turn"):
        draw_space(planner.scene, planner.cells())
    with pytest.raises(ViewError, match="may not turn"):
        draw_view(planner, result, "space")
    assert len(draw_view(planner, result, "slices").axes) == 1
    assert len(draw_view(planner, result).axes) == 3  # its wall, drawn in the plane


def test_a_wall_shows_the_robot_where_it_is_pinched(
    trap: Answered, figures: dict[str, Figure]
) -> None:
    planner, _ = trap
    bottleneck = planner.bottleneck()
    assert bottleneck is not None
    whole, close, space = figures["wall"].axes
    (lens,) = [patch for patch in whole.patches if isinstance(patch, Circle)]
    assert np.allclose(lens.center, bottleneck.at[:2])
    room = lens.radius
    assert room > reach(planner.problem.robot)
    assert close.get_xlim() == pytest.approx((lens.center[0] - room, lens.center[0] + room))
    hatched = [patch for patch in close.patches if patch.get_hatch()]
    assert hatched
    assert all(patch.get_clip_path() is not None for patch in hatched)
    assert not any(letter.isdigit() for letter in close.get_title())  # no length is proven here
    assert space.name == "3d"


def test_the_body_is_drawn_at_the_bottleneck(trap: Answered, figures: dict[str, Figure]) -> None:
    planner, _ = trap
    bottleneck = planner.bottleneck()
    assert bottleneck is not None
    close = figures["wall"].axes[1]
    bodies = [
        c.get_paths()[0].get_extents()
        for c in close.collections
        if isinstance(c, PathCollection) and len(c.get_paths()) == 1 and c.get_zorder() == 4
    ]
    (body,) = bodies
    assert (body.x0 + body.x1) / 2 == pytest.approx(bottleneck.at[0], abs=1e-9)


def test_the_wall_is_that_of_the_certificate(trap: Answered) -> None:
    planner, result = trap
    wall = planner.wall()
    assert wall is not None
    assert result.certificate is not None
    claims = [*result.certificate["full"], *result.certificate["full_faces"]]
    assert len(wall) == len(claims)
    assert np.all(wall.label == FULL)


def test_the_wall_is_made_of_full_cells(trap: Answered) -> None:
    planner, _ = trap
    wall, cells = planner.wall(), planner.cells()
    assert wall is not None
    full = cells[cells.label == FULL]
    # The frame's scale is a power of two, so both ways round alike up to the last bit.
    rows = {tuple(np.round(row, 9)) for row in np.hstack([full.lower, full.upper])}
    assert {tuple(np.round(row, 9)) for row in np.hstack([wall.lower, wall.upper])} <= rows


def test_views_say_what_they_lack(corner: Answered, trap: Answered) -> None:
    with pytest.raises(ViewError, match="no wall"):
        draw_view(*corner, "wall")
    with pytest.raises(ViewError, match="no path"):
        draw_view(*trap, "filmstrip")


def test_slices_of_an_easy_answer_are_of_another_planner() -> None:
    planner = Planner("open")
    figure = draw_view(planner, planner.solve(), "slices", [0.0])
    assert len(figure.axes) == 1


def test_nothing_to_draw_is_refused(corner: Answered, trap: Answered) -> None:
    planner, _ = corner
    none = planner.cells()[:0]
    with pytest.raises(ValueError, match="no cells"):
        draw_slices(planner.scene, none)
    with pytest.raises(ValueError, match="no cells"):
        draw_space(planner.scene, none)
    with pytest.raises(ValueError, match="at least one angle"):
        draw_slices(planner.scene, planner.cells(), [])
    blocked, result = trap
    with pytest.raises(ValueError, match="needs a path"):
        draw_filmstrip(blocked.scene, result)
    bottleneck = blocked.bottleneck()
    assert bottleneck is not None
    with pytest.raises(ValueError, match="no wall"):
        draw_wall(blocked.scene, none, bottleneck)


@pytest.mark.parametrize(("count", "columns"), [(1, 1), (2, 2), (3, 3), (6, 3), (8, 4)])
def test_square_drawings_share_the_page(count: int, columns: int) -> None:
    assert columns_for(count, 1.0) == columns


# Linear RGB as a dichromat sees it: Viénot, Brettel and Mollon 1999, Eqs. for protanopes and
# deuteranopes, in the form of sums over R, G and B that they reduce to.
DICHROMATS = {
    "protan": [[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1.0]],
    "deutan": [[0.29275, 0.70725, 0.0], [0.29275, 0.70725, 0.0], [-0.02234, 0.02234, 1.0]],
}
TOLD_APART = 20.0  # CIE76; about 2.3 is just noticeable side by side


def lab(colour: str, sight: list[list[float]] | None = None) -> np.ndarray:
    """CIE L*a*b* (D65) of an sRGB colour, as someone with this sight sees it."""
    value = np.array([int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)])
    linear = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    if sight is not None:
        linear = np.clip(np.array(sight) @ linear, 0.0, 1.0)
    to_xyz = np.array(
        [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    )
    ratio = to_xyz @ linear / np.array([0.95047, 1.0, 1.08883])
    f = np.where(ratio > (6 / 29) ** 3, np.cbrt(ratio), ratio / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


@pytest.mark.parametrize("sight", [None, *DICHROMATS])
@pytest.mark.parametrize(
    "colours",
    [list(LABEL_COLOURS.values()), [START, GOAL, MIDWAY, OBSTACLE], [OVERLAP, MIDWAY, OBSTACLE]],
    ids=["labels", "path", "wall"],
)
def test_colours_are_told_apart_by_the_colour_blind(colours: list[str], sight: str | None) -> None:
    seen = [lab(colour, None if sight is None else DICHROMATS[sight]) for colour in colours]
    for i, one in enumerate(seen):
        for k in range(i):
            assert np.linalg.norm(one - seen[k]) > TOLD_APART, (colours[i], colours[k])


def test_that_test_finds_colours_that_are_not_told_apart() -> None:
    """Red and a green of its brightness for a deuteranope."""
    far = np.linalg.norm(lab("#C04040") - lab("#7D7D40"))
    near = np.linalg.norm(
        lab("#C04040", DICHROMATS["deutan"]) - lab("#7D7D40", DICHROMATS["deutan"])
    )
    assert far > TOLD_APART > near
