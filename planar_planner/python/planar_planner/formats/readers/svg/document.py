"""What is read once a file, and what an element inherits from its parents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from planar_planner.errors import SceneError, cut
from planar_planner.formats.drawing import Drawing
from planar_planner.formats.outlines.curves import Affine
from planar_planner.formats.parts import ImportOptions, Notes
from planar_planner.formats.readers.svg.lengths import Size
from planar_planner.formats.readers.svg.style import Node, Sheet, Values
from planar_planner.formats.readers.svg.viewports import Clip
from planar_planner.formats.roles import role_of

SVG = "http://www.w3.org/2000/svg"
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
NEVER_DRAWN = frozenset(
    {
        "animate", "animateColor", "animateMotion", "animateTransform", "clipPath", "cursor",
        "defs", "desc", "filter", "font", "linearGradient", "marker", "mask", "metadata", "pattern",
        "radialGradient", "script", "set", "solidcolor", "stop", "style", "symbol", "title", "view",
    }
)  # fmt: skip
HREF = ("href", "{http://www.w3.org/1999/xlink}href")
MOST_ELEMENTS = 200_000
"""Elements that are drawn, each use of one counted; nested uses can multiply without bound."""


@dataclass(frozen=True)
class Context:
    """What an element inherits.

    Attributes
    ----------
    names : tuple of str
        Ids, labels and classes of the groups, the closest first.
    matrix : Affine
        From the element's parent into the scene, y upwards.
    values : Values
        The parent's properties.
    size : Size
        Size of the nearest viewport.
    clips : tuple of Clip
        What nested viewports cut off.
    left_out : bool
        Whether a viewer leaves out the parent.
    effect : str
        A property of a parent that is not read, and the place; empty if there is none.
    role : str, optional
        The role that a use element states for what it uses.
    using : tuple of str
        Ids of the targets of use elements above.
    """

    names: tuple[str, ...]
    matrix: Affine
    values: Values
    size: Size
    clips: tuple[Clip, ...] = ()
    left_out: bool = False
    effect: str = ""
    role: str | None = None
    using: tuple[str, ...] = ()


@dataclass
class Document:
    """A file: its style, ids and options, and the drawing that is being collected."""

    sheet: Sheet
    ids: Mapping[str, Node]
    namespace: str
    options: ImportOptions
    notes: Notes
    drawing: Drawing
    lone: list[tuple[Node, Context, str]] = field(default_factory=list)
    met: Counter[str] = field(default_factory=Counter)

    def is_svg(self, node: Node) -> bool:
        """Return whether an element is of the language of the root."""
        return bool(node.namespace_url == self.namespace)

    def role(self, names: tuple[str, ...], context: Context) -> str | None:
        """Return the role of an element with names of its own and its groups'.

        What has no name at all fits patterns that an empty name fits: ``*``.
        """
        if context.role is not None:
            return context.role
        if not names and not context.names:
            return role_of([""], self.options.roles)
        own, above = role_of(names, self.options.roles), role_of(context.names, self.options.roles)
        if own is not None and above is not None and own != above and not context.left_out:
            self.notes.count("elements that state a role of their own; that of their group ignored")
        return own if own is not None else above

    def place(self, node: Node, own: tuple[str, ...], context: Context) -> str:
        """Return what messages call an element: its id, or its number and its closest name."""
        kind = cut(node.local_name)
        self.met[kind] += 1
        if node.id:
            return f"{kind} {cut(node.id)!r}"
        closest = next(iter((*own, *context.names)), "")
        return f"{kind} {self.met[kind]}" + (f" of {cut(closest)!r}" if closest else "")


def names_of(node: Node) -> tuple[str, ...]:
    """Return id, label and classes."""
    element = node.etree_element
    own = [element.get("id"), element.get(_LABEL), *(element.get("class") or "").split()]
    return tuple(name for name in own if name)


def ids_of(root: Node) -> dict[str, Node]:
    """Return the first element of each id."""
    ids: dict[str, Node] = {}
    for node in root.iter_subtree():
        if node.id:
            ids.setdefault(node.id, node)
    return ids


def link_of(node: Node) -> str:
    """Return what an element refers to; empty if it does not."""
    attributes = node.etree_element.attrib
    return next((str(attributes[key]) for key in HREF if key in attributes), "")


def check_size(root: Node, ids: Mapping[str, Node]) -> None:
    """Raise if too many elements are drawn, by counting each element once.

    Raises
    ------
    SceneError
        If there are more than `MOST_ELEMENTS`, each use of one counted.
    """
    if _drawn(root, ids, {}) > MOST_ELEMENTS:
        raise SceneError(f"draws more than {MOST_ELEMENTS} elements")


def _drawn(node: Node, ids: Mapping[str, Node], known: dict[Node, int]) -> int:
    """Return the number of elements that a node draws; a loop of uses counts once."""
    if node not in known:
        known[node] = 1
        total = 1
        target = ids.get(link_of(node).removeprefix("#")) if node.local_name == "use" else None
        if target is not None:
            total += _drawn(target, ids, known)
        for child in node.iter_children():
            if child.local_name not in NEVER_DRAWN:
                total += _drawn(child, ids, known)
        known[node] = total
    return known[node]
