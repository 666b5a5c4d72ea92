"""Verdicts and their JSON."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from planar_planner.cli.report import headline, statistics
from planar_planner.planning.result import NoPath, PathFound, Undecided, make_result


def answer(verdict: str, **stats: Any) -> dict[str, Any]:
    path = [[0, 0, 0], [1, 2, 7.5]] if verdict == "path" else np.empty((0, 3))
    return {"verdict": verdict, "reason": "because", "path": path, "stats": stats}


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
        "reason": "because",
        "path": [[0.0, 0.0, 0.0], [1.0, 2.0, 7.5]],
        "stats": {"cells": 3},
    }
    assert make_result("s", answer("no_path")).to_json()["path"] == []


def test_json_holds_plain_finite_values_only() -> None:
    stats = {
        "clearance": math.inf,
        "count": np.int64(3),
        "real": np.float64("nan"),
        "levels": np.array([1, 2]),
        "nested": {"a": (1.5, -math.inf), 2: [True, None, "x"]},
    }
    content = make_result("s", answer("undecided", **stats)).to_json()
    assert json.loads(json.dumps(content, allow_nan=False))["stats"] == {
        "clearance": None,
        "count": 3,
        "real": None,
        "levels": [1, 2],
        "nested": {"a": [1.5, None], "2": [True, None, "x"]},
    }


def test_unknown_verdict_of_the_core_is_an_error() -> None:
    with pytest.raises(KeyError):
        make_result("s", answer("maybe"))


def test_text_survives_missing_statistics_and_strange_names() -> None:
    for verdict in ("path", "no_path", "undecided"):
        result = make_result("a\nb\x1b", answer(verdict))
        assert statistics(result).count("\n") <= 4
        assert headline(result).startswith("a\\nb\\x1b: ")
