"""A figure of a drawing: closed outlines, and the rule that says what is inside them."""

from __future__ import annotations

from dataclasses import dataclass

from planar_planner.formats.outlines.curves import Outline

EVENODD = "evenodd"
NONZERO = "nonzero"


@dataclass(frozen=True)
class Figure:
    """Closed outlines that belong together: an outer one and holes.

    Attributes
    ----------
    outlines : tuple of Outline
        In the drawing's coordinates, y upwards.
    rule : {"evenodd", "nonzero"}
        What is inside.
    place : str
        For messages.
    """

    outlines: tuple[Outline, ...]
    rule: str
    place: str
