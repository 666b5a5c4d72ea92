"""Results as values: equality, copies, what they show of themselves, and no truth value."""

from __future__ import annotations

import copy
import math
import multiprocessing
import pickle
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

from planar_planner import (
    DecidedBy,
    Margin,
    Options,
    PathFound,
    Planner,
    Result,
    Scene,
    Statistics,
    StopReason,
    margin,
    solve,
)
from planar_planner.planning.result import make_result

SCENE = Scene(
    robot=[(-1, -0.25), (1, -0.25), (1, 0.25), (-1, 0.25)],
    obstacles=[[(4, 0), (5, 0), (5, 4), (4, 4)]],
    start=(2, 2, 0),
    goal=(8, 2, 0),
    workspace=(0, 0, 10, 10),
)


@pytest.fixture(scope="module", params=["gear", "gear-jammed"])
def result(request: pytest.FixtureRequest) -> Result:
    return solve(request.param, certificate=True)


@pytest.fixture(scope="module")
def bracket() -> Margin:
    return margin("corner")


def answer(verdict: str, scene: str = "s", path: Any = (), **stats: Any) -> Result:
    decided_by = {"path": DecidedBy.CHANNEL, "no_path": DecidedBy.SEPARATION}.get(verdict)
    found = {
        "verdict": verdict,
        "stop_reason": StopReason.TIMEOUT if verdict == "undecided" else None,
        "ends_moved": False,
        "exact_legs": False,
        "to_be_checked": False,
        "path": path,
        "stats": Statistics(decided_by=decided_by, **stats),
    }
    return make_result(scene, found)


def test_the_same_query_twice_is_equal(result: Result) -> None:
    again = solve(result.scene)
    assert result == again
    assert hash(result) == hash(again)
    assert again.certificate is None
    assert result.stats.seconds != again.stats.seconds


def test_results_differ_by_verdict_scene_reason_and_path() -> None:
    path = [[0, 0, 0], [3, 4, 1]]
    found = answer("path", path=path)
    assert found == answer("path", path=path, cells=7)
    assert found != answer("path", path=[[0, 0, 0], [3, 4, 1 + 2**-52]])
    assert found != answer("path", path=path, scene="t")
    assert answer("no_path") != answer("undecided")
    assert found != "path"
    assert answer("path", path=[[0.0, 0, 0]]) == answer("path", path=[[-0.0, 0, 0]])


def test_length_and_clearance() -> None:
    found = answer("path", path=[[0, 0, 0], [3, 4, 1], [3, 5, 9]], least_clearance=0.5)
    assert (found.path_length, found.least_clearance) == (6.0, 0.5)
    assert (answer("no_path").path_length, answer("no_path").least_clearance) == (0.0, 0.0)
    assert answer("path", path=[[1, 2, 3]]).path_length == 0.0
    solved = solve("gear")
    assert math.isclose(solved.path_length, solved.stats.path_length, rel_tol=1e-14)
    assert solved.least_clearance == solved.stats.least_clearance > 0


def test_no_result_is_true_or_false(result: Result, bracket: Margin) -> None:
    for value in (result, answer("undecided"), answer("path", path=[[0, 0, 0]])):
        with pytest.raises(TypeError, match=r"compare result\.verdict"):
            bool(value)
    with pytest.raises(TypeError, match=r"compare margin\.verdict"):
        bool(bracket)


def test_repr_is_one_short_line(bracket: Margin) -> None:
    long = answer("path", "<script>\n" * 99, np.zeros((5000, 3)), least_clearance=math.inf)
    for value in (long, answer("no_path"), answer("undecided"), bracket, solve("gear-jammed")):
        assert "\n" not in repr(value)
        assert len(repr(value)) < 200
    assert repr(answer("path", path=[[0, 0, 0], [3, 4, 1]], least_clearance=0.25)) == (
        "<PathFound 's': length 5, waypoints 2, least clearance 0.25, "
        "certified through a channel of cells>"
    )
    assert repr(answer("undecided")) == "<Undecided 's': time limit reached>"
    assert repr(bracket).startswith("<Margin 'corner': by offset, [")


class Tags(HTMLParser):
    """Collects tags and text."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: set[str] = set()
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)

    def handle_data(self, data: str) -> None:
        self.text += data


def test_html_is_safe_against_names() -> None:
    name = "</td><script>alert(1)</script>"
    page = Tags()
    page.feed(answer("path", name, [[0, 0, 0], [3, 4, 1]])._repr_html_())
    assert page.tags == {"table", "tr", "th", "td"}
    assert name in page.text
    assert "length5" in page.text
    assert "no path, proven" in answer("no_path")._repr_html_()


@pytest.mark.parametrize("copied", [lambda v: pickle.loads(pickle.dumps(v)), copy.deepcopy])
def test_copies_are_equal_and_stay_read_only(copied: Any, result: Result, bracket: Margin) -> None:
    again = copied(result)
    assert again == result
    assert type(again) is type(result)
    assert again.certificate == result.certificate
    assert again.stats == result.stats
    assert copied(bracket) == bracket
    planner = Planner("gear-jammed", cells_only=True)
    planner.solve()
    bottleneck = copied(planner.bottleneck())
    for array in (again.path, copied(bracket).path, copied(planner.cells()).lower, bottleneck.way):
        assert not array.flags.writeable
    assert copied(Options(timeout=3.0)) == Options(timeout=3.0)


def test_a_margin_is_equal_but_for_counts_and_times(bracket: Margin) -> None:
    again = margin("corner")
    assert again == bracket
    assert hash(again) == hash(bracket)
    assert again.seconds != bracket.seconds
    assert margin("corner", width=0.1) != bracket
    assert bracket != "path"


def ask(planner: Planner, options: Options) -> Result:
    """Runs in another process."""
    return planner.solve(options=options)


def test_scenes_planners_options_and_results_reach_other_processes() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        sent = pool.apply(solve, (SCENE, Options(timeout=30.0)))
        asked = pool.apply(ask, (Planner(SCENE, cells_only=True), Options(timeout=30.0)))
    assert sent == solve(SCENE)
    assert isinstance(asked, PathFound)
    assert asked == Planner(SCENE, cells_only=True).solve()


def test_a_planner_is_sent_as_its_scene() -> None:
    planner = Planner(SCENE, cells_only=True)
    planner.solve()
    again = pickle.loads(pickle.dumps(planner))
    assert len(planner.cells()) > 0
    assert len(again.cells()) == 0
    assert again.scene == SCENE
    assert again.solve() == planner.solve()
    assert len(again.cells()) > 0
