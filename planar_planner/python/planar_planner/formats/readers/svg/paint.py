"""What a viewer shows: which elements, which fills, and what the reader cannot judge."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.readers.svg.document import link_of
from planar_planner.formats.readers.svg.lengths import Size, split
from planar_planner.formats.readers.svg.style import (
    Node,
    Sheet,
    Value,
    Values,
    computed,
    opacity,
    word_of,
)
from planar_planner.formats.readers.svg.transforms import determinant, transform_of
from planar_planner.formats.reading import require

_ANIMATIONS = ("animate", "animateMotion", "animateTransform", "set", "animateColor")
_EFFECTS = (
    "clip-path",
    "mask",
    "filter",
    "mask-image",
    "offset-path",
    "offset",
    "animation",
    "animation-name",
    "-webkit-clip-path",
    "-webkit-mask",
    "-webkit-mask-image",
    "zoom",
    "-webkit-transform",
    "all",
    "content-visibility",
)
"""Properties that change what is shown of an element and its children, and are not read."""
_NO_EFFECT = ("none", "", "normal", "auto", "visible", "1")
LANGUAGE = "en"


class Paint(Enum):
    """How an area or a stroke is painted."""

    NONE = "none"
    SEEN = "seen"


def effect_of(node: Node, values: Values) -> str:
    """Return the name of the first effect that is not read; empty if there is none."""
    for name in _EFFECTS:
        if word_of(values, name, "none") not in _NO_EFFECT:
            return name
    if word_of(values, "display", "inline") == "contents":
        return "display:contents"
    if any(child.tag.rpartition("}")[2] in _ANIMATIONS for child in node.etree_children):
        return "animation"
    return ""


def is_left_out(node: Node, values: Values) -> bool:
    """Return whether a viewer leaves out an element with all its children."""
    gone = word_of(values, "display", "inline") == "none"
    return gone or _share(values, "opacity") <= 0 or not passes(node)


def passes(node: Node) -> bool:
    """Return whether a viewer in English without extensions takes an element."""
    element = node.etree_element
    if "requiredExtensions" in element.attrib:
        return False
    languages = element.get("systemLanguage")
    if languages is None:
        return True
    words = [word.strip().lower() for word in languages.split(",")]
    return any(word == LANGUAGE or word.startswith(f"{LANGUAGE}-") for word in words)


def is_visible(values: Values) -> bool:
    """Return whether an element's own shape is shown."""
    return word_of(values, "visibility", "visible") == "visible"


def fill_of(values: Values, servers: Mapping[str, Node], sheet: Sheet, place: str) -> Paint:
    """Return how an area is filled.

    Raises
    ------
    SceneError
        If only part of the area is painted, by a pattern or a gradient with transparent stops.
    """
    if _share(values, "fill-opacity") <= 0:
        return Paint.NONE
    text = values["fill"].text if "fill" in values else "black"
    return _paint(text, values, servers, sheet, place)


def stroke_of(values: Values) -> Paint:
    """Return whether a stroke is seen; a reference counts as seen."""
    width, _ = split(word_of(values, "stroke-width", "1"), "stroke-width")
    text = values["stroke"].text if "stroke" in values else "none"
    if _share(values, "stroke-opacity") <= 0 or width == 0:
        return Paint.NONE
    if text.lower().startswith(("url(", "context-")):
        return Paint.SEEN
    return Paint.SEEN if _alpha(text, values) > 0 else Paint.NONE


def has_marker(values: Values) -> bool:
    """Return whether markers are drawn at vertices."""
    names = ("marker-start", "marker-mid", "marker-end")
    return any(word_of(values, name, "none") != "none" for name in names)


def _share(values: Values, name: str) -> float:
    share = opacity(word_of(values, name, "1"))
    return 1.0 if share is None else share


def _alpha(text: str, values: Values) -> float:
    """Return a colour's opacity, 0 for ``none``."""
    color4: Any = require("tinycss2.color4", "reading SVG", "svg")
    if text.lower() == "none":
        return 0.0
    color = color4.parse_color(text)
    if color == "currentcolor":
        own = values.get("color", Value("black", css=True)).text
        color = color4.parse_color("black" if own.lower() == "currentcolor" else own)
    return 1.0 if color is None else float(color.alpha)


def _paint(
    text: str, values: Values, servers: Mapping[str, Node], sheet: Sheet, place: str
) -> Paint:
    if text.lower().startswith("context-"):
        raise SceneError("fill: is that of another element, which is not read", place, cut(text))
    if not text.lower().startswith("url("):
        return Paint.SEEN if _alpha(text, values) > 0 else Paint.NONE
    inside, _, fallback = text[4:].partition(")")
    name = inside.strip().strip("\"'")
    server = servers.get(name.removeprefix("#")) if name.startswith("#") else None
    if server is None or server.local_name not in _SERVERS:
        if not name.startswith("#"):
            raise SceneError("fill: is from another file, which is not read", place, cut(text))
        return _paint(fallback.strip() or "none", values, servers, sheet, place)
    if server.local_name == "pattern":
        raise SceneError("fill: a pattern is not read; use a plain colour", place, cut(text))
    if _has_gap(server, servers, sheet):
        raise SceneError("fill: a gradient with transparency is not read", place, cut(text))
    if _is_odd(server, servers, sheet):
        raise SceneError("fill: a gradient that may not fill all is not read", place, cut(text))
    return Paint.SEEN


_GRADIENTS = ("linearGradient", "radialGradient")
_SERVERS = (*_GRADIENTS, "pattern")


def _has_gap(server: Node, servers: Mapping[str, Node], sheet: Sheet) -> bool:
    """Return whether a gradient has stops that are not opaque, or no stops of its own kind."""
    seen: list[str] = []
    node: Node | None = server
    while node is not None and node.local_name in _GRADIENTS:
        stops = [child for child in node.iter_children() if child.local_name == "stop"]
        if stops:
            return any(_stop_alpha(stop, sheet) < 1 for stop in stops)
        name = link_of(node).removeprefix("#")
        if name in seen:
            return True
        seen.append(name)
        node = servers.get(name)
    return True


def _is_odd(server: Node, servers: Mapping[str, Node], sheet: Sheet) -> bool:
    """Return whether a gradient may leave places unpainted although its stops are opaque.

    A gradient that is not displayed, one for readers of other languages, a singular transform and
    a focal circle off the centre do.
    """
    for above in (server, *server.ancestors):
        if (
            not passes(above)
            or word_of(sheet.declared(above, "gradient"), "display", "inline") == "none"
        ):
            return True
    seen: list[Node] = []
    node: Node | None = server
    while node is not None and node not in seen:
        seen.append(node)
        element = node.etree_element
        if element.get("fr", "0") not in ("0", "0%") or any(
            element.get(f"f{axis}", element.get(f"c{axis}")) != element.get(f"c{axis}")
            for axis in "xy"
        ):
            return True
        own = Value(element.get("gradientTransform") or "", css=False)
        if determinant(transform_of({"transform": own}, Size(None, None), "gradient")) == 0:
            return True
        node = servers.get(link_of(node).removeprefix("#"))
    return False


def _stop_alpha(stop: Node, sheet: Sheet) -> float:
    values = computed(sheet.declared(stop, "stop"), {})
    color = values.get("stop-color", Value("black", css=True)).text
    return _alpha(color, values) * _share(values, "stop-opacity")
