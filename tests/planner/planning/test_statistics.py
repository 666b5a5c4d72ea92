"""Statistics of answers, and the class that holds them."""

from __future__ import annotations

import json
import pickle

import pytest

from planar_planner import DecidedBy, Seconds, Statistics, load_scene, solve
from planar_planner._core import Core

SOME = Statistics(
    cells=7,
    cells_by_label={"free": 3, "mixed": 4},
    cells_by_level=[0, 7],
    memory_bytes=2**40,
    seconds=Seconds(search=0.25, total=0.5),
    least_clearance=1.5,
    decided_by=DecidedBy.RIDGE,
)


def test_work_of_a_disc_in_the_robots_place_counts_whole() -> None:
    stats = solve(load_scene("disc-jammed")).stats
    assert stats.decided_by is DecidedBy.DISC
    assert 0 < stats.constraint_bytes < stats.memory_bytes
    assert 0 < stats.pairs_touched <= stats.pairs_total


def test_fields_are_read_only_and_explained() -> None:
    for name in SOME.to_dict():
        assert getattr(Statistics, name).__doc__.strip().endswith("."), name
        with pytest.raises(AttributeError):
            setattr(SOME, name, 1)
    for name in SOME.seconds.to_dict():
        assert getattr(Seconds, name).__doc__.strip().endswith("."), name


def test_dict_holds_every_field_in_types_of_json() -> None:
    content = SOME.to_dict()
    assert json.loads(json.dumps(content)) == content
    assert content["cells_by_label"] == {"free": 3, "star": 0, "full": 0, "mixed": 4}
    assert content["seconds"]["search"] == 0.25
    assert content["decided_by"] == "ridge"
    again = {name: getattr(SOME, name) for name in content}
    assert Statistics(**again) == SOME


def test_equality_pickling_and_changes() -> None:
    assert pickle.loads(pickle.dumps(SOME)) == SOME
    assert pickle.loads(pickle.dumps(SOME.seconds)) == SOME.seconds
    changed = SOME.replace(cells=8)
    assert (changed.cells, SOME.cells) == (8, 7)
    assert changed != SOME
    assert changed.replace(cells=7) == SOME
    assert SOME != 7
    with pytest.raises(TypeError, match="unhashable"):
        hash(SOME)


def test_unknown_fields_and_wrong_types_are_refused() -> None:
    with pytest.raises(TypeError, match="no statistic 'cell'"):
        SOME.replace(cell=8)
    with pytest.raises(TypeError, match="cells is of another type"):
        SOME.replace(cells="many")
    with pytest.raises(TypeError):
        Statistics(decided_by="luck")  # type: ignore[arg-type]


def test_representation_tells_what_is_not_zero() -> None:
    assert repr(Statistics()) == "Statistics()"
    assert repr(Statistics(cells=3, seconds=Seconds(total=2.0))) == (
        "Statistics(cells=3, seconds=Seconds(total=2.0))"
    )


def test_core_answers_with_it() -> None:
    assert Core.solve.__doc__ is not None  # the core is the real one
    assert isinstance(solve(load_scene("corner")).stats, Statistics)
