"""The entities of a DXF drawing's model space, with insertions of blocks taken apart.

An insertion is an affine map of its block, so a block's entities are read in the block's frame and
mapped as curves. What a viewer does not show is marked; it is the reader that counts it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.outlines.curves import Affine
from planar_planner.formats.parts import Notes, Point

_MAX_DEPTH = 16  # depth of blocks in blocks
_MAX_ENTITIES = 10**6
_MAX_IN_BLOCKS = 2 * 10**5
"""Entities that a file may multiply: each costs time, but the file no bytes."""
_FLAT = 2.0**-40
"""Share of a map's size that its z components may have through rounding; a plane that is tilted by
so little is the x–y plane."""

IDENTITY: Affine = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)


@dataclass(frozen=True)
class Placed:
    """An entity and where it stands.

    Attributes
    ----------
    layer : str
        Layer 0 in a block is the layer of its insertion.
    entity : ezdxf entity
        In the frame of its block.
    matrix : Affine
        From that frame to the drawing's.
    shown : bool
        Whether a viewer shows it: neither invisible nor on a layer that is off or frozen.
    clipped_by : str
        Place of the insertion that shows only a part of its block; empty if there is none.
    """

    layer: str
    entity: Any
    matrix: Affine
    shown: bool
    clipped_by: str

    @property
    def place(self) -> str:
        """The layer, kind and handle, for messages."""
        return f"layer {cut(self.layer)!r}, {named(self.entity)}"


def named(entity: Any) -> str:
    """Return an entity's kind and handle, for messages."""
    handle = entity.dxf.get("handle")
    return f"{entity.dxftype()} {handle}" if handle else str(entity.dxftype())


def placed_entities(document: Any, notes: Notes) -> Iterator[Placed]:
    """Yield all entities of the model space except insertions, whose blocks' entities are yielded.

    Raises
    ------
    SceneError
        If blocks contain themselves or each other too deeply, there are too many entities, or an
        insertion is tilted. Entities are counted before any block is taken apart.
    """
    space = document.modelspace()
    total = _count(space, {}, ())
    if total > _MAX_ENTITIES or total - len(space) > _MAX_IN_BLOCKS:
        raise SceneError(
            f"has {total} entities with blocks taken apart; {_MAX_IN_BLOCKS} in blocks and "
            f"{_MAX_ENTITIES} in all are the most"
        )
    hidden = _hidden_layers(document)
    yield from _walk(space, Placed("0", None, IDENTITY, True, ""), 0, hidden, notes)


def _count(layout: Any, known: dict[str, int], around: tuple[str, ...]) -> int:
    """Return the number of entities of a layout with its blocks taken apart."""
    total = 0
    for entity in layout:
        block = entity.block() if entity.dxftype() == "INSERT" else None
        if block is None:
            total += 1
            continue
        name = block.name
        if name in around or len(around) >= _MAX_DEPTH:
            raise SceneError("has blocks nested too deeply", named(entity))
        if name not in known:
            known[name] = _count(block, known, (*around, name))
        total += max(1, known[name]) * max(1, entity.mcount)
    return total


@dataclass(frozen=True)
class _Hidden:
    """Names of layers in lower case."""

    off: frozenset[str]
    frozen: frozenset[str]


def _hidden_layers(document: Any) -> _Hidden:
    layers = list(document.layers)
    return _Hidden(
        frozenset(layer.dxf.name.lower() for layer in layers if layer.is_off()),
        frozenset(layer.dxf.name.lower() for layer in layers if layer.is_frozen()),
    )


def _walk(
    layout: Any, around: Placed, depth: int, hidden: _Hidden, notes: Notes
) -> Iterator[Placed]:
    for entity in layout:
        own = entity.dxf.get("layer", "0")
        layer = around.layer if own == "0" and depth else own
        key = layer.lower()
        shown = around.shown and not entity.dxf.get("invisible", 0) and key not in hidden.frozen
        if entity.dxftype() != "INSERT":
            # an insertion on a layer that is off still shows what its block has on other layers
            seen = shown and key not in hidden.off
            yield Placed(layer, entity, around.matrix, seen, around.clipped_by)
            continue
        here = replace(around, layer=layer, entity=entity, shown=shown)
        block = entity.block()
        if block is None or block.block.is_xref:
            notes.pass_over("insertions of missing or external blocks ignored")
            continue
        if _is_clipped(entity):
            here = replace(here, clipped_by=here.place)
        a, b, c, d, e, f = _affine(entity, here.place)
        for x, y in _places(entity):
            matrix = composed((a, b, c, d, e + x, f + y), around.matrix)
            yield from _walk(block, replace(here, matrix=matrix), depth + 1, hidden, notes)


def _places(insertion: Any) -> Iterator[Point]:
    """Yield the offsets of an array's places, each once; rotated, but not scaled."""
    if insertion.mcount <= 1:
        yield 0.0, 0.0
        return
    from ezdxf.math import Vec3

    across, up = insertion.dxf.column_spacing, insertion.dxf.row_spacing
    ocs, rotation = insertion.ocs(), insertion.dxf.rotation
    columns = range(insertion.dxf.column_count if across else 1)
    for row in range(insertion.dxf.row_count if up else 1):
        for column in columns:
            offset = Vec3(column * across, row * up)
            there = ocs.to_wcs(offset.rotate_deg(rotation) if rotation else offset)
            yield float(there.x), float(there.y)


def _is_clipped(insertion: Any) -> bool:
    from ezdxf.xclip import XClip

    clip = XClip(insertion)
    return bool(clip.has_clipping_path and clip.is_clipping_enabled)


def _affine(insertion: Any, place: str) -> Affine:
    """Return the map of an insertion on the x–y plane."""
    rows = [tuple(float(value) for value in row) for row in insertion.matrix44().rows()]
    (a, b, tilt_x, _), (c, d, tilt_y, _), _, (e, f, _, _) = rows
    size = max(map(abs, (a, b, c, d)))
    if max(abs(tilt_x), abs(tilt_y)) > _FLAT * size:
        raise SceneError("does not lie in the x–y plane", place)
    return a, b, c, d, e, f


def composed(first: Affine, then: Affine) -> Affine:
    """Return the map that applies `first` and then `then`."""
    if then == IDENTITY:
        return first
    a, b, c, d, e, f = first
    p, q, r, s, t, u = then
    return (
        p * a + r * b,
        q * a + s * b,
        p * c + r * d,
        q * c + s * d,
        p * e + r * f + t,
        q * e + s * f + u,
    )
