"""The reader of DXF drawings, by ezdxf: layers state roles, and blocks are taken apart.

Lines, arcs and splines of a layer are joined to closed outlines. If outlines on a layer lie inside
each other, every second one is a hole. What is drawn filled or with a width is an area of its own.
What a viewer does not show is left out and counted.
"""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.drawing import DEFAULT_TOLERANCE, Drawing, mark_of, parts_of
from planar_planner.formats.outlines import curves
from planar_planner.formats.outlines.chaining import Joining, closed_outlines
from planar_planner.formats.outlines.curves import Outline, Piece
from planar_planner.formats.outlines.figure import EVENODD, Figure
from planar_planner.formats.outlines.nesting import Nesting, nested_figures
from planar_planner.formats.outlines.strands import Run, Strand
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point
from planar_planner.formats.readers.dxf import fills
from planar_planner.formats.readers.dxf.blocks import IDENTITY, Placed, named, placed_entities
from planar_planner.formats.readers.dxf.entities import run_of, vertices_of, xy
from planar_planner.formats.reading import coordinate, require
from planar_planner.formats.roles import role_of
from planar_planner.scene.input_limits import MAX_COORDINATE, MIN_COORDINATE
from planar_planner.tolerances import JOIN_REACH

_MARKS = ("start", "goal", "origin")
_AREAS = ("workspace", "reference_bounds")
"""Roles whose outline is what counts: a width or a hatch in it says nothing."""
_WORDS = ("TEXT", "MTEXT", "DIMENSION", "LEADER", "MULTILEADER", "TOLERANCE", "ATTDEF", "ATTRIB")
_NAMED = 12  # layers that a message names at most
_UNITS = {1: "inches", 2: "feet", 4: "millimetres", 5: "centimetres", 6: "metres"}


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a drawing."""
    del path
    ezdxf: Any = require("ezdxf", "reading DXF", "dxf")
    try:
        document = ezdxf.read(_stream(data))
        _say_what_is_elsewhere(document, notes)
        content = _content(placed_entities(document, notes), options, notes)
        return parts_of(_drawing(content, options, notes), options, notes)
    except SceneError:
        raise
    except Exception as error:  # ezdxf raises many types on a broken file
        reason = cut(" ".join(str(error).split())) or type(error).__name__
        raise SceneError(f"cannot be read as DXF: {reason}") from None


def _stream(data: bytes) -> io.TextIOBase:
    if data.startswith(b"AutoCAD Binary DXF"):
        raise SceneError("is binary DXF; save it as text (ASCII) DXF")
    try:
        return io.StringIO(data.decode("utf-8-sig").replace("\r\n", "\n"))
    except UnicodeDecodeError:
        return io.StringIO(data.decode("cp1252", errors="replace").replace("\r\n", "\n"))


def _say_what_is_elsewhere(document: Any, notes: Notes) -> None:
    """Say in which unit the drawing is, and count what is not in the model space."""
    unit = int(document.header.get("$INSUNITS", 0))
    if unit:
        name = _UNITS.get(unit, "see DXF's table of units")
        notes.say(f"$INSUNITS states unit {unit} ({name}); lengths stay in the drawing's unit")
    elsewhere = sum(
        entity.dxftype() != "VIEWPORT"
        for layout in document.layouts
        if layout.name != "Model"
        for entity in layout
    )
    notes.pass_over("entities in paper space ignored", times=elsewhere)


# ---- from entities to lines and areas by their roles ------------------------------------------


@dataclass
class _Content:
    """What a drawing's entities draw, by role.

    Attributes
    ----------
    strands : dict
        Lines by role and layer; the layers' names are as first met.
    areas : list of (role, Figure)
        Solids and bands.
    hatches : list of (role, place, boundaries)
    """

    drawing: Drawing = field(default_factory=Drawing)
    layers: dict[tuple[str, str], str] = field(default_factory=dict)
    strands: dict[tuple[str, str], list[Strand]] = field(default_factory=dict)
    areas: list[tuple[str, Figure]] = field(default_factory=list)
    hatches: list[tuple[str, str, list[list[Run]]]] = field(default_factory=list)
    _drawn: dict[int, tuple[bool, Run]] = field(default_factory=dict)

    def drawn(self, item: Placed) -> tuple[bool, Run]:
        """Return whether an entity has a width, and its pieces in its block's frame.

        A block's entities are read once, however often the block is inserted. The document keeps
        the entities, so none takes over the number of another.
        """
        key = id(item.entity)
        if key not in self._drawn:
            wide = fills.has_width(item.entity, item.place)
            self._drawn[key] = wide, run_of(item.entity, item.place)
        return self._drawn[key]


def _content(entities: Iterable[Placed], options: ImportOptions, notes: Notes) -> _Content:
    content = _Content()
    nameless: Counter[str] = Counter()
    roles: dict[str, str | None] = {}
    for item in entities:
        if item.layer not in roles:
            roles[item.layer] = role_of([item.layer], options.roles)
        role = roles[item.layer]
        if role is None:
            notes.pass_over("entities on layers without a role ignored")
            nameless[item.layer] += 1
        elif role == "ignore":
            notes.pass_over("entities on layers with the role ignore ignored")
        else:
            _take(item, role, content, notes)
    if nameless:
        _say_nameless(nameless, content, notes)
    return content


def _say_nameless(nameless: Counter[str], content: _Content, notes: Notes) -> None:
    """Say which layers have no role; raise an error if that leaves nothing."""
    names = sorted(nameless)
    listed = ", ".join(repr(cut(name)) for name in names[:_NAMED])
    listed += f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    if not (content.strands or content.areas or content.hatches or content.drawing.marks):
        raise SceneError(
            "no layer has a role: name layers robot, obstacle, workspace, start and goal, or state "
            f"roles, for example --role {names[0]!r}=obstacle; the layers are {listed}"
        )
    notes.say(f"layers without a role: {listed}")


def _take(item: Placed, role: str, content: _Content, notes: Notes) -> None:
    """Add what an entity draws."""
    kind, place, entity = item.entity.dxftype(), item.place, item.entity
    if not item.shown:
        notes.pass_over("entities not shown ignored (invisible, or their layer is off or frozen)")
    elif item.clipped_by:
        raise SceneError("shows only a part of its block; clip the outlines", item.clipped_by)
    elif kind in _WORDS or kind == "VIEWPORT":
        notes.pass_over("texts and dimensions ignored")
    elif role in _MARKS:
        content.drawing.mark(role, mark_of(_mark_points(item)), place)
    elif kind == "POINT":
        notes.pass_over("points ignored")
    elif kind in fills.HATCHES:
        runs = [[_mapped(run, item) for run in own] for own in fills.hatch_runs(entity, place)]
        content.hatches.append((role, place, runs))
    elif kind in fills.SOLIDS:
        _add_area(item, role, fills.solid(entity, place), content)
        notes.count("solids read as areas")
    elif (wide := content.drawn(item)[0]) and role not in _AREAS:
        for band in fills.bands(entity, place):
            _add_area(item, role, band, content)
        closed = "closed " if vertices_of(entity, place)[1] else ""
        inside = ", their insides free" if closed else ""
        notes.count(f"{closed}polylines with a width read as the bands that a viewer shows{inside}")
    else:
        if wide:
            notes.count("widths of polylines ignored")
        run = _mapped(content.drawn(item)[1], item)
        key = role, item.layer.lower()
        content.layers.setdefault(key, item.layer)
        if run:
            content.strands.setdefault(key, []).append(Strand(run, named(entity)))


def _add_area(item: Placed, role: str, outline: Outline, content: _Content) -> None:
    pieces = tuple(_mapped(list(outline.pieces), item))
    if pieces:
        content.areas.append((role, Figure((Outline(pieces),), EVENODD, item.place)))


def _mapped(run: Run, item: Placed) -> Run:
    """Return pieces in the drawing's frame, with every number checked."""
    if item.matrix != IDENTITY:
        run = [curves.transformed(piece, item.matrix) for piece in run]
    for piece in run:
        for x, y, w in piece:
            for value in (x / w, y / w):
                if value != 0 and not MIN_COORDINATE <= abs(value) <= MAX_COORDINATE:
                    coordinate(repr(value), item.place)
    return run


