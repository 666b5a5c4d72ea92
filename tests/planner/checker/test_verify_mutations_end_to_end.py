"""The checker under attack: no tampering passes, and each of its demands is needed for that."""

from __future__ import annotations

import ast
import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from functools import cache
from types import ModuleType

import pytest

from planar_planner import checker
from planar_planner.checker.demands import demand
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateError, CertificateRejected
from planar_planner.load import load_scene
from planar_planner.planning.planner import Planner
from worlds.certificate_mutations import MUTATIONS, Json, mutant
from worlds.hand_made_certificates import HAND_MADE, hand_made

BLOCKED = [
    *("window-fixed", "slide-blocked", "corner-too-long", "comb-jammed", "piano-jammed"),
    *("disc-jammed", "cage", "disassembly-jammed"),
]
PASSING = [
    *("window", "slide", "corner", "piano", "courtyard", "fence", "comb", "bug-trap"),
    *("cage-open", "disassembly", "piano-anywhere"),
]
SHIPPED = [*BLOCKED, *PASSING]


@cache
def certified(name: str) -> tuple[Json, Json]:
    """Return a scene, and its certificate by hand or by the planner."""
    if name in HAND_MADE:
        return hand_made(name)
    certificate = Planner(load_scene(name)).solve(certificate=True).certificate
    assert certificate is not None
    return load_scene(name).to_dict(), certificate


def mutants(mutation: str) -> Iterator[tuple[str, Json, Json]]:
    """Yield what a mutation makes of every certificate that it applies to."""
    for name in (*HAND_MADE, *SHIPPED):
        made = mutant(mutation, *certified(name))
        if made is not None:
            yield name, *made


@cache
def verdicts(mutation: str) -> dict[str, str]:
    """Return by scene what the checker finds wrong with its mutant."""
    found = {}
    for name, scene, certificate in mutants(mutation):
        try:
            verify_certificate(scene, certificate)
        except CertificateRejected as rejected:
            found[name] = str(rejected.args[1])
        except CertificateError as error:
            found[name] = f"unreadable: {error}"
        else:
            found[name] = "valid"
    return found


CHECKER = [
    importlib.import_module(f"{checker.__name__}.{module.name}")
    for module in pkgutil.iter_modules(checker.__path__)
]


def demands() -> dict[str, ModuleType]:
    """Return the checker's demands by what it says when they fail, and where each stands."""
    found: dict[str, ModuleType] = {}
    for module in CHECKER:
        for call in ast.walk(ast.parse(inspect.getsource(module))):
            if isinstance(call, ast.Call) and ast.unparse(call.func) == "demand":
                text = call.args[2]
                assert isinstance(text, ast.Constant)
                assert text.value not in found
                found[str(text.value)] = module
    return found


@pytest.mark.parametrize("name", [*HAND_MADE, *SHIPPED])
def test_untouched_certificates_are_valid(name: str) -> None:
    scene, certificate = certified(name)
    assert verify_certificate(scene, certificate).verdict == certificate["verdict"]


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_no_tampering_passes(mutation: str) -> None:
    found = verdicts(mutation)
    assert len(found) > 1
    assert "valid" not in found.values(), found


def test_a_mutant_is_no_original() -> None:
    for mutation in MUTATIONS:
        for name, scene, certificate in mutants(mutation):
            assert (scene, certificate) != certified(name), mutation


def test_the_demands_of_every_module_are_found() -> None:
    """The proof's parts have some each; those that read and calculate have none."""
    without = {"arithmetic", "demands", "form", "goal_area", "json_reader", "records"}
    having = {module.__name__.rpartition(".")[2] for module in demands().values()}
    assert having | without == {module.__name__.rpartition(".")[2] for module in CHECKER}
    assert not having & without
    assert len(demands()) >= 30


@pytest.mark.parametrize("text", demands())
def test_without_a_demand_some_mutant_passes(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    caught = [(m, name) for m in MUTATIONS for name, why in verdicts(m).items() if why == text]

    def without(holds: bool, place: str, problem: str) -> None:
        demand(holds or problem == text, place, problem)

    monkeypatch.setattr(demands()[text], "demand", without)

    def passes(mutation: str, name: str) -> bool:
        made = mutant(mutation, *certified(name))
        assert made is not None
        try:
            verify_certificate(*made)
        except CertificateRejected:
            return False
        return True

    assert any(passes(mutation, name) for mutation, name in caught)
