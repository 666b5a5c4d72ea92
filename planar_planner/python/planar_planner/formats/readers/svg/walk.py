"""The way through all elements of a drawing, in the order in which a viewer paints them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.drawing import Drawing, parts_of
from planar_planner.formats.outlines.curves import Affine
from planar_planner.formats.parts import ImportOptions, Notes, Parts
from planar_planner.formats.readers.svg.document import (
    NEVER_DRAWN,
    SVG,
    Context,
    Document,
    check_size,
    ids_of,
    link_of,
    names_of,
)
from planar_planner.formats.readers.svg.figures import take
from planar_planner.formats.readers.svg.lengths import parsed
from planar_planner.formats.readers.svg.paint import (
    effect_of,
    is_left_out,
    is_visible,
    passes,
)
from planar_planner.formats.readers.svg.shapes import SHAPES
from planar_planner.formats.readers.svg.style import Node, Sheet, Value, Values, computed, sheet_of
from planar_planner.formats.readers.svg.transforms import (
    IDENTITY,
    determinant,
    product,
    transform_of,
    translation,
)
from planar_planner.formats.readers.svg.viewports import Viewport, nested, root_size
from planar_planner.formats.reading import require
from planar_planner.formats.xml_tree import parse_xml

_UPWARDS: Affine = (1.0, 0.0, 0.0, -1.0, 0.0, 0.0)
_NOT_READ = frozenset(("text", "image", "foreignObject", "video", "audio", "iframe", "canvas"))
_LEFT_OUT = "elements that a viewer does not show are left out"


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a drawing."""
    del path
    element = parse_xml(data, "svg", namespaces=True)
    require("svgpathtools", "reading SVG", "svg")
    cssselect2: Any = require("cssselect2", "reading SVG", "svg")
    if any("<?xml-stylesheet".encode(code) in data for code in ("utf-8", "utf-16-le", "utf-16-be")):
        raise SceneError("has a style sheet in another file, which is not read")
    root: Node = cssselect2.ElementWrapper.from_xml_root(element)
    if root.namespace_url not in (SVG, ""):
        raise SceneError("must be an svg file", value=cut(str(element.tag)))
    namespace: str = root.namespace_url
    sheet = sheet_of(root, lambda node: bool(node.namespace_url == namespace))
    drawing = Drawing(rotation=element.get("data-rotation") != "false")
    ids = ids_of(root)
    check_size(root, ids)
    document = Document(sheet, ids, namespace, options, notes, drawing)
    _children(document, root, _root_context(root, sheet, notes))
    _take_lone(document)
    return parts_of(drawing, options, notes)


def _root_context(root: Node, sheet: Sheet, notes: Notes) -> Context:
    """Return what the root's children inherit.

    Raises
    ------
    SceneError
        If the root is transformed, which viewers do about different origins.
    """
    size = root_size(root, notes)
    values = computed(sheet.declared(root, "svg"), {})
    if transform_of(values, size, "svg") != IDENTITY:
        raise SceneError("a transform of the root is not read; transform a group", "svg")
    effect = effect_of(root, values)
    return Context(
        names=(),
        matrix=_UPWARDS,
        values=values,
        size=size,
        left_out=is_left_out(root, values),
        effect=f"{effect} of svg" if effect else "",
    )


def _take_lone(document: Document) -> None:
    """Take the only shape of a robot's file as the robot."""
    if document.options.only_robot and not document.drawing.figures and len(document.lone) == 1:
        node, context, place = document.lone[0]
        document.notes.passed_over -= document.notes.counts.pop(_NO_ROLE, 0)
        document.notes.say(f"the drawing's only shape, {place}, is taken as the robot")
        take(document, node, context, "robot", place)


_NO_ROLE = "elements without a role ignored"


def _children(document: Document, parent: Node, context: Context) -> None:
    for node in parent.iter_children():
        if document.is_svg(node) and node.local_name not in NEVER_DRAWN:
            _element(document, node, context)


def _element(document: Document, node: Node, context: Context) -> None:
    kind = node.local_name
    own = names_of(node)
    place = document.place(node, own, context)
    role = document.role(own, context) if kind in SHAPES or kind in _NOT_READ else None
    if kind in SHAPES and role is None and not document.options.only_robot:
        if not context.left_out:
            document.notes.pass_over(_NO_ROLE, (*own, *context.names))
        return
    if role == "ignore":
        document.notes.pass_over("elements with the role ignore ignored")
        return
    if kind in _NOT_READ and role is None:
        if not context.left_out:
            document.notes.pass_over("texts, images and the like without a role ignored")
        return
    inner = _within(document, node, own, context, place)
    if kind in SHAPES or kind in _NOT_READ:
        _leaf(document, node, inner, role, place)
    elif kind == "use":
        _use(document, node, own, inner, place)
    elif kind == "svg":
        _viewport(document, node, inner, place, inner.values)
    elif kind == "switch":
        _switch(document, node, inner)
    else:
        known = kind in ("g", "a")
        _children(document, node, inner if known else replace(inner, left_out=True))


