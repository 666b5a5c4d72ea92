"""What ``ompl_compare.py`` measured: entries, the last table, progress, rows of the CSV."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from planar_planner.ompl.compare import OurRun, SamplerRun
from planar_planner.ompl.comparison import Rows, spread

SOUND = 0.95  # least share of sound paths with which a time counts
MS = 1e3
LOST = " LOST"  # mark of a time of ours that is longer than the best of OMPL's over the same span
BEHIND = " behind"  # the same against theirs without preparation
VERDICT_HEADINGS = (
    *("scene", "ours", "ms", "quartiles", "best of OMPL", "ms", "ours/best"),
    *("best without preparation", "ms", "ours/best, theirs without preparation", "export, ms"),
)


@dataclass(frozen=True)
class Entry:
    """One planner on one scene: `source` is ``ours``, ``wheel`` or ``native``.

    `seconds` are from the scene's polygons in memory, `solving` those without a sampler's
    preparation, both infinite without an answer; `exporting` is of our certificate.
    """

    scene: str
    source: str
    planner: str
    resolution: float | None
    seconds: tuple[float, ...]
    solving: tuple[float, ...]
    exporting: tuple[float, ...]
    checks: tuple[int, ...]
    lengths: tuple[float, ...]
    soundness: tuple[str, ...]

    @property
    def solved(self) -> int:
        """Runs with an answer."""
        return sum(math.isfinite(value) for value in self.seconds)

    @property
    def sound(self) -> float:
        """Share of the paths that are certified free; 0 without a path."""
        return self.soundness.count("sound") / len(self.soundness) if self.soundness else 0.0

    @property
    def collide(self) -> float:
        """Share of the paths that are shown to collide."""
        return self.soundness.count("collides") / len(self.soundness) if self.soundness else 0.0


def entry_of_ours(scene: str, runs: Sequence[OurRun]) -> Entry:
    """Return ours as an entry."""
    decided = [run.verdict != "undecided" for run in runs]
    return Entry(
        scene,
        "ours",
        runs[0].verdict,
        None,
        tuple(r.seconds if ok else math.inf for r, ok in zip(runs, decided, strict=True)),
        (),
        tuple(run.certificate_seconds for run in runs),
        (),
        tuple(run.length for run in runs if run.verdict == "path"),
        tuple(run.soundness for run in runs if run.verdict == "path"),
    )


def entry_of(scene: str, source: str, resolution: float, runs: Sequence[SamplerRun]) -> Entry:
    """Return a sampler as an entry; a run that failed is told of at once."""
    for run in runs:
        if run.error:
            print(f"  {source} {run.planner}, seed {run.seed}: {run.error}", file=sys.stderr)
    exact = [run for run in runs if run.exact]
    return Entry(
        scene,
        source,
        runs[0].planner,
        resolution,
        tuple(run.total_seconds for run in runs),
        tuple(run.seconds for run in runs),
        (),
        tuple(run.checks for run in runs),
        tuple(run.length for run in exact),
        tuple(run.soundness for run in exact),
    )


def median(entry: Entry) -> float:
    """Return the median time from the scene's polygons in memory."""
    return spread(entry.seconds).median


def median_solving(entry: Entry) -> float:
    """Return a sampler's median time without its preparation."""
    return spread(entry.solving).median


def best_of_ompl(found: Sequence[Entry], time_of: Callable[[Entry], float]) -> Entry | None:
    """Return the sampler with the least time among those whose paths are sound enough."""
    fit = [
        entry
        for entry in found
        if entry.source != "ours" and entry.sound >= SOUND and math.isfinite(time_of(entry))
    ]
    return min(fit, key=time_of, default=None)


def verdict_rows(found: Sequence[Entry]) -> Rows:
    """Return the last table: per scene, ours beside the best of OMPL by either reading."""
    rows: Rows = [VERDICT_HEADINGS]
    for scene in dict.fromkeys(entry.scene for entry in found):
        here = [entry for entry in found if entry.scene == scene]
        ours = next(entry for entry in here if entry.source == "ours")
        mine = spread(ours.seconds)
        quartiles = f"{MS * mine.lower:.3g} to {MS * mine.upper:.3g}"
        rows.append(
            (
                *(scene, ours.planner, f"{MS * mine.median:.3g}", quartiles),
                *beside(mine.median, best_of_ompl(here, median), median, LOST),
                *beside(mine.median, best_of_ompl(here, median_solving), median_solving, BEHIND),
                f"{MS * spread(ours.exporting).median:.3g}",
            )
        )
    return rows


def beside(
    ours: float, best: Entry | None, time_of: Callable[[Entry], float], mark: str
) -> tuple[str, str, str]:
    """Return the best sampler, its time, and ours over it, marked where ours is longer."""
    if best is None:
        return "none", "-", ""
    theirs = time_of(best)
    name = f"{best.planner} {best.source} {best.resolution:g}"
    return name, f"{MS * theirs:.3g}", f"{ours / theirs:.2f}{mark if ours > theirs else ''}"


def line_of(entry: Entry) -> str:
    """Return one entry as a line of progress."""
    times = spread(entry.seconds)
    share = f"sound {100 * entry.sound:3.0f} %" if entry.soundness else ""
    resolution = "" if entry.resolution is None else f"{entry.resolution:g}"
    return (
        f"{entry.scene:<18} {entry.source:<7} {entry.planner:<12} {resolution:<6} "
        f"{entry.solved:>2}/{len(entry.seconds):<3} {MS * times.median:>10.4g} ms  {share}"
    )


def figures(seconds: Sequence[float]) -> tuple[str, str, str]:
    """Return median and quartiles as the CSV file has them."""
    times = spread(seconds)
    return f"{times.median:.6g}", f"{times.lower:.6g}", f"{times.upper:.6g}"


def csv_row(entry: Entry) -> tuple[object, ...]:
    """Return one entry as a row of the CSV file; an infinite time is a run to the limit."""
    return (
        entry.scene,
        entry.source,
        entry.planner,
        "" if entry.resolution is None else entry.resolution,
        len(entry.seconds),
        entry.solved,
        *figures(entry.seconds),
        *(figures(entry.solving) if entry.solving else ("", "", "")),
        f"{spread(entry.exporting).median:.6g}" if entry.exporting else "",
        f"{spread(entry.checks).median:.0f}" if entry.checks else "",
        f"{spread(entry.lengths).median:.6g}" if entry.lengths else "",
        f"{entry.sound:.3f}" if entry.soundness else "",
        f"{entry.collide:.3f}" if entry.soundness else "",
    )


HEADER = (
    *("scene", "source", "planner", "resolution", "runs", "solved"),
    *("median_s", "lower_s", "upper_s", "solving_median_s", "solving_lower_s", "solving_upper_s"),
    *("exporting_median_s", "checks", "length", "sound", "collide"),
)
