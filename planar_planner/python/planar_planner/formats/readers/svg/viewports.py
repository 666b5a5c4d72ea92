"""The root's units, and the frames and limits of nested svg elements and symbols."""

from __future__ import annotations

from dataclasses import dataclass

from planar_planner.errors import SceneError, cut
from planar_planner.formats.outlines.curves import SLACK, Affine, Piece, first_point, transformed
from planar_planner.formats.parts import Notes
from planar_planner.formats.readers.svg.lengths import PHYSICAL, Size, numbers, parsed, split
from planar_planner.formats.readers.svg.style import Node, Value, Values, word_of
from planar_planner.formats.readers.svg.transforms import (
    IDENTITY,
    inverse,
    product,
    scaling,
    translation,
)

Rectangle = tuple[float, float, float, float]
"""(x, y, width, height)."""


@dataclass(frozen=True)
class Clip:
    """A rectangle outside which a viewer shows nothing.

    Attributes
    ----------
    from_scene : Affine
        From the scene's frame into that of the rectangle.
    rectangle : (x, y, width, height)
    """

    from_scene: Affine
    rectangle: Rectangle

    def holds(self, piece: Piece) -> bool:
        """Return whether a piece lies inside, by its control points."""
        x0, y0, width, height = self.rectangle
        slack = SLACK * max(abs(x0), abs(y0), width, height)
        for x, y in map(_point, transformed(piece, self.from_scene)):
            if not (x0 - slack <= x <= x0 + width + slack):
                return False
            if not (y0 - slack <= y <= y0 + height + slack):
                return False
        return True


def _point(p: tuple[float, float, float]) -> tuple[float, float]:
    return first_point((p,))


@dataclass(frozen=True)
class Viewport:
    """A nested viewport.

    Attributes
    ----------
    matrix : Affine
        From the inner user space into that of the element's parent.
    size : Size
        Size of the inner user space, for percentages.
    limit : rectangle, optional
        What is shown, in the parent's user space; None if nothing is cut off.
    """

    matrix: Affine
    size: Size
    limit: Rectangle | None

    def clips(self, parent: Affine) -> tuple[Clip, ...]:
        """Return the limit in the scene, given the parent's frame."""
        return () if self.limit is None else (Clip(inverse(parent), self.limit),)


def root_size(root: Node, notes: Notes) -> Size:
    """Return the drawing's size in user units, and say what the unit is."""
    element = root.etree_element
    box = _view_box(element.get("viewBox"), "svg")
    sides = [(element.get(name) or "").strip() for name in ("width", "height")]
    stated = [_root_length(text) for text in sides]
    if box is None:
        if any(sides):
            notes.say(_PIXELS.format(" by ".join(text or "auto" for text in sides)))
        return Size(*stated)
    scales = [s / b for s, b in zip(stated, box[2:], strict=True) if s is not None and b > 0]
    physical = any(split(text, "svg, width")[1] in PHYSICAL for text in sides if text[:1].isdigit())
    if scales and (physical or any(scale != 1 for scale in scales)):
        notes.say(_USER_UNITS.format(cut(" by ".join(text or "auto" for text in sides)), scales[0]))
    return Size(box[2], box[3])


_PIXELS = (
    "lengths are in the drawing's user units, which are pixels (px, 1/96 inch), not mm; its size "
    "is {}"
)
_USER_UNITS = (
    "lengths are in the user units of the viewBox; the stated size of {}, by which one user unit "
    "is shown as {!r} px (1/96 inch), is not used"
)


def _root_length(text: str) -> float | None:
    if not text or text.lower() == "auto" or text.endswith("%"):
        return None
    number, unit = split(text, "svg, width or height")
    if unit in ("em", "ex", "rem", "vw", "vh"):
        return None
    return parsed(Value(f"{number!r}{unit}", css=False), None, "svg, width or height")


def nested(node: Node, values: Values, outer: Size, place: str) -> Viewport | None:
    """Return the viewport of a nested svg or a symbol; None if its size is zero: it is not shown.

    Raises
    ------
    SceneError
        If its size is a share of one that is not stated, or it cuts off without a size.
    """
    element = node.etree_element
    x, y, width, height = _frame(node, values, outer, place)
    if 0 in (width, height):
        return None
    box = _view_box(element.get("viewBox"), place)
    overflow = word_of(values, "overflow", "hidden")
    limited = overflow not in ("visible", "auto")
    if width is None or height is None:
        if box is not None or limited:
            raise SceneError("has a size that is not stated", place)
        return Viewport(translation(x, y), Size(width, height), None)
    limit = (x, y, width, height) if limited else None
    if box is None:
        matrix = translation(x, y) if x or y else IDENTITY
        return Viewport(matrix, Size(width, height), limit)
    if 0 in box[2:]:
        return None
    matrix = _fitted(box, (x, y, width, height), element.get("preserveAspectRatio"), place)
    return Viewport(matrix, Size(box[2], box[3]), limit)


def _frame(
    node: Node, values: Values, outer: Size, place: str
) -> tuple[float, float, float | None, float | None]:
    """Return x, y, width and height in the parent's user space; a symbol's x and y count, too."""
    del node
    for name in ("x", "y", "width", "height"):
        if name in values and values[name].css:
            raise SceneError("has a frame in CSS, which viewers read differently", place)
    x, y = (
        parsed(values[name], outer.base(name), f"{place}, {name}") if name in values else 0.0
        for name in ("x", "y")
    )
    sides: list[float | None] = []
    for name in ("width", "height"):
        value = values.get(name)
        if value is None or value.text.lower() == "auto":
            sides.append(outer.base(name))
        else:
            sides.append(parsed(value, outer.base(name), f"{place}, {name}"))
    if any(side is not None and side < 0 for side in sides):
        raise SceneError("has a negative size", place)
    return x, y, sides[0], sides[1]


def _view_box(text: str | None, place: str) -> Rectangle | None:
    if text is None or text.strip().lower() in ("", "none"):
        return None
    values = numbers(text, f"{place}, viewBox")
    if len(values) != 4 or values[2] < 0 or values[3] < 0:
        raise SceneError("must be four numbers, the last two not negative", f"{place}, viewBox")
    return values[0], values[1], values[2], values[3]


_ALIGNED = {"min": 0.0, "mid": 0.5, "max": 1.0}


def _fitted(box: Rectangle, frame: Rectangle, aspect: str | None, place: str) -> Affine:
    """Return the map of a viewBox into its frame (SVG 2, section 8.2)."""
    words = (aspect or "").split()
    words = words[1:] if words[:1] == ["defer"] else words
    align, how = (words + ["xMidYMid", "meet"][len(words) :])[:2]
    sx, sy = frame[2] / box[2], frame[3] / box[3]
    if align == "none":
        shift = (0.0, 0.0)
    else:
        parts = (align[1:4].lower(), align[5:8].lower())
        known = len(align) == 8 and align[0] == "x" and align[4] == "Y" and how in _CHOICES
        if not known or any(part not in _ALIGNED for part in parts):
            raise SceneError("cannot be read", f"{place}, preserveAspectRatio", cut(aspect or ""))
        sx = sy = _CHOICES[how](sx, sy)
        room = (frame[2] - box[2] * sx, frame[3] - box[3] * sy)
        shift = (_ALIGNED[parts[0]] * room[0], _ALIGNED[parts[1]] * room[1])
    moved = translation(frame[0] + shift[0], frame[1] + shift[1])
    return product(product(moved, scaling(sx, sy)), translation(-box[0], -box[1]))


_CHOICES = {"meet": min, "slice": max}
