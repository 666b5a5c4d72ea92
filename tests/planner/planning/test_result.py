"""Verdicts and their JSON."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from planar_planner.cli.report import statistics
from planar_planner.planning.outcome import DecidedBy, StopReason
from planar_planner.planning.result import NoPath, PathFound, Statistics, Undecided, make_result
from planar_planner.planning.result_text import headline


def answer(verdict: str, **stats: Any) -> dict[str, Any]:
    path = [[0, 0, 0], [1, 2, 7.5]] if verdict == "path" else np.empty((0, 3))
    decided_by = {"path": DecidedBy.CHANNEL, "no_path": DecidedBy.SEPARATION}.get(verdict)
    return {
        "verdict": verdict,
        "stop_reason": StopReason.MAX_CELLS if verdict == "undecided" else None,
        "ends_moved": False,
        "exact_legs": False,
        "to_be_checked": False,
        "path": path,
        "stats": Statistics(decided_by=decided_by, **stats),
    }


@pytest.mark.parametrize(
    ("verdict", "kind"), [("path", PathFound), ("no_path", NoPath), ("undecided", Undecided)]
)
def test_each_verdict_has_its_class(verdict: str, kind: type) -> None:
    result = make_result("s", answer(verdict))
    assert type(result) is kind
    assert result.verdict == verdict
    assert result.path.shape == ((2, 3) if verdict == "path" else (0, 3))
    assert not result.path.flags.writeable


def test_json_is_exactly_the_published_object() -> None:
    content = make_result("s", answer("path", cells=3)).to_json()
    assert content == {
        "format": "planar-planner/result",
        "version": 1,
        "scene": "s",
        "verdict": "path",
        "reason": "certified through a channel of cells",
        "stop_reason": None,
        "path": [[0.0, 0.0, 0.0], [1.0, 2.0, 7.5]],
        "stats": Statistics(cells=3, decided_by=DecidedBy.CHANNEL).to_dict(),
        "notes": [],
        "holds_for": "",
    }
    assert make_result("s", answer("no_path")).to_json()["path"] == []


def test_json_holds_plain_finite_values_only() -> None:
    stats = {"least_clearance": math.inf, "path_length": math.nan, "cells_by_level": [1, 2]}
    content = make_result("s", answer("undecided", **stats)).to_json()
    plain = json.loads(json.dumps(content, allow_nan=False))
    assert plain["stop_reason"] == "max_cells"
    assert (plain["stats"]["least_clearance"], plain["stats"]["path_length"]) == (None, None)
    assert plain["stats"]["cells_by_level"] == [1, 2]
    assert plain["stats"]["seconds"]["total"] == 0.0
    assert plain["stats"]["decided_by"] is None


def test_unknown_verdict_of_the_core_is_an_error() -> None:
    with pytest.raises(KeyError):
        make_result("s", answer("maybe"))


def test_text_survives_empty_statistics_and_strange_names() -> None:
    for verdict in ("path", "no_path", "undecided"):
        result = make_result("a\nb\x1b", answer(verdict))
        assert statistics(result).count("\n") <= 4
        assert headline(result).startswith("a\\nb\\x1b: ")
