"""What a reader hands over, and what the user asked of it. Plain structs.

Lengths are in the file's unit, angles in radians, anticlockwise, x to the right and y upwards.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from planar_planner.scene.fields import Box, Configuration

Point = tuple[float, float]
Ring = list[Point]
"""Vertices without a repeated last one."""
Shape = list[Ring]
"""Outer ring, then holes; valid as the planner demands, or checked by its gate."""

OUTWARDS = "outwards"
INWARDS = "inwards"


@dataclass(frozen=True)
class ImportOptions:
    """What the command line says of files in outside formats.

    Attributes
    ----------
    start, goal : list of float, optional
        ``[x, y, theta]`` in the file's frame, instead of what the file says.
    robot : Path, optional
        File that the robot is taken from.
    footprint : str, optional
        Nav2's ``[[x, y], …]``, the robot's outline.
    padding : float, optional
        Nav2's ``footprint_padding``, in the file's unit.
    unknown : bool
        Unknown cells of an occupancy map are obstacles.
    flatten : str
        ``outwards``: a path found holds for the curves. ``inwards``: a proof of none does.
    tolerance : float, optional
        Farthest that a flattened outline may be from its curve, in the file's unit.
    roles : tuple of (pattern, role)
        Which layers, ids, classes or labels are what; before the names that are known anyway.
    """

    start: list[float] | None = None
    goal: list[float] | None = None
    robot: Path | None = None
    footprint: str | None = None
    padding: float | None = None
    unknown: bool = False
    flatten: str = OUTWARDS
    tolerance: float | None = None
    roles: tuple[tuple[str, str], ...] = ()


@dataclass
class Notes:
    """What was done to a file's geometry; the only state that readers share.

    `counts` has things that happen many times, `lines` those that happen once.
    """

    counts: Counter[str] = field(default_factory=Counter)
    lines: list[str] = field(default_factory=list)

    def count(self, what: str, times: int = 1) -> None:
        """Count `what`, which reads after a number: ``repeated vertices dropped``."""
        if times:
            self.counts[what] += times

    def say(self, line: str) -> None:
        """Add a line once."""
        if line not in self.lines:
            self.lines.append(line)

    def as_lines(self) -> tuple[str, ...]:
        """Return all notes, one a line."""
        return (*self.lines, *(f"{what}: {times}" for what, times in self.counts.items()))


@dataclass
class Parts:
    """A file's content. None means that the file does not say.

    Attributes
    ----------
    obstacles : list of Shape
        World frame.
    robot : list of Shape, optional
        In the robot's frame, whose origin is the reference point.
    workspace : Shape, optional
        World frame; the whole robot stays inside.
    workspace_box : box, optional
        The same as (xmin, ymin, xmax, ymax).
    reference_bounds : box, optional
        The reference point stays inside.
    start, goal : configuration, optional
        Of the robot's frame in the world.
    rotation : bool
        Whether the robot may turn.
    name : str
        Empty if the file does not say.
    description : str
        One sentence for people.
    holds_for : str
        The verdict that carries over to the file's curves, ``path`` or ``no_path``; empty: both.
    """

    obstacles: list[Shape] = field(default_factory=list)
    robot: list[Shape] | None = None
    workspace: Shape | None = None
    workspace_box: Box | None = None
    reference_bounds: Box | None = None
    start: Configuration | None = None
    goal: Configuration | None = None
    rotation: bool = True
    name: str = ""
    description: str = ""
    holds_for: str = ""
