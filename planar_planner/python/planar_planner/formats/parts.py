"""The input and output of readers, as plain structs.

Lengths are in the file's unit; angles are in radians, anticlockwise; x points right and y upwards.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from planar_planner.errors import cut
from planar_planner.scene.fields import Box, Configuration

Point = tuple[float, float]
Ring = list[Point]
"""Vertices without a repeated last one."""
Shape = list[Ring]
"""The outer ring, then holes; either valid as the planner requires, or checked by its gate."""

OUTWARDS = "outwards"
INWARDS = "inwards"
_SHOWN_NAMES = 20  # names of layers or ids that a message lists


@dataclass(frozen=True)
class ImportOptions:
    """Options for files in other formats.

    Attributes
    ----------
    start, goal : list of float, optional
        ``[x, y, theta]`` in the file's frame, used instead of the file's own.
    robot : Path, optional
        File that contains the robot.
    footprint : str, optional
        Nav2's ``[[x, y], …]``, the robot's outline.
    padding : float, optional
        Nav2's ``footprint_padding``, in the file's unit.
    unknown : bool
        Whether unknown cells of an occupancy map are obstacles.
    flatten : str
        ``outwards``: a path holds for the curves too. ``inwards``: a proof of no path does.
    tolerance : float, optional
        Greatest distance of a flattened outline from its curve, in the file's unit.
    join : float, optional
        Ends of a drawing's lines up to this far apart are joined, in the file's unit.
    roles : tuple of (pattern, role)
        Roles of layers, ids, classes or labels; they come before the known names.
    allow_empty : bool
        Whether a file without obstacles is taken; it is refused otherwise.
    only_robot : bool
        Whether the file is read for its robot alone; a drawing's only shape then needs no role.
    """

    start: list[float] | None = None
    goal: list[float] | None = None
    robot: Path | None = None
    footprint: str | None = None
    padding: float | None = None
    unknown: bool = False
    flatten: str = OUTWARDS
    tolerance: float | None = None
    join: float | None = None
    roles: tuple[tuple[str, str], ...] = ()
    allow_empty: bool = False
    only_robot: bool = False


@dataclass
class Notes:
    """Notes on changes of a file's geometry; they are the only state that readers share.

    `counts` holds changes that occur many times, `lines` those that occur once. `passed_over` is
    the number of things in the file that became nothing, and `unknown_names` are their names.
    `hints` are those of the lines that name an option which makes more of the file.
    """

    counts: Counter[str] = field(default_factory=Counter)
    lines: list[str] = field(default_factory=list)
    passed_over: int = 0
    unknown_names: dict[str, None] = field(default_factory=dict)
    hints: list[str] = field(default_factory=list)

    def count(self, what: str, times: int = 1) -> None:
        """Count `what`, which reads after a number: ``repeated vertices dropped``."""
        if times:
            self.counts[what] += times

    def pass_over(self, what: str, names: Iterable[str] = (), times: int = 1) -> None:
        """Count things that become nothing; `names` are the layers, ids or roles that they have."""
        self.count(what, times)
        self.passed_over += times
        self.unknown_names.update(dict.fromkeys(name for name in names if name))

    def say(self, line: str) -> None:
        """Add a line once."""
        if line not in self.lines:
            self.lines.append(line)

    def hint(self, line: str) -> None:
        """Add a line that an error about an empty file repeats."""
        self.say(line)
        self.hints.append(line)

    def names_met(self) -> str:
        """Return a clause on the names that have no role; empty if there are none."""
        if not self.unknown_names:
            return ""
        names = [cut(repr(name)) for name in self.unknown_names]
        more = f" and {len(names) - _SHOWN_NAMES} more" if len(names) > _SHOWN_NAMES else ""
        return f"; names without a role: {', '.join(names[:_SHOWN_NAMES])}{more}"

    def as_lines(self) -> tuple[str, ...]:
        """Return all notes, one per line."""
        return (*self.lines, *(f"{what}: {times}" for what, times in self.counts.items()))


@dataclass
class Parts:
    """A file's content. None means that the file does not state it.

    Attributes
    ----------
    obstacles : list of Shape
        World frame; `add_obstacles` adds some with a name.
    obstacle_names : dict of int to str
        What the file calls an obstacle (its id, layer, feature or line), by its index; those of
        which the file says nothing have none.
    robot : list of Shape, optional
        In the robot's frame, whose origin is the reference point.
    workspace : Shape, optional
        World frame; the whole robot stays inside.
    workspace_box : box, optional
        The same as (xmin, ymin, xmax, ymax).
    reference_bounds : box, optional
        The reference point stays inside.
    bounds_are_chosen : bool
        Whether the reference bounds stand for the unbounded plane, because the file states none.
    start, goal : configuration, optional
        Configuration of the robot's frame in the world.
    rotation : bool
        Whether the robot may turn.
    name : str
        Empty if the file states no name.
    description : str
        One sentence for people.
    holds_for : str
        The verdict that also holds for the file's curves, ``path`` or ``no_path``; empty if both
        do.
    """

    obstacles: list[Shape] = field(default_factory=list)
    robot: list[Shape] | None = None
    workspace: Shape | None = None
    workspace_box: Box | None = None
    reference_bounds: Box | None = None
    bounds_are_chosen: bool = False
    start: Configuration | None = None
    goal: Configuration | None = None
    rotation: bool = True
    name: str = ""
    description: str = ""
    holds_for: str = ""
    obstacle_names: dict[int, str] = field(default_factory=dict)

    def add_obstacles(self, shapes: Iterable[Shape], name: str) -> None:
        """Add shapes that the file calls by one name."""
        for shape in shapes:
            if name:
                self.obstacle_names[len(self.obstacles)] = name
            self.obstacles.append(shape)
