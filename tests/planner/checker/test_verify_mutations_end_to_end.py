"""The checker under attack: no tampering passes, and each of its demands is needed for that."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator
from functools import cache

import pytest

from planar_planner.checker import absence, case, collisions, path, verify
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateError, CertificateRejected
from planar_planner.load import load_scene
from planar_planner.planning.planner import Planner
from worlds.certificate_mutations import MUTATIONS, Json, mutant
from worlds.hand_made_certificates import HAND_MADE, hand_made

SHIPPED = [
    *("window-fixed", "slide-blocked", "corner-too-long", "comb-jammed", "piano-jammed"),
    *(
        "disc-jammed",
        "window",
        "slide",
        "corner",
        "piano",
        "courtyard",
        "fence",
        "comb",
        "bug-trap",
        "cage-open",
        "disassembly",
        "piano-anywhere",
        "cage",
        "disassembly-jammed",
    ),
]


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


CHECKER = (verify, case, collisions, absence, path)


def demands() -> list[str]:
    """Return the checker's demands, by what it says when they fail."""
    sources = map(inspect.getsource, CHECKER)
    calls = (node for source in sources for node in ast.walk(ast.parse(source)))
    named = (c for c in calls if isinstance(c, ast.Call) and isinstance(c.func, ast.Name))
    texts = [c.args[2] for c in named if c.func.id == "demand"]
    assert all(isinstance(text, ast.Constant) for text in texts)
    return [str(text.value) for text in texts]


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


def test_demands_are_distinct() -> None:
    assert len(demands()) == len(set(demands())) >= 30


@pytest.mark.parametrize("text", demands())
def test_without_a_demand_some_mutant_passes(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    caught = [(m, name) for m in MUTATIONS for name, why in verdicts(m).items() if why == text]
    original = case.demand

    def without(holds: bool, place: str, problem: str) -> None:
        original(holds or problem == text, place, problem)

    for module in CHECKER:
        monkeypatch.setattr(module, "demand", without)

    def passes(mutation: str, name: str) -> bool:
        made = mutant(mutation, *certified(name))
        assert made is not None
        try:
            verify_certificate(*made)
        except CertificateRejected:
            return False
        return True

    assert any(passes(mutation, name) for mutation, name in caught)
