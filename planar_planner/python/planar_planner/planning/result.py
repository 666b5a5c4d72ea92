"""The three verdicts, and their form as JSON."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, NoReturn, cast

import numpy as np
from numpy.typing import NDArray

from planar_planner._core import Seconds, Statistics
from planar_planner.frozen_arrays import FrozenArrays, freeze
from planar_planner.planning.outcome import StopReason, sentence_of
from planar_planner.planning.result_text import result_html, result_line
from planar_planner.scene.import_report import NOT_IMPORTED, ImportReport

__all__ = ["NoPath", "PathFound", "Result", "Seconds", "Statistics", "Undecided", "make_result"]

FORMAT = "planar-planner/result"
VERSION = 1


@dataclass(frozen=True, eq=False, repr=False)
class _Answer(FrozenArrays):
    """What the three verdicts share.

    Two results are equal if verdict, scene, reason and path are, every number exactly; counts,
    times and certificates are not compared. A result has no truth value.

    Attributes
    ----------
    scene : str
        Name of the scene.
    reason : str
        What the verdict rests on, in words: for a path or its absence how it was found, for an
        undecided query why it stayed so. Words may change: programs ask `stop_reason`, or
        `stats.decided_by`.
    path : NDArray, shape (N, 3)
        Waypoints (x, y, theta), theta in radians and unwrapped; N = 0 without a path.
    stats : Statistics
        Counts and times; all zero if the query ran out of memory.
    certificate : dict or None
        The evidence as a JSON object (docs/certificate.md), if it was asked for and the query is
        decided.
    stop_reason : StopReason or None
        Why an undecided query stayed so.
    imported : ImportReport
        What an importer did to the scene's geometry, and for which verdict the answer also holds
        for the curves of its file.
    decimal_places : int or None
        The answer holds for the scene's lengths as the decimals of so many places that they are
        written as, because it rests on contact. Waypoints are then rounded to doubles where they
        are no such decimals; the certificate has them exactly. None: it holds for the doubles.
    """

    verdict: ClassVar[str]
    scene: str
    reason: str
    path: NDArray[np.float64]
    stats: Statistics
    certificate: dict[str, Any] | None = None
    stop_reason: StopReason | None = None
    imported: ImportReport = NOT_IMPORTED
    decimal_places: int | None = None

    @property
    def path_length(self) -> float:
        """Length of the way of the reference point, in the scene's unit; 0 without a path."""
        return float(np.hypot(*np.diff(self.path[:, :2], axis=0).T).sum())

    @property
    def least_clearance(self) -> float:
        """Lower bound, certified, on the robot's distance from everything along the path.

        In the scene's unit; infinite if there is nothing to touch, 0 without a path.
        """
        return self.stats.least_clearance

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _Answer):
            return NotImplemented
        same = (self.verdict, self.scene, self.reason) == (other.verdict, other.scene, other.reason)
        return same and np.array_equal(self.path, other.path)

    def __hash__(self) -> int:
        return hash((self.verdict, self.scene, self.reason, len(self.path)))

    def __bool__(self) -> NoReturn:
        """Refuse: every result would be true, proofs of absence too."""
        raise TypeError(
            "a result is neither true nor false; compare result.verdict with 'path', 'no_path' or "
            "'undecided'"
        )

    def __repr__(self) -> str:
        return result_line(cast("Result", self))

    def _repr_html_(self) -> str:
        """Return a table for notebooks."""
        return result_html(cast("Result", self))

    def to_json(self) -> dict[str, Any]:
        """Return the result as a JSON object: plain, finite values only, others as null."""
        return {
            "format": FORMAT,
            "version": VERSION,
            "scene": self.scene,
            "verdict": self.verdict,
            "reason": self.reason,
            "stop_reason": self.stop_reason,
            "path": self.path.tolist(),
            "stats": _plain(self.stats.to_dict()),
            **({} if self.decimal_places is None else {"decimal_places": self.decimal_places}),
            **self.imported.to_json(),
        }


class PathFound(_Answer):
    """A path, certified free along its whole length; linear in (x, y, theta) between waypoints."""

    verdict = "path"


class NoPath(_Answer):
    """Proof that there is none: cells and faces wholly in collision separate start from goal."""

    verdict = "no_path"


class Undecided(_Answer):
    """A limit was reached, or the user stopped the search, before either could be shown."""

    verdict = "undecided"


Result = PathFound | NoPath | Undecided

_VERDICTS: Mapping[str, type[PathFound] | type[NoPath] | type[Undecided]] = {
    answer.verdict: answer for answer in (PathFound, NoPath, Undecided)
}


def make_result(
    scene: str,
    answer: Mapping[str, Any],
    certificate: dict[str, Any] | None = None,
    imported: ImportReport | None = None,
    decimal_places: int | None = None,
) -> Result:
    """Build the result from the core's answer."""
    path = np.array(answer["path"], dtype=np.float64).reshape(-1, 3)
    kind = _VERDICTS[answer["verdict"]]
    reason = sentence_of(answer)
    result = kind(
        scene,
        reason,
        path,
        answer["stats"],
        certificate,
        answer["stop_reason"],
        imported or NOT_IMPORTED,
        decimal_places,
    )
    freeze(result)
    return result


def _plain(value: Any) -> Any:
    """Return `value` in JSON's own types; a clearance to nothing (infinite) becomes null."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (np.ndarray, np.generic)):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
