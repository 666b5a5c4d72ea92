"""Results of a comparison: medians with quartiles, the table, the JSON object. Needs no OMPL."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planar_planner.ompl.compare import OurRun, SamplerRun, SceneComparison, Settings

FORMAT = "planar-planner/comparison"
VERSION = 2

_HEADINGS = (
    "planner",
    "success",
    "time, ms",
    "quartiles",
    "checks",
    "length",
    "sound",
    "collide",
)
_LEFT = (0, 3)  # columns aligned to the left

Rows = list[tuple[str, ...]]


@dataclass(frozen=True)
class Spread:
    """Median and quartiles; infinite where they fall on runs without an answer."""

    lower: float
    median: float
    upper: float


def spread(values: Iterable[float]) -> Spread:
    """Return median and quartiles of at least one value, by linear interpolation."""
    ordered = sorted(values)

    def at(part: float) -> float:
        place = part * (len(ordered) - 1)
        below, above = ordered[math.floor(place)], ordered[math.ceil(place)]
        if below == above or math.isinf(above):
            return above if place > math.floor(place) else below
        return below + (place - math.floor(place)) * (above - below)

    return Spread(at(0.25), at(0.5), at(0.75))


def table(comparison: SceneComparison, settings: Settings) -> str:
    """Return the runs on a scene as text: this planner, each sampler, and remarks."""
    rows: Rows = [_HEADINGS, _our_row(comparison.ours, settings)]
    rows += [
        _sampler_row(name, runs, settings) for name, runs in comparison.samplers.items() if runs
    ]
    return "\n".join([comparison.scene, *aligned(rows), *(f"  {n}" for n in _notes(comparison))])


def aligned(rows: Rows) -> list[str]:
    """Return the rows as lines of columns."""
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return [
        "  "
        + "  ".join(
            cell.ljust(width) if k in _LEFT else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]


def _our_row(runs: Sequence[OurRun], settings: Settings) -> tuple[str, ...]:
    decided = [run for run in runs if run.verdict != "undecided"]
    paths = [run for run in runs if run.verdict == "path"]
    times = [run.seconds if run.verdict != "undecided" else math.inf for run in runs]
    return (
        "ours",
        f"{len(decided)}/{len(runs)}",
        *_times(times, settings),
        "0",
        _length(run.length for run in paths),
        *_soundness([run.soundness for run in paths]),
    )


def _sampler_row(name: str, runs: Sequence[SamplerRun], settings: Settings) -> tuple[str, ...]:
    exact = [run for run in runs if run.exact]
    return (
        name,
        f"{len(exact)}/{len(runs)}",
        *_times([run.total_seconds for run in runs], settings),
        f"{spread(run.checks for run in runs).median:,.0f}",
        _length(run.length for run in exact),
        *_soundness([run.soundness for run in exact]),
    )


def _times(seconds: Sequence[float], settings: Settings) -> tuple[str, str]:
    def text(value: float) -> str:
        return f"> {1e3 * settings.timeout:.0f}" if math.isinf(value) else f"{1e3 * value:.3g}"

    found = spread(seconds)
    return text(found.median), f"{text(found.lower)} to {text(found.upper)}"


def _length(lengths: Iterable[float]) -> str:
    found = list(lengths)
    return f"{spread(found).median:.4g}" if found else "-"


def _soundness(verdicts: Sequence[str]) -> tuple[str, str]:
    if not verdicts:
        return "-", "-"
    collide = verdicts.count("collides") / len(verdicts)
    return f"{verdicts.count('sound')}/{len(verdicts)}", f"{100 * collide:.0f} %"


def _notes(comparison: SceneComparison) -> list[str]:
    ours = comparison.ours
    runs = [run for each in comparison.samplers.values() for run in each]
    notes = [
        "time: from the scene's polygons in memory, preparation included, "
        "to the certified answer (ours), to the first solution (samplers)",
        f"ours: {ours[0].verdict.replace('_', ' ')} ({ours[0].reason}), {ours[0].cells:,} cells; "
        f"of the time, core {_ms(run.core_seconds for run in ours)}; not in it, "
        f"exporting the certificate {_ms(run.certificate_seconds for run in ours)}",
        f"reading and checking the scene, not in anyone's time: "
        f"{1e3 * comparison.reading_seconds:.3g} ms",
    ]
    prepared = [run.prepare_seconds for run in runs if math.isfinite(run.prepare_seconds)]
    if prepared:
        notes.append(
            f"samplers: of the time, preparation (state check, space, query) {_ms(prepared)}"
        )
    timed = [run for run in runs if math.isfinite(run.check_ns)]
    if timed:
        called = spread(run.check_ns for run in timed).median
        native = spread(run.native_check_ns for run in timed).median
        notes.append(
            f"one validity check: {native:.0f} ns, as OMPL calls it through Python {called:.0f} ns "
            f"(overhead {called - native:.0f} ns)"
        )
    if ours[0].verdict == "no_path":
        solved = sum(run.exact for run in runs)
        notes.append(
            "ours has proven that there is no path; "
            + (
                "the samplers ran to the limit without an answer"
                if solved == 0
                else f"{solved} sampler runs claim one, and every such path is wrong"
            )
        )
    failed = sorted({f"{run.planner}: {run.error}" for run in runs if run.error})
    return notes + [f"failed: {text}" for text in failed]


def _ms(seconds: Iterable[float]) -> str:
    return f"{1e3 * spread(seconds).median:.3g} ms"


def to_json(
    comparisons: Sequence[SceneComparison], settings: Settings, versions: dict[str, str]
) -> dict[str, Any]:
    """Return all runs as a JSON object; values that are not finite become null."""
    return {
        "format": FORMAT,
        "version": VERSION,
        "versions": versions,
        "settings": _finite(asdict(settings)),
        "scenes": [
            {
                "scene": each.scene,
                "reading_seconds": each.reading_seconds,
                **each.imported.to_json(),
                "ours": [_finite(asdict(run)) for run in each.ours],
                "samplers": {
                    name: [_finite(asdict(run)) for run in runs]
                    for name, runs in each.samplers.items()
                },
            }
            for each in comparisons
        ],
    }


def _finite(members: dict[str, Any]) -> dict[str, Any]:
    return {key: _plain(value) for key, value in members.items()}


def _plain(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return list(value) if isinstance(value, tuple) else value
