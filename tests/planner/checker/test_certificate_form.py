"""The keys of a certificate: one list, which writer, reader and docs/certificate.md agree on."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import pytest

from planar_planner import certificate_keys as keys
from planar_planner.checker import form
from planar_planner.checker.json_reader import Fields
from planar_planner.planning import certificate
from planar_planner.planning.planner import solve
from worlds.hand_made_certificates import HAND_MADE, hand_made

ROOT = next(folder for folder in Path(__file__).parents if (folder / "pyproject.toml").is_file())
FAR_REFERENCE = ROOT / "tests" / "worlds" / "faults" / "far_10_0.98.json"
PAGE = ROOT / "docs" / "certificate.md"
ELSEWHERE = {keys.VERDICT, keys.CLAIM}  # in tables that come before
VERDICT_FIELD: Fields = {keys.VERDICT: form.PATH_FIELDS[keys.VERDICT]}

OBJECTS: dict[str, tuple[Fields, ...]] = {
    "certificate": (
        form.COMMON_FIELDS,
        form.OUTSIDE_FIELDS,
        form.REFERENCE_FIELDS,
        form.DECIMAL_FIELDS,
        VERDICT_FIELD,
    ),
    "path": (form.PATH_FIELDS,),
    "interval": (form.INTERVAL_FIELDS,),
    "exact interval": (form.ALONG_FIELDS,),
    "separation": (form.SEPARATION_FIELDS,),
    "domain": (form.DOMAIN_FIELDS,),
    "claim": (form.FACE_FIELDS, *form.COLLISIONS),
    "joint": (form.JOINT_FIELDS,),
    "of axes": (form.AXES_FIELDS,),
    "term": (form.TERM_FIELDS,),
    "wall term": (form.WALL_TERM_FIELDS,),
    "disc": (form.DISC_FIELDS,),
    "chain": (form.CHAIN_FIELDS,),
    "link": form.LINKS,
    "end": (form.END_FIELDS, *form.COLLISIONS[:2], form.BOUNDS_FIELDS),
}


def tables() -> dict[str, set[str]]:
    """Return the first column's fields of each table, by what stands above it."""
    found: dict[str, set[str]] = {}
    name = ""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) < 4 or set(cells[1]) == {"-"}:
            continue
        if cells[2] == "meaning":
            name = cells[1]
            assert name not in found
            found[name] = set()
        else:
            found[name] |= set(re.findall(r"`(\w+)`", cells[1]))
    return found


def test_every_object_has_a_table() -> None:
    assert set(tables()) == {*OBJECTS, "no path"}
    assert tables()["no path"] == {keys.CLAIM}


@pytest.mark.parametrize("name", OBJECTS)
def test_the_page_lists_the_fields_that_are_read(name: str) -> None:
    fields = {key for part in OBJECTS[name] for key in part}
    if name != "certificate":
        fields -= ELSEWHERE
    if name == "disc":
        fields -= form.SEPARATION_FIELDS.keys()
    assert tables()[name] == fields


def listed_keys() -> set[str]:
    return {str(v) for name, v in vars(keys).items() if name.isupper() and isinstance(v, str)}


def test_keys_stand_in_the_list_alone() -> None:
    """No string of the writer or of the checker repeats one."""
    for file in (Path(certificate.__file__), *Path(form.__file__).parent.glob("*.py")):
        nodes = ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        strings = {node.value for node in nodes if isinstance(node, ast.Constant)}
        assert not strings & listed_keys(), file


def names_in(value: Any, *, free: bool = False) -> set[str]:
    """Return the keys of a certificate at any depth, polygons' numbers left out."""
    if isinstance(value, list):
        return set().union(*map(names_in, value)) if value else set()
    if not isinstance(value, dict):
        return set()
    own = set() if free else set(value)
    pieces = (keys.ROBOT_PIECES, keys.OBSTACLE_PIECES)
    return own.union(*(names_in(inner, free=name in pieces) for name, inner in value.items()))


def test_every_field_is_written_by_hand_or_by_the_planner() -> None:
    """So no key of the list is of no use, and no certificate has another."""
    written = set().union(*(names_in(hand_made(name)[1]) for name in HAND_MADE))
    for name in ("comb-jammed", "disc-jammed", "slot", FAR_REFERENCE):
        written |= names_in(solve(name, certificate=True).certificate)
    fields = {key for parts in OBJECTS.values() for part in parts for key in part}
    assert written == fields
    assert written <= listed_keys()
