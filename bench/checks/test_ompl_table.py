"""The last table of ``ompl_compare.py``: which sampler is the best, and what is marked."""

from __future__ import annotations

import math
from typing import Any

from parts.ompl.table import (
    HEADER,
    VERDICT_HEADINGS,
    Entry,
    best_of_ompl,
    csv_row,
    entry_of,
    entry_of_ours,
    median,
    median_solving,
    verdict_rows,
)
from planar_planner.ompl.compare import OurRun, SamplerRun


def sampler(planner: str, preparing: float, solving: float, **changes: Any) -> Entry:
    values: dict[str, Any] = {
        "planner": planner,
        "seed": 1,
        "exact": True,
        "prepare_seconds": preparing,
        "seconds": solving,
        "checks": 9,
        "length": 4.0,
        "turning": 1.0,
        "soundness": "sound",
        "check_ns": 400.0,
        "native_check_ns": 100.0,
    }
    return entry_of("small", "native", 0.002, [SamplerRun(**(values | changes))])


def ours(seconds: float) -> Entry:
    run = OurRun("path", "certified", seconds, seconds, 0.25, 10, 3.0, 0.0, "sound")
    return entry_of_ours("small", [run])


QUICK_TO_SOLVE = sampler("PRM", 3.0, 1.0)
QUICK_TO_PREPARE = sampler("RRTConnect", 0.5, 2.0)
UNSOUND = sampler("KPIECE1", 0.0, 0.001, soundness="collides")
UNSOLVED = sampler("EST", 0.0, math.inf, exact=False, soundness="")
SAMPLERS = [QUICK_TO_SOLVE, QUICK_TO_PREPARE, UNSOUND, UNSOLVED]


def test_the_best_differs_with_and_without_preparation_and_is_sound() -> None:
    assert best_of_ompl(SAMPLERS, median) is QUICK_TO_PREPARE
    assert best_of_ompl(SAMPLERS, median_solving) is QUICK_TO_SOLVE
    assert best_of_ompl([UNSOUND, UNSOLVED, ours(0.1)], median) is None


def row(seconds: float) -> dict[str, str]:
    headings, cells = verdict_rows([ours(seconds), *SAMPLERS])
    assert headings == VERDICT_HEADINGS
    assert len(cells) == len(headings)
    return dict(zip(headings, cells, strict=True))


def test_each_reading_has_its_own_mark() -> None:
    same, harsher = "ours/best", "ours/best, theirs without preparation"
    assert (row(0.5)[same], row(0.5)[harsher]) == ("0.20", "0.50")
    assert (row(2.0)[same], row(2.0)[harsher]) == ("0.80", "2.00 behind")
    assert (row(5.0)[same], row(5.0)[harsher]) == ("2.00 LOST", "5.00 behind")
    assert row(5.0)["export, ms"] == "250"


def test_rows_of_the_csv_hold_both_readings() -> None:
    found = dict(zip(HEADER, csv_row(QUICK_TO_SOLVE), strict=True))
    assert (found["median_s"], found["solving_median_s"]) == ("4", "1")
    assert found["exporting_median_s"] == ""
    found = dict(zip(HEADER, csv_row(ours(2.0)), strict=True))
    assert (found["median_s"], found["solving_median_s"]) == ("2", "")
    assert found["exporting_median_s"] == "0.25"
