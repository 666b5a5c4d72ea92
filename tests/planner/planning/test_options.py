"""Limits: defaults, legal ranges, clear refusals."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import pytest

from planar_planner.errors import OptionsError
from planar_planner.planning.options import Options


def test_defaults() -> None:
    assert dataclasses.asdict(Options()) == {
        "resolution": 1e-9,
        "max_cells": 5_000_000,
        "timeout": 60.0,
        "max_memory": 4 * 2**30,
        "contact_tolerance": 0.0,
    }


def test_the_native_defaults_are_the_same() -> None:
    """Except the timeout: native code waits for ever unless it says otherwise."""
    header = Path(__file__).parents[3] / "planar_planner" / "native" / "limits.hpp"
    fields = re.findall(r"^  \S+ (\w+) = (.+?);", header.read_text(encoding="utf-8"), re.MULTILINE)
    native = dict(fields[:5])
    shift = re.fullmatch(r"std::uint64_t\{(\d+)\} << (\d+)U", native["max_memory"])
    assert shift is not None
    assert {
        "resolution": float(native["resolution"]),
        "max_cells": int(native["max_cells"].replace("'", "")),
        "max_memory": int(shift[1]) << int(shift[2]),
        "contact_tolerance": float(native["contact_tolerance"]),
    } == {name: getattr(Options(), name) for name in native if name != "timeout"}


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
