"""What `planar_planner.margin` answers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal, NoReturn

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import shown
from planar_planner.frozen_arrays import FrozenArrays
from planar_planner.margins.surroundings import NearestPoints
from planar_planner.scene.import_report import NOT_IMPORTED, ImportReport

FORMAT = "planar-planner/margin"
VERSION = 1

By = Literal["offset", "scale"]
Binding = Literal["way", "start", "goal", "size", "none"]


@dataclass(frozen=True)
class NarrowPlace:
    """Where the largest robot that passes has least room; computed in plain doubles, not proven.

    Attributes
    ----------
    configuration : (x, y, theta)
        Configuration of the robot.
    clearance : float
        Distance of the robot, at the margin's lower end, from what is nearest; offsets of at least
        0: of the robot as it is.
    contacts : tuple of NearestPoints
        What it is nearest to, nearest first.
    """

    configuration: tuple[float, float, float]
    clearance: float
    contacts: tuple[NearestPoints, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Margin(FrozenArrays):
    """A bracket of the largest robot for which a path remains, both ends proven.

    Two margins are equal if all but `counts` and `seconds` is, every number exactly. A margin has
    no truth value.

    Attributes
    ----------
    scene : str
        Name of the scene.
    by : {"offset", "scale"}
        What a margin is: a distance by which the robot is grown (negative: shrunk), in the scene's
        unit, or the factor by which it is scaled.
    lower, upper : float
        A path is certified for the robot of margin `lower`, and proven absent for that of margin
        `upper`. At `lower` a robot without area is free everywhere. Infinite if there is nothing to
        touch.
    width : float
        What ``upper - lower`` was to come down to.
    monotone : bool
        Whether larger margins are larger robots. If not (scaling a robot that is not star-shaped
        about the centre), a path may come back above `upper`.
    reason : str
        Empty if the bracket is as narrow as asked for; else the limit that was reached.
    binding : {"way", "start", "goal", "size", "none"}
        What bounds the margin from above: no way through, start or goal collide, "size" if only a
        robot shrunk to nothing passes, "none" if nothing does.
    start_clearance, goal_clearance : float
        Distance of the robot as it is from what is nearest to it there, rounded.
    narrow_place : NarrowPlace or None
        None if there is none, or no path was found.
    path : NDArray, shape (N, 3)
        For the margin `lower`; N = 0 if that is a robot without area.
    robot_lower, robot_upper : dict or None
        GeoJSON of the polygons that were asked about. `robot_lower` has the path; that the path's
        clearance from it adds up to `lower` is counted in. `robot_upper` has none, and is inside
        the robot of margin `upper`; None if `upper` follows from the clearance of an end.
    counts : mapping
        `queries` to the planner, `recertified` paths that saved one, `bodies` made, `undecided`
        queries, `cells` in all.
    seconds : float
        Wall-clock time.
    imported : ImportReport
        What an importer did to the scene's geometry. If its `holds_for` is ``path``, only `lower`
        is also proven for the curves of the file; if it is ``no_path``, only `upper` is.
    decimal_places : int or None
        It holds for the scene's lengths as decimals of so many places, because the robot as it is
        touches; path and robots are rounded to doubles. None: it holds for the doubles.
    """

    scene: str
    by: By
    lower: float
    upper: float
    width: float
    monotone: bool
    reason: str
    binding: Binding
    start_clearance: float
    goal_clearance: float
    narrow_place: NarrowPlace | None
    path: NDArray[np.float64]
    robot_lower: dict[str, Any] | None
    robot_upper: dict[str, Any] | None
    counts: Mapping[str, int]
    seconds: float
    imported: ImportReport = NOT_IMPORTED
    decimal_places: int | None = None

    @property
    def neutral(self) -> float:
        """The margin that the robot as it is has: 0, or the factor 1."""
        return 1.0 if self.by == "scale" else 0.0

    @property
    def verdict(self) -> str:
        """Say of the robot as it is: "path", "no_path", or "undecided" if the bracket holds it."""
        if self.lower >= self.neutral:
            return "path"
        return "no_path" if self.upper <= self.neutral else "undecided"

    @property
    def decided(self) -> bool:
        """Whether the bracket is as narrow as asked for and says which side the robot is on."""
        return not self.reason and self.verdict != "undecided"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Margin):
            return NotImplemented
        return self._compared() == other._compared()

    def __hash__(self) -> int:
        return hash((self.scene, self.by, self.lower, self.upper))

    def __bool__(self) -> NoReturn:
        """Refuse: every margin would be true, one that lets nothing pass too."""
        raise TypeError("a margin is neither true nor false; compare margin.verdict, or its ends")

    def __repr__(self) -> str:
        end = f", {shown(self.reason)}" if self.reason else ""
        return (
            f"<Margin {shown(self.scene)}: by {self.by}, [{self.lower:.6g}, {self.upper:.6g}], "
            f"{self.verdict}{end}>"
        )

    def _compared(self) -> dict[str, Any]:
        return self.to_json() | {"counts": None, "seconds": None}

    def to_json(self) -> dict[str, Any]:
        """Return the margin as a JSON object: plain, finite values only, others as null."""
        return {
            "format": FORMAT,
            "version": VERSION,
            "scene": self.scene,
            "by": self.by,
            "lower": _finite(self.lower),
            "upper": _finite(self.upper),
            "width": self.width,
            "monotone": self.monotone,
            "verdict": self.verdict,
            "decided": self.decided,
            "reason": self.reason,
            "binding": self.binding,
            "start_clearance": _finite(self.start_clearance),
            "goal_clearance": _finite(self.goal_clearance),
            "narrow_place": None if self.narrow_place is None else asdict(self.narrow_place),
            "path": self.path.tolist(),
            "robot_lower": self.robot_lower,
            "robot_upper": self.robot_upper,
            "counts": dict(self.counts),
            "seconds": self.seconds,
            **({} if self.decimal_places is None else {"decimal_places": self.decimal_places}),
            **self.imported.to_json(),
        }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
