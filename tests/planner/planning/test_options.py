"""Limits: defaults, legal ranges, clear refusals."""

from __future__ import annotations

import dataclasses
import math
import re
from typing import Any

import pytest

from planar_planner._core import Limits
from planar_planner.cli.arguments.limits import options_of
from planar_planner.cli.parser import make_parser
from planar_planner.errors import OptionsError
from planar_planner.planning.options import Options


def test_the_command_line_has_the_same_defaults() -> None:
    for command in ("solve", "check"):
        assert options_of(make_parser().parse_args([command, "gear"])) == Options()


def test_the_help_states_the_memory_that_is_the_default(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        make_parser().parse_args(["solve", "--help"])
    stated = re.search(r"unit K, M, G\s+or T\s+\(default:\s+(\w+)\)", capsys.readouterr().out)
    assert stated is not None
    arguments = make_parser().parse_args(["solve", "gear", "--max-memory", stated[1]])
    assert options_of(arguments) == Options()


def test_defaults_are_those_of_the_core() -> None:
    names = {name for name in dir(Limits) if not name.startswith("_")}
    assert dataclasses.asdict(Options()) == {name: getattr(Limits(), name) for name in names}


def test_defaults_are_finite() -> None:
    """They are finite, and ends in contact stay where they are."""
    assert all(math.isfinite(value) for value in dataclasses.asdict(Options()).values())
    assert Options().contact_tolerance == 0.0


def test_frozen() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        Options().timeout = 1.0


@pytest.mark.parametrize(
    "legal",
    [
        {"resolution": 1},
        {"resolution": 5e-324},
        {"timeout": math.inf},
        {"timeout": 1},
        {"max_cells": 1},
        {"max_cells": 2**63 - 1},
        {"max_memory": 1},
        {"contact_tolerance": 1},
    ],
)
def test_legal(legal: dict[str, Any]) -> None:
    (name, value), *_ = legal.items()
    found = getattr(Options(**legal), name)
    assert found == value
    assert type(found) is type(getattr(Options(), name))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("resolution", 0),
        ("resolution", -1e-9),
        ("resolution", 1.5),
        ("resolution", math.nan),
        ("resolution", "1e-9"),
        ("resolution", True),
        ("timeout", 0),
        ("timeout", -1),
        ("timeout", math.nan),
        ("timeout", None),
        ("timeout", 10**400),
        ("max_cells", 0),
        ("max_cells", 1e6),
        ("max_cells", True),
        ("max_cells", 2**63),
        ("max_memory", 0),
        ("max_memory", -1),
        ("max_memory", "4G"),
        ("contact_tolerance", -1e-12),
        ("contact_tolerance", math.inf),
        ("contact_tolerance", math.nan),
    ],
)
def test_illegal(name: str, value: Any) -> None:
    with pytest.raises(OptionsError, match=name):
        Options(**{name: value})
