"""What holds of every native header and source: no ``mutable`` behind const, and one home for the
fields of a motion that follow from others."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted(
    path
    for package in ("pdg", "planar_planner")
    for path in (ROOT / package / "native").rglob("*")
    if path.suffix in {".cpp", ".hpp"}
)
MOTION = ROOT / "pdg" / "native" / "geometry" / "motion.hpp"
MUTABLE = re.compile(r"\bmutable\b")
DERIVED = re.compile(r"\.(g1_length|g2_length|half_angle|cos_half|sin_half)\s*=(?!=)")


def code(path: Path) -> str:
    """Return the file without comments and string literals."""
    text = re.sub(r"//[^\n]*", "", path.read_text())
    return re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)


def name(path: Path) -> str:
    return str(path.relative_to(ROOT))


def test_the_patterns_find_what_they_are_for() -> None:
    assert MUTABLE.search("struct S { mutable int x; };")
    assert not MUTABLE.search("nb::class_ immutable")
    assert DERIVED.search("m.g1_length = 1.0;")
    assert not DERIVED.search("if (m.half_angle == 0.0)")
    assert DERIVED.search(code(MOTION))
    assert len(SOURCES) > 150


@pytest.mark.parametrize("path", SOURCES, ids=name)
def test_nothing_is_mutable_behind_const(path: Path) -> None:
    assert not MUTABLE.search(code(path))


def test_only_make_motion_sets_what_follows_from_other_fields() -> None:
    setters = [name(path) for path in SOURCES if DERIVED.search(code(path))]
    assert setters == [name(MOTION)]
