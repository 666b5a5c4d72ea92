"""Every type in a public signature is exported, and none is Any."""

from __future__ import annotations

import ast
import builtins
import importlib
import inspect
import sys
from collections.abc import Callable, Iterator
from typing import Any, TypeVar, get_args, get_overloads, get_type_hints

import pytest

import pdg
import pdg.grasp

MODULES = (pdg, pdg.sets, pdg.grasp)
# What signatures are written with besides builtins and the library's own names.
VOCABULARY = {"np", "NDArray", "ArrayLike", "Sequence", "Mapping", "Iterable", "Iterator", "Self"}


def public() -> Iterator[tuple[str, Any]]:
    for module in MODULES:
        for name in module.__all__:
            yield f"{module.__name__}.{name}", getattr(module, name)


EXPORTED = dict(public())
NAMES = {path.rpartition(".")[2] for path in EXPORTED}


def signatures() -> Iterator[tuple[str, Any]]:
    """Everything public that has annotations: functions, their overloads, classes, methods."""
    for path, one in EXPORTED.items():
        if inspect.isfunction(one):
            yield path, one
            for k, other in enumerate(get_overloads(one)):
                yield f"{path} overload {k}", other
        elif inspect.isclass(one):
            yield path, one
            yield from methods(path, one)


def methods(path: str, one: type) -> Iterator[tuple[str, Callable[..., Any]]]:
    for base in one.__mro__:
        if not base.__module__.startswith("pdg"):
            continue
        for name, member in vars(base).items():
            function = member.fget if isinstance(member, property) else member
            made = function.__module__ if inspect.isfunction(function) else ""
            if made.startswith("pdg") and (not name.startswith("_") or name == "__init__"):
                yield f"{path}.{name}", function


SIGNATURES = dict(signatures())


def annotations(one: Any) -> dict[str, Any]:
    """Resolved annotations; those of a class without its private attributes."""
    hints = get_type_hints(one)
    return {n: t for n, t in hints.items() if inspect.isfunction(one) or not n.startswith("_")}


def parts(annotation: Any) -> Iterator[Any]:
    """What an annotation is made of, down to numpy's types, which are taken as they are."""
    yield annotation
    if not getattr(annotation, "__module__", "").startswith("numpy"):
        for part in get_args(annotation):
            yield from parts(part)


def test_signatures_are_found() -> None:
    assert {
        "pdg.translational_depth overload 2",
        "pdg.sets.Ball.__init__",
        "pdg.grasp.WrenchSet.support",
        "pdg.ConvexPieces.radius",
    } <= SIGNATURES.keys()


@pytest.mark.parametrize("path", SIGNATURES)
def test_types_are_exported(path: str) -> None:
    one = SIGNATURES[path]
    hints = annotations(one)
    if inspect.isfunction(one):
        parameters = inspect.signature(one).parameters
        assert {n for n in parameters if n != "self"} | {"return"} <= hints.keys() | {"self"}
    exported = [one for one in EXPORTED.values() if inspect.isclass(one)]
    for name, annotation in hints.items():
        for part in parts(annotation):
            assert part is not Any, name
            if inspect.isclass(part) and part.__module__.startswith("pdg"):
                assert part in exported, f"{name}: {part}"


@pytest.mark.parametrize("path", SIGNATURES)
def test_aliases_are_exported(path: str) -> None:
    """The names that an annotation is written with, as help() and the reference show it."""
    one = SIGNATURES[path]
    for name, text in inspect.get_annotations(one).items():
        if name.startswith("_"):
            continue
        for node in ast.walk(ast.parse(str(text), mode="eval")):
            if isinstance(node, ast.Name) and not hasattr(builtins, node.id):
                module = importlib.import_module(one.__module__)
                found = getattr(module, node.id, None)
                known = node.id in VOCABULARY or node.id in NAMES or isinstance(found, TypeVar)
                assert known, f"{name}: {text}"


def test_what_is_not_exported_is_found() -> None:
    hidden = type("Hidden", (), {"__module__": "pdg.hidden"})

    def function(hidden: Any, other: list[Any]) -> None: ...

    function.__annotations__ = {"hidden": dict[str, hidden], "other": list[Any]}
    hints = annotations(function)
    assert hidden in parts(hints["hidden"])
    assert Any in parts(hints["other"])


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_all_is_sorted_and_complete(module: Any) -> None:
    assert list(module.__all__) == sorted(module.__all__)
    public = {name for name in vars(module) if not name.startswith("_")}
    own = {
        name
        for name in public
        if getattr(getattr(module, name), "__module__", "").startswith("pdg")
        and name not in sys.modules
        and not inspect.ismodule(getattr(module, name))
    }
    assert own <= set(module.__all__)
