"""The values of an element's properties: attributes, rules of style elements, style attributes.

The cascade is that of CSS for authors' rules (CSS Cascading 4, section 6): importance, then the
style attribute over rules, then specificity, then order. A presentation attribute counts as a rule
of specificity 0 before all others (SVG 2, section 6.6).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from planar_planner.errors import SceneError, cut
from planar_planner.formats.reading import require

Node = Any
"""cssselect2.ElementWrapper: an element that knows its parents; the library has no types."""


@dataclass(frozen=True)
class Value:
    """A property's text; `css` if it is written in CSS, whose lengths need units."""

    text: str
    css: bool


Values = Mapping[str, Value]

INHERITED = frozenset(
    (
        "fill",
        "fill-rule",
        "fill-opacity",
        "stroke",
        "stroke-width",
        "stroke-opacity",
        "visibility",
        "color",
        "marker",
        "marker-start",
        "marker-mid",
        "marker-end",
    )
)
GEOMETRY = frozenset(("x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"))
_BOX = frozenset(("x", "y", "width", "height"))
_GEOMETRY_OF = {
    "rect": _BOX | {"rx", "ry"},
    "circle": frozenset(("cx", "cy", "r")),
    "ellipse": frozenset(("cx", "cy", "rx", "ry")),
    **dict.fromkeys(("svg", "symbol", "use", "image", "foreignObject"), _BOX),
}
"""Elements whose attributes state geometry; that of others has no value to inherit."""
_OWN_ATTRIBUTES = frozenset(
    (
        "display",
        "opacity",
        "transform",
        "transform-origin",
        "clip-path",
        "mask",
        "filter",
        "overflow",
        "stop-color",
        "stop-opacity",
    )
)
_CSS_ALONE = frozenset(
    (
        "transform-box",
        "translate",
        "rotate",
        "scale",
        "offset-path",
        "mask-image",
        "d",
        "zoom",
        "-webkit-clip-path",
        "-webkit-mask",
        "-webkit-mask-image",
        "-webkit-transform",
        "all",
        "animation",
        "animation-name",
        "offset",
        "content-visibility",
    )
)
ATTRIBUTES = (INHERITED - {"marker"}) | GEOMETRY | _OWN_ATTRIBUTES
PROPERTIES = ATTRIBUTES | _CSS_ALONE | {"marker"}

_IGNORED_RULES = ("charset", "font-face", "namespace", "keyframes", "page", "counter-style")
_SHOWN_MEDIA = ("", "all", "screen", "only screen")
_NOT_SHOWN_MEDIA = ("print", "speech", "not all", "only print", "not screen")
_COMPARES_SIBLINGS = re.compile(r"~(?!=)|:nth-|:has\(", re.IGNORECASE)
MOST_SIBLINGS = 2000
"""Elements of one parent where a selector compares siblings, whose cost grows with the square."""
_FUNCTIONS = re.compile(r"\b(var|env|calc|min|max|clamp|attr|if)\(", re.IGNORECASE)


class Sheet:
    """All rules of a file's style elements; owns the matcher of selectors."""

    def __init__(self) -> None:
        library: Any = require("cssselect2", "reading SVG", "svg")
        self._matcher = library.Matcher()
        self._compile: Callable[[Any], Iterable[Any]] = library.compile_selector_list
        self._compares_siblings = False
        self._error: type[Exception] = library.SelectorError

    def add(self, text: str, media: str, place: str) -> None:
        """Add a style element's rules."""
        tinycss2: Any = require("tinycss2", "reading SVG", "svg")
        if _is_shown(media, place):
            options = {"skip_comments": True, "skip_whitespace": True}
            self._add_rules(tinycss2.parse_stylesheet(text, **options), place)

    def _add_rules(self, rules: Iterable[Any], place: str) -> None:
        tinycss2: Any = require("tinycss2", "reading SVG", "svg")
        for rule in rules:
            if rule.type == "at-rule":
                self._add_at_rule(rule, place)
            elif rule.type == "qualified-rule":
                found = list(_declarations(rule.content, place))
                if not found:
                    continue
                try:
                    selectors = list(self._compile(rule.prelude))
                except self._error:
                    text = cut(tinycss2.serialize(rule.prelude).strip())
                    raise SceneError("has a selector that is not read", place, text) from None
                text = tinycss2.serialize(rule.prelude)
                self._compares_siblings |= _COMPARES_SIBLINGS.search(text) is not None
                for selector in selectors:
                    if selector.pseudo_element is None:
                        self._matcher.add_selector(selector, found)

    def _add_at_rule(self, rule: Any, place: str) -> None:
        tinycss2: Any = require("tinycss2", "reading SVG", "svg")
        name = rule.lower_at_keyword
        if name in _IGNORED_RULES:
            return
        if name != "media" or rule.content is None:
            raise SceneError(f"has a rule @{cut(name)}, which is not read", place)
        if _is_shown(tinycss2.serialize(rule.prelude), place):
            options = {"skip_comments": True, "skip_whitespace": True}
            self._add_rules(tinycss2.parse_rule_list(rule.content, **options), place)

    def declared(self, node: Node, place: str) -> dict[str, Value]:
        """Return the values that hold for an element itself, before inheritance."""
        element = node.etree_element
        if self._compares_siblings and len(node.etree_siblings) > MOST_SIBLINGS:
            raise SceneError(f"compares more than {MOST_SIBLINGS} elements by ~ or :nth-", "style")
        plain: list[tuple[str, Value]] = [
            (name, Value(element.attrib[name].strip(" \t\r\n\f"), css=False))
            for name in sorted(ATTRIBUTES.intersection(element.keys()))
            if name not in GEOMETRY or name in _GEOMETRY_OF.get(node.local_name, ())
        ]
        important: list[tuple[str, Value]] = []
        matched = [found for *_, found in self._matcher.match(node)]
        if "style" in element.attrib:
            matched.append(list(_declarations(element.attrib["style"], place)))
        for found in matched:
            for name, value, matters in found:
                (important if matters else plain).append((name, value))
        result: dict[str, Value] = {}
        for name, value in (*plain, *important):
            valid = _is_valid(name, value)
            if not valid and name in _PAINTS and "(" in value.text:
                raise SceneError(f"{name}: is a colour that is not read", place, cut(value.text))
            if valid:
                if _FUNCTIONS.search(value.text):
                    raise SceneError(f"{name}: is computed, which is not read", place, value.text)
                result[name] = value
        return result