def _mark_points(item: Placed) -> list[Point]:
    entity, kind = item.entity, item.entity.dxftype()
    if kind in ("POINT", "CIRCLE"):
        here = entity.dxf.location if kind == "POINT" else entity.ocs().to_wcs(entity.dxf.center)
        (piece,) = _mapped([curves.straight(xy(here), xy(here))], item)
        return [curves.first_point(piece)]
    run = _mapped(run_of(entity, item.place), item)
    if not run:
        raise SceneError("cannot be a mark; use a point, a circle or a line", item.place)
    return [curves.first_point(run[0]), curves.last_point(run[-1])]


# ---- from lines and areas to figures ----------------------------------------------------------


def _drawing(content: _Content, options: ImportOptions, notes: Notes) -> Drawing:
    drawing = content.drawing
    extent = _extent(_pieces(content))
    reach = JOIN_REACH * extent
    tolerance = options.tolerance or DEFAULT_TOLERANCE * extent
    for key, strands in content.strands.items():
        place = f"layer {cut(content.layers[key])!r}"
        traced = closed_outlines(strands, Joining(reach, options.join, place), notes)
        how = Nesting(tolerance, reach, place)
        for figure in nested_figures(traced, how, notes) if traced else ():
            drawing.add(key[0], figure)
    for role, figure in content.areas:
        drawing.add(role, figure)
    for role, place, boundaries in content.hatches:
        if role in _AREAS and drawing.figures.get(role):
            notes.pass_over("hatches in outlines ignored")
            continue
        lengths = fills.Tracing(reach, tolerance, options.join)
        figures = list(fills.hatch_figures(boundaries, place, lengths, notes))
        if figures:
            notes.count("hatches read as filled areas")
        else:
            notes.pass_over("hatches without area ignored")
        for figure in figures:
            drawing.add(role, figure)
    return drawing


def _pieces(content: _Content) -> Iterator[Piece]:
    for strands in content.strands.values():
        for strand in strands:
            yield from strand.pieces
    for _, figure in content.areas:
        for outline in figure.outlines:
            yield from outline.pieces
    for _, _, boundaries in content.hatches:
        for boundary in boundaries:
            for run in boundary:
                yield from run


def _extent(pieces: Iterable[Piece]) -> float:
    points = [(x / w, y / w) for piece in pieces for x, y, w in piece]
    if not points:
        return 1.0
    xs, ys = zip(*points, strict=True)
    return max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