def _leaf(document: Document, node: Node, inner: Context, role: str | None, place: str) -> None:
    if inner.left_out or not is_visible(inner.values):
        if role is not None:
            document.notes.pass_over(_LEFT_OUT)
    elif role is None:
        document.notes.pass_over(_NO_ROLE)
        document.lone.append((node, inner, place))
    elif node.local_name in _NOT_READ:
        raise SceneError(f"cannot be read as {role}; turn it into a path", place)
    else:
        take(document, node, inner, role, place)


def _within(
    document: Document, node: Node, own: tuple[str, ...], context: Context, place: str
) -> Context:
    """Return an element's own frame, properties and names, which its children inherit."""
    values = computed(document.sheet.declared(node, place), context.values)
    left_out = context.left_out or is_left_out(node, values)
    if "systemLanguage" in node.etree_element.attrib:
        document.notes.say("systemLanguage: what a viewer in English shows is read")
    matrix = context.matrix
    if not left_out:
        matrix = product(matrix, transform_of(values, context.size, place))
        left_out = determinant(matrix) == 0
    effect = effect_of(node, values)
    return replace(
        context,
        names=(*own, *context.names),
        matrix=matrix,
        values=values,
        left_out=left_out,
        effect=context.effect or (f"{effect} of {place}" if effect else ""),
    )


def _switch(document: Document, node: Node, inner: Context) -> None:
    """Walk the first child that passes; a viewer leaves out the others."""
    chosen = False
    for child in node.iter_children():
        if document.is_svg(child):
            takes = not chosen and passes(child)
            chosen = chosen or takes
            if child.local_name in NEVER_DRAWN:
                continue
            _element(document, child, inner if takes else replace(inner, left_out=True))


def _viewport(document: Document, node: Node, inner: Context, place: str, values: Values) -> None:
    """Walk a nested svg or a symbol in its own frame."""
    frame = None if inner.left_out else nested(node, values, inner.size, place)
    _children(document, node, _framed(inner, frame))


def _framed(context: Context, frame: Viewport | None) -> Context:
    if frame is None:
        return replace(context, left_out=True)
    return replace(
        context,
        matrix=product(context.matrix, frame.matrix),
        size=frame.size,
        clips=(*context.clips, *frame.clips(context.matrix)),
    )


def _use(document: Document, node: Node, own: tuple[str, ...], inner: Context, place: str) -> None:
    """Walk the target of a use element (SVG 2, section 5.6): moved by x and y, then transformed."""
    link = link_of(node)
    name = link.removeprefix("#")
    target = document.ids.get(name) if link.startswith("#") else None
    if link and not link.startswith("#"):
        raise SceneError("uses an element of another file, which is not read", place, cut(link))
    if target is None or name in inner.using or _contains(target, node):
        document.notes.pass_over("use elements without a target in the file are left out")
        return
    x, y = (_offset(inner, axis, place) for axis in ("x", "y"))
    role = inner.role if inner.role is not None else document.role(own, replace(inner, names=()))
    inside = replace(
        inner,
        matrix=product(inner.matrix, translation(x, y)) if x or y else inner.matrix,
        using=(*inner.using, name),
        role=role,
    )
    if target.local_name not in ("symbol", "svg"):
        if document.is_svg(target) and target.local_name not in NEVER_DRAWN:
            _element(document, target, inside)
        return
    where = f"{cut(target.local_name)} {cut(name)!r}"
    framed = _within(document, target, names_of(target), inside, where)
    sides = {side: inner.values[side] for side in ("width", "height") if side in inner.values}
    if any(value.text.lower() == "auto" for value in sides.values()):
        raise SceneError("has a size that viewers read differently", place, "auto")
    if target.local_name == "svg" and framed.matrix != inside.matrix:
        raise SceneError("uses a transformed svg, which viewers read differently", place)
    _viewport(document, target, framed, where, {**framed.values, **sides})


def _offset(inner: Context, axis: str, place: str) -> float:
    value = inner.values.get(axis, Value("0", css=False))
    return parsed(value, inner.size.base(axis), f"{place}, {axis}")


def _contains(target: Node, node: Node) -> bool:
    return any(above == target for above in node.ancestors)
