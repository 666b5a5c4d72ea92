"""What a certificate may cost, and angles and numbers at the edge of what may stand in one."""

from __future__ import annotations

import copy
import gzip
import json
import time
from pathlib import Path
from random import Random
from typing import Any

import pytest

from attacks import certificate_numbers
from planar_planner import CertificateError, Planner, solve, verify_certificate
from planar_planner.checker import json_reader
from planar_planner.checker.json_reader import MAX_MEMORY, MEMORY_OF, read_json
from planar_planner.cli.main import main
from planar_planner.errors import CertificateRejected, OptionsError, VerificationTimeoutError
from planar_planner.load import load_scene
from planar_planner.scene.builtin import builtin_scenes, manifest
from planar_planner.scene.model import with_ends

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
BLOCKED = [n for n in builtin_scenes() if manifest()[n]["expected"] == "no_path"]


@pytest.fixture(scope="module")
def jammed() -> dict[str, Any]:
    certificate = solve("slot-jammed", certificate=True).certificate
    assert certificate is not None
    return certificate


def test_copies_of_a_box_are_rejected_before_they_are_looked_at(
    capsys: pytest.CaptureFixture[str],
) -> None:
    began = time.process_time()
    assert main(["verify", "slot-jammed", str(FAULTS / "c_b20000.gz"), "--json", "-"]) == 1
    assert time.process_time() - began < 1.5  # with the imports; a second for the check
    finding = json.loads(capsys.readouterr().out)
    assert (finding["claim"], finding["problem"]) == ("start_side", "lists something twice")


@pytest.mark.parametrize("name", ["start_side", "full", "full_faces"])
def test_every_list_is_of_distinct_things(name: str, jammed: dict[str, Any]) -> None:
    face = {**jammed["full"][0], "axis": 0}
    listed = jammed[name] or [face]
    doubled = {**jammed, name: [*listed, listed[0]]}
    with pytest.raises(CertificateRejected, match="lists something twice"):
        verify_certificate("slot-jammed", doubled)


@pytest.mark.parametrize("name", BLOCKED)
def test_the_planner_lists_nothing_twice(name: str) -> None:
    certificate = Planner(name, cells_only=True).solve(certificate=True).certificate
    assert certificate is not None
    assert verify_certificate(name, certificate).verdict == "no_path"


@pytest.mark.parametrize("item", ["[]", '{"a":0}', '"key%d":0', "0"])
def test_memory_is_counted_before_anything_is_read(item: str, tmp_path: Path) -> None:
    heavy = max(MEMORY_OF[sign.encode()] for sign in "[{:" if sign in item) if item != "0" else 40
    count = MAX_MEMORY // heavy + 1
    pattern = item.replace("%d", "")
    text = "{" + f"{pattern}," * count + "}" if ":" in item and "{" not in item else (
        "[" + f"{pattern}," * count + "0]"
    )  # fmt: skip
    file = tmp_path / "large.json.gz"
    file.write_bytes(gzip.compress(text.encode(), 1))
    began = time.process_time()
    with pytest.raises(CertificateError, match="too large"):
        read_json(file)
    assert time.process_time() - began < 5.0


@pytest.mark.parametrize(("most", "read"), [(3, True), (2, False)])
def test_items_are_counted_before_anything_is_read(
    most: int, read: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(json_reader, "MAX_ITEMS", most)
    file = tmp_path / "items.json"
    file.write_text("[1, 2, 3, 4]")
    if read:
        assert read_json(file) == [1, 2, 3, 4]
        return
    file.write_text("[1, 2, 3, not JSON")
    with pytest.raises(CertificateError, match="too large"):
        read_json(file)


@pytest.mark.parametrize("exponent", [-324, -308, -260, -30, 0, 30, 100, 308])
@pytest.mark.parametrize("seed", range(4))
def test_numbers_of_any_size_are_rejected_or_unreadable(
    seed: int, exponent: int, jammed: dict[str, Any]
) -> None:
    """A piece with a vertex that is not the robot's proves nothing, whatever its size."""
    random = Random(1000 * seed + exponent)
    forged = copy.deepcopy(jammed)
    polygon = random.choice(sorted(forged["robot_pieces"]))
    vertex = random.choice(random.choice(forged["robot_pieces"][polygon]))
    axis = random.randrange(2)
    wrong = random.choice((-1, 1)) * float(f"{random.uniform(1, 1.7)}e{exponent}")
    assert vertex[axis] != wrong
    vertex[axis] = wrong
    with pytest.raises(CertificateError):
        verify_certificate("slot-jammed", forged)


def test_numbers_replaced_anywhere_prove_nothing_false() -> None:
    """A sample of the attack; both refusals occur in it, so that it reaches the checks."""
    found = certificate_numbers.run(0, 25)
    assert found["CertificateError"] and found["CertificateRejected"]


def test_the_timeout_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    boxes = [[[20, k], [20, 0], [20, 0]] for k in range(100_000)]
    certificate = solve("slot-jammed", certificate=True).certificate
    assert certificate is not None
    file = tmp_path / "many.json"
    file.write_text(json.dumps({**certificate, "start_side": boxes}))
    assert main(["verify", "slot-jammed", str(file), "--timeout", "1e-3", "--json", "-"]) == 3
    assert json.loads(capsys.readouterr().out)["finding"] == "undecided"
    assert main(["verify", "slot-jammed", str(file), "--timeout", "0"]) == 2


def test_an_object_of_very_many_fields_is_refused_at_once(jammed: dict[str, Any]) -> None:
    many = {f"k{i}": 0 for i in range(300_000)}
    for wrong in ({**jammed, **many}, {**jammed, "domain": many}):
        began = time.process_time()
        with pytest.raises(CertificateError, match="fields"):
            verify_certificate("slot-jammed", wrong)
        assert time.process_time() - began < 1.0


@pytest.mark.parametrize("where", ["version", "start_side", "scene", "full"])
def test_integers_of_many_digits_are_refused(where: str, jammed: dict[str, Any]) -> None:
    for wrong in (10**5000, [10**5000], {"box": 10**5000}):
        with pytest.raises(CertificateError):
            verify_certificate("slot-jammed", {**jammed, where: wrong})


@pytest.mark.parametrize("theta", [1e-54, 4e-54, 5e-324, -1e-54, -5e-324, 1e-20, -1e-20])
@pytest.mark.parametrize("end", ["start", "goal"])
def test_tiny_angles_have_certificates(theta: float, end: str) -> None:
    scene = load_scene("slot-jammed")
    q = [*getattr(scene, end)[:2], theta]
    scene = with_ends(scene, **{end: q})
    result = solve(scene, certificate=True)
    assert result.verdict == "no_path" and result.certificate is not None
    assert verify_certificate(scene, result.certificate).verdict == "no_path"


@pytest.mark.parametrize("name", ["slot-jammed", "corner", "disc-jammed"])
def test_the_timeout_of_a_call_holds(name: str) -> None:
    certificate = solve(name, certificate=True).certificate
    assert certificate is not None
    with pytest.raises(VerificationTimeoutError, match="time limit"):
        verify_certificate(name, certificate, timeout=1e-9)
    assert verify_certificate(name, certificate, timeout=60.0).claims > 0


@pytest.mark.parametrize("timeout", [0.0, -1.0, float("nan")])
def test_a_timeout_is_positive(timeout: float) -> None:
    with pytest.raises(OptionsError, match="timeout must be positive"):
        verify_certificate("corner", {}, timeout=timeout)
