"""Whoever gets or gives a value by the public interface can import its type from there."""

from __future__ import annotations

import importlib
import inspect
import re
import sys
import typing
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import planar_planner
import planar_planner.typing

OURS = ("planar_planner", "pdg")
PAGE = Path(__file__).parents[2] / "docs" / "api" / "planar_planner.md"
WHOLE = ("planar_planner.typing", "planar_planner.planning.path_samples")


def things_of(module: ModuleType) -> dict[str, Any]:
    return {name: getattr(module, name) for name in module.__all__}


TOP = things_of(planar_planner)
TYPES = things_of(planar_planner.typing)
IMPORTABLE = {*TOP.values(), *TYPES.values()}
LATE = TOP | TYPES  # what some modules import for annotations only


def classes_in(hint: Any) -> Iterator[type]:
    """The classes of our packages in an annotation, within whatever unions and containers."""
    if isinstance(hint, type) and hint.__module__.split(".")[0] in OURS:
        yield hint
    parts = [*typing.get_args(hint), typing.get_origin(hint)]
    for part in (p for each in parts for p in (each if isinstance(each, list) else [each])):
        if part is not None and part is not hint:
            yield from classes_in(part)


def functions_of(thing: Any) -> Iterator[Any]:
    """A function, or the public methods and properties of a class, inherited ones included."""
    if not isinstance(thing, type):
        yield thing
        return
    for name, member in inspect.getmembers(thing):
        if name.startswith("_") and name not in ("__init__", "__getitem__"):
            continue
        if isinstance(member, property) and inspect.isfunction(member.fget):  # not the core's
            yield member.fget
        elif inspect.isfunction(member) and member.__module__.split(".")[0] in OURS:
            yield member


def named_by(thing: Any) -> set[type]:
    """All classes of ours that the signatures of a function or class name."""
    hints: list[Any] = []
    if isinstance(thing, type):
        public = typing.get_type_hints(thing, localns=LATE)
        hints += [hint for name, hint in public.items() if not name.startswith("_")]
    elif not inspect.isfunction(thing):
        return set(classes_in(thing))
    for function in functions_of(thing):
        hints += typing.get_type_hints(function, localns=LATE).values()
    return {found for hint in hints for found in classes_in(hint)}


@pytest.mark.parametrize("name", sorted(TOP))
def test_types_in_public_signatures_are_exported(name: str) -> None:
    missing = named_by(TOP[name]) - IMPORTABLE
    assert not missing, "export it, or name it in planar_planner.typing"


def documented() -> dict[str, Any]:
    """What the reference lists, by name; of whole modules what they define."""
    found: dict[str, Any] = {}
    for name in re.findall(r"^\.\. auto(?:function|class)\w*:: ([\w.]+)$", PAGE.read_text(), re.M):
        home, _, own = f"planar_planner.{name}".rpartition(".")
        if name.startswith("planar_planner."):
            home, _, own = name.rpartition(".")
        found[name] = getattr(importlib.import_module(home), own)
    for home in WHOLE:
        assert f"automodule:: {home}" in PAGE.read_text()
        own = {n: v for n, v in vars(importlib.import_module(home)).items() if callable(v)}
        found |= {f"{home}.{n}": v for n, v in own.items() if v.__module__ == home}
    return found


def test_types_in_the_reference_are_in_the_reference() -> None:
    found = documented()
    assert len(found) > 40
    there = IMPORTABLE | set(found.values())
    for name, thing in found.items():
        missing = named_by(thing) - there
        assert not missing, f"{name} names {missing}: add it to docs/api/planar_planner.md"


class Hidden:
    """A class of this module, which is not one of ours; a test makes it one."""


def test_a_hidden_type_would_be_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Hidden, "__module__", "planar_planner.hidden")

    def function(a: dict[str, list[Hidden] | None]) -> int: ...

    def listener(a: typing.Callable[[Hidden], bool]) -> None: ...

    class Holder:
        @property
        def hidden(self) -> Hidden: ...

    monkeypatch.setitem(sys.modules, "planar_planner.hidden", sys.modules[__name__])
    function.__annotations__ = {"a": dict[str, list[Hidden] | None]}
    listener.__annotations__ = {"a": typing.Callable[[Hidden], bool]}
    monkeypatch.setattr(Holder, "__module__", "planar_planner.hidden")
    for thing in (function, listener, Holder):
        assert named_by(thing) == {Hidden}