def sheet_of(root: Node, is_svg: Callable[[Node], bool]) -> Sheet:
    """Return the rules of a document."""
    sheet = Sheet()
    for node in root.iter_subtree():
        element = node.etree_element
        kind = (element.get("type") or "text/css").strip().lower()
        if node.local_name == "style" and _is_style(node, is_svg) and kind == "text/css":
            sheet.add("".join(element.itertext()), element.get("media") or "", "style")
    return sheet


def _is_style(node: Node, is_svg: Callable[[Node], bool]) -> bool:
    """Return whether viewers read the style of an element: one of XHTML counts, too."""
    return is_svg(node) or node.namespace_url == "http://www.w3.org/1999/xhtml"


def computed(own: Values, parent: Values) -> Values:
    """Return an element's values after inheritance; a property without value has its default."""
    result = {name: value for name, value in parent.items() if name in INHERITED}
    for name, value in own.items():
        word = value.text.lower()
        if word == "inherit" or (word == "unset" and name in INHERITED):
            if name in parent:
                result[name] = parent[name]
            else:
                result.pop(name, None)
        elif word in ("initial", "unset", "revert", "revert-layer"):
            result.pop(name, None)
        else:
            result[name] = value
            if name == "marker":
                result.update(dict.fromkeys(("marker-start", "marker-mid", "marker-end"), value))
    return result


def word_of(values: Values, name: str, default: str) -> str:
    """Return a property's text in lower case."""
    value = values.get(name)
    return default if value is None else value.text.lower()


def _declarations(content: Any, place: str) -> Iterator[tuple[str, Value, bool]]:
    """Yield name, value and importance of the declarations that the reader knows."""
    tinycss2: Any = require("tinycss2", "reading SVG", "svg")
    options = {"skip_comments": True, "skip_whitespace": True}
    for item in tinycss2.parse_blocks_contents(content, **options):
        if item.type in ("qualified-rule", "at-rule"):
            raise SceneError("has a rule inside a rule, which is not read", place)
        if item.type == "declaration" and item.lower_name in PROPERTIES:
            kept = [token for token in item.value if token.type != "comment"]
            value = Value(tinycss2.serialize(kept).strip(), css=True)
            yield item.lower_name, value, item.important


def _is_shown(media: str, place: str) -> bool:
    """Return whether rules for a medium hold on a screen."""
    words = [" ".join(part.split()).lower() for part in media.split(",")]
    unknown = [word for word in words if word not in (*_SHOWN_MEDIA, *_NOT_SHOWN_MEDIA)]
    if unknown:
        raise SceneError("has rules for a medium that is not read", place, cut(unknown[0]))
    return any(word in _SHOWN_MEDIA for word in words)


_KEYWORDS = {
    "fill-rule": ("nonzero", "evenodd"),
    "visibility": ("visible", "hidden", "collapse"),
    "display": (
        "none",
        "inline",
        "block",
        "inline-block",
        "list-item",
        "contents",
        "flow-root",
        "flex",
        "inline-flex",
        "grid",
        "inline-grid",
        "table",
        "inline-table",
        "table-row",
        "table-cell",
        "table-row-group",
        "table-header-group",
        "table-footer-group",
        "table-column",
        "table-column-group",
        "table-caption",
        "ruby",
        "math",
    ),
    "overflow": ("visible", "hidden", "scroll", "auto", "clip"),
}
_PAINTS = ("fill", "stroke", "color", "stop-color")
_WIDE = ("inherit", "initial", "unset", "revert", "revert-layer")


def _is_valid(name: str, value: Value) -> bool:
    """Return whether a value counts; CSS ignores a declaration whose value it does not know."""
    word = value.text.lower()
    if not word:
        return name in ("d", "transform")
    if word in _WIDE or _FUNCTIONS.search(word):
        return value.css or name != "transform"
    if name in _KEYWORDS:
        return word in _KEYWORDS[name]
    if name in _PAINTS:
        return is_paint(value.text)
    if name.endswith("opacity"):
        return opacity(word) is not None
    return True


def is_paint(text: str) -> bool:
    """Return whether a text is a colour, a reference or a keyword of ``fill``."""
    color4: Any = require("tinycss2.color4", "reading SVG", "svg")
    word = text.lower()
    known = word in ("none", "context-fill", "context-stroke") or word.startswith("url(")
    return known or color4.parse_color(text) is not None


def opacity(text: str) -> float | None:
    """Return an opacity, written as number or percentage; None if it is neither."""
    try:
        return float(text.removesuffix("%")) / (100 if text.endswith("%") else 1)
    except ValueError:
        return None
