"""The importer's region against the second reader's: by area and by symmetric difference.

Boundaries may differ by a slack, which is the sum of what both sides state: the raster's cell, the
importer's flattening tolerance, the second reader's flattening distance. Two regions differ if the
symmetric difference holds a place farther than the slack from its own border, or if the areas
differ by more than the border's length times the slack.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from .importer import Import, imported
from .model import Drawing, Exact, Outcome, Raster, Reading, Region, Verdict

TOLD = (
    r"left out|ignored|not read|skipped|not shown|hidden|invisible|not drawn|unsupported|"
    r"not supported|frozen|switched off|clipp|mask|moved|outside|no obstacles|stroke|width|marker"
)
"""What a note says that tells of something left out."""

ROUTINE = (
    r"without a role|curves are flattened|reference_bounds are chosen|holds for|became nothing|"
    r"projected to"
)
"""Notes that every import may have and that tell of no difference."""

RAW = r"np\.\w+\(|object at 0x|Traceback|<class '"
"""Python values that a message for people must not hold."""

Reader = Callable[[Drawing], Sequence[Reading]]


def judged(drawing: Drawing, reader: Reader) -> Outcome:
    """Import a drawing, read it a second time, and compare."""
    began = time.monotonic()
    try:
        readings = reader(drawing)
    except UnreadableError as error:
        return Outcome(drawing, Verdict.SKIPPED, str(error))
    try:
        result = imported(drawing)
    except Exception as error:  # whatever escapes the importer is a finding
        detail = f"{type(error).__name__}: {error}"
        return Outcome(drawing, Verdict.CRASHED, detail, (), time.monotonic() - began)
    verdict, detail = compared(drawing, result, readings)
    return Outcome(drawing, verdict, detail, result.notes, time.monotonic() - began)


class UnreadableError(Exception):
    """The second reader cannot judge a drawing."""


def compared(drawing: Drawing, result: Import, readings: Sequence[Reading]) -> tuple[Verdict, str]:
    """Return the verdict on an import and why."""
    if result.refusal:
        raw = re.search(RAW, result.refusal)
        return (Verdict.CRASHED if raw else Verdict.REFUSED), result.refusal
    reasons = []
    matching = []
    for reading in readings:
        reason = difference(result.region, reading.truth)
        if reason:
            reasons.append(f"{reading.title}: {reason}")
        else:
            matching.append(reading)
    notes = [note for note in result.notes if not re.search(ROUTINE, note)]
    if any(_said(drawing.must_say, notes) and _said(r.must_say, notes) for r in matching):
        return Verdict.AGREED, ""
    if matching:
        missing = drawing.must_say or " or ".join(r.must_say for r in matching)
        return Verdict.UNTOLD, f"right by {matching[0].title!r}, but no note says /{missing}/"
    told = any(re.search(drawing.told or TOLD, note, re.IGNORECASE) for note in notes)
    return (Verdict.TOLD if told else Verdict.SILENT), "; ".join(reasons)


def _said(pattern: str, notes: Sequence[str]) -> bool:
    return not pattern or any(re.search(pattern, note, re.IGNORECASE) for note in notes)


def difference(region: Region, truth: Exact | Raster) -> str:
    """Return how a region differs from the truth; empty if it does not."""
    if isinstance(truth, Exact):
        return _exact_difference(region, truth)
    return _raster_difference(region, truth)


def _exact_difference(region: Region, truth: Exact) -> str:
    other = region.symmetric_difference(truth.region)
    core = other.buffer(-truth.slack, quad_segs=2)
    off = abs(region.area - truth.region.area)
    if core.is_empty and off <= truth.slack * (region.length + truth.region.length):
        return ""
    place = core.representative_point() if not core.is_empty else region.representative_point()
    where = f" at ({place.x:.6g}, {place.y:.6g})" if not place.is_empty else ""
    return (
        f"importer {region.area:.6g}, second reader {truth.region.area:.6g}, "
        f"symmetric difference {other.area:.6g}{where}"
    )


def _raster_difference(region: Region, truth: Raster) -> str:
    shapely.prepare(region)
    mine = shapely.contains_xy(region, truth.x, truth.y)
    other = mine != truth.filled
    steps = int(np.ceil(truth.slack / truth.cell)) if truth.slack > 0 else 0
    core = _eroded(other, steps)
    cell = truth.cell**2
    if not core.any() and not _grown_past(region, truth):
        return ""
    where = "the edges of cells"
    if core.any():
        i, j = np.argwhere(core)[0]
        where = f"({truth.x[i, j]:.6g}, {truth.y[i, j]:.6g})"
    return (
        f"importer {region.area:.6g}, second reader {truth.filled.sum() * cell:.6g}, "
        f"symmetric difference {other.sum() * cell:.6g} at {where}"
    )


def _grown_past(region: Region, truth: Raster) -> bool:
    """Return whether an exact grid (slack 0) shows less area than the region has.

    A painted canvas shows no more than itself; what lies outside it is not judged.
    """
    return truth.slack == 0 and region.area > truth.filled.sum() * truth.cell**2 * (1 + 1e-9)


def _eroded(flags: NDArray[np.bool_], steps: int) -> NDArray[np.bool_]:
    """Return the cells whose neighbours within `steps` are all set; the border counts as set."""
    for _ in range(steps):
        padded = np.pad(flags, 1, constant_values=True)
        flags = padded[1:-1, 1:-1].copy()
        for di in (0, 1, 2):
            for dj in (0, 1, 2):
                flags &= padded[di : di + flags.shape[0], dj : dj + flags.shape[1]]
    return flags
