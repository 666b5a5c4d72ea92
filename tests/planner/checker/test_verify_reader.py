"""Certificates as hostile input: every bad one is refused cleanly, with the place."""

from __future__ import annotations

import copy
import gzip
import json
import random
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from planar_planner.checker.arithmetic import LENGTH_BITS, units
from planar_planner.checker.form import read_certificate
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateError, CertificateRejected
from worlds.hand_made_certificates import HAND_MADE, Json, hand_made

HUGE = 10**400
TINY = 5e-324


def spoilt(name: str, *place: Any, by: Any) -> Json:
    """Return a certificate with one value replaced."""
    _, certificate = hand_made(name)
    inner: Any = certificate
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = by
    return certificate


@pytest.mark.parametrize(
    ("name", "place", "value"),
    [
        ("gap", ["format"], "planar-planner/scene"),
        ("gap", ["version"], 1.0),
        ("gap", ["version"], True),
        ("gap", ["made_by"], None),
        ("gap", ["scene"], ["0"]),
        ("gap", ["verdict"], "undecided"),
        ("gap", ["claim"], "end"),
        ("gap", ["claim"], 3),
        ("gap", ["robot_pieces"], []),
        ("gap", ["robot_pieces", "0"], {}),
        ("gap", ["robot_pieces", "0", 0], 7),
        ("gap", ["robot_pieces", "0", 0, 1], [0.5]),
        ("gap", ["robot_pieces", "0", 0, 1], [0.5, 0.5, 0.5]),
        ("gap", ["robot_pieces", "0", 0, 1, 0], "0.5"),
        ("gap", ["robot_pieces", "0", 0, 1, 0], True),
        ("gap", ["robot_pieces", "0", 0, 1, 0], HUGE),
        ("gap", ["robot_pieces", "0", 0, 1, 0], 1e308),
        ("gap", ["robot_pieces", "0", 0, 1, 0], TINY),
        ("gap", ["robot_pieces", "0", 0, 1, 0], float("nan")),
        ("gap", ["robot_pieces", "0", 0, 1, 0], float("inf")),
        ("gap", ["domain"], [0, 0, 1, 1]),
        ("gap", ["domain", "low", 0], 0),
        ("gap", ["domain", "low", 0, 0], 0.0),
        ("gap", ["domain", "low", 0, 0], HUGE),
        ("gap", ["domain", "low", 0, 1], 10**9),
        ("gap", ["domain", "low", 0, 1], -(10**9)),
        ("gap", ["domain", "size", 1, 0], 0),
        ("gap", ["domain", "size", 1, 0], -3),
        ("gap", ["start_side"], {}),
        ("gap", ["start_side", 0], [[0, 0], [0, 0]]),
        ("gap", ["start_side", 0, 1], [0, 0, 0]),
        ("gap", ["start_side", 0, 1, 0], -1),
        ("gap", ["start_side", 0, 1, 0], 61),
        ("gap", ["start_side", 0, 1, 0], False),
        ("gap", ["start_side", 0, 1, 1], -1),
        ("gap", ["start_side", 0, 1, 1], 2.0**70),
        ("gap", ["start_side", 0, 1, 1], HUGE),
        ("gap", ["full", 0], []),
        ("gap", ["full", 0, "pair"], [0, 0, 0]),
        ("gap", ["full", 0, "pair", 2], -1),
        ("gap", ["full", 0, "pair", 2], "0"),
        ("gap", ["full_faces", 0, "axis"], 3),
        ("gap", ["full_faces", 0, "axis"], "x"),
        ("gap", ["full_faces", 1, "wall"], "x_mid"),
        ("gap", ["full_faces", 1, "wall"], ["x_min"]),
        ("gap", ["full_faces", 2, "joint"], "joint"),
        ("gap", ["full_faces", 2, "joint", "axes", 0, "edges", 0], ["obstacle"]),
        ("gap", ["full_faces", 2, "joint", "axes", 0, "edges", 0, 0], "wall"),
        ("gap", ["full_faces", 2, "joint", "sums", 0], {}),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 0, "vertex"], 0),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 0, "weight"], None),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 0, "weight"], float("nan")),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 1, "owner"], "wall"),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 1, "edge"], 1.5),
        ("gap", ["full_faces", 2, "joint", "sums", 0, 1, "vertex"], -1),
        ("disc", ["disc"], None),
        ("disc", ["disc", 3], [1]),
        ("disc", ["inside"], [0]),
        ("blocked_start", ["end"], "middle"),
        ("blocked_start", ["pair"], {}),
        ("goal_out_of_bounds", ["reference_bounds"], False),
        ("goal_out_of_bounds", ["reference_bounds"], 1),
        ("over_block", ["contact_tolerance"], "0"),
        ("over_block", ["waypoints"], 0),
        ("over_block", ["waypoints", 1], [0, 0, 0]),
        ("over_block", ["waypoints", 1, 2], 1e7),
        ("over_block", ["waypoints", 1, 3], 0.0),
        ("over_block", ["waypoints", 1, 3], 2**21),
        ("over_block", ["segments", 0], {}),
        ("over_block", ["segments", 0, 0, "from"], None),
        ("over_block", ["segments", 0, 0, "to"], TINY),
        ("over_block", ["segments", 0, 0, "to"], 1.0000000000000002),
        ("over_block", ["segments", 0, 0, "apart"], "none"),
        ("over_block", ["segments", 0, 0, "apart", 0], [0, 0, 0, 0, "obstacle"]),
        ("over_block", ["segments", 0, 0, "apart", 0, 4], 0),
        ("over_block", ["segments", 0, 0, "apart", 0, 5], True),
        ("bent_workspace", ["outside"], [0, 0, 1]),
        ("bent_workspace", ["outside", 2], "11"),
    ],
)
def test_wrong_values_are_refused_with_their_place(name: str, place: list[Any], value: Any) -> None:
    with pytest.raises(CertificateError) as caught:
        read_certificate(spoilt(name, *place, by=value))
    written = "".join(f"[{p}]" if isinstance(p, int) else f".{p}" for p in place)[1:]
    assert written.startswith(str(caught.value.args[0])) or "claim" in place or "verdict" in place


def fields_of(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the place of every field of every object."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield (*place, name)
            yield from fields_of(inner, (*place, name))
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from fields_of(inner, (*place, i))


@pytest.mark.parametrize("name", HAND_MADE)
def test_missing_and_unknown_fields(name: str) -> None:
    _, certificate = hand_made(name)
    for place in fields_of(certificate):
        parent: Any = copy.deepcopy(certificate)
        top = parent
        for step in place[:-1]:
            parent = parent[step]
        if place[-1] in ("0", "1", "outside", "along", "decimal_places"):  # what may be absent
            continue
        value = parent.pop(place[-1])
        with pytest.raises(CertificateError, match=r"missing|unknown|must be"):
            read_certificate(top)
        parent[place[-1]] = value
        parent["extra"] = 1
        with pytest.raises(CertificateError, match="extra: is an unknown field"):
            read_certificate(top)


def test_outside_belongs_to_polygonal_workspaces() -> None:
    scene, certificate = hand_made("bent_workspace")
    del certificate["outside"]
    with pytest.raises(CertificateRejected, match="outside"):
        verify_certificate(scene, certificate)


DEEP = b"[" * 5_000_000 + b"]" * 5_000_000


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "cannot be read"),
        (b"{", "cannot be read"),
        (b"[]", "must be an object"),
        (b"null", "must be an object"),
        (b"\xff\xfe", "cannot be read"),
        (b'{"a": 1, "a": 2}', "twice"),
        (b'{"format": NaN}', "missing"),
        (b'{"version": ' + b"9" * 10_000 + b"}", "cannot be read"),
        (DEEP, "cannot be read"),
        (b"[" * 100_000, "cannot be read"),
        (b'{"a":' * 100_000, "cannot be read"),
        (b"[" + b"[]," * 9_000_000 + b"[]]", "too large"),
        (gzip.compress(b"{"), "cannot be read"),
        (gzip.compress(b"{}" * 1000)[:20], "cannot be read"),
        (b"\x1f\x8b" + b"\x00" * 50, "cannot be read"),
        (gzip.compress(bytes(300_000_000), 1), "too large"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_files_that_are_no_certificates(data: bytes, message: str, tmp_path: Path) -> None:
    file = tmp_path / "certificate.json"
    file.write_bytes(data)
    began = time.monotonic()
    with pytest.raises(CertificateError, match=message):
        read_certificate(file)
    assert time.monotonic() - began < 20


@pytest.mark.parametrize("name", ["gap", "over_block"])
def test_compressed_or_not_whatever_the_name(name: str, tmp_path: Path) -> None:
    scene, certificate = hand_made(name)
    data = json.dumps(certificate).encode()
    for suffix, content in (("json", data), ("json.gz", gzip.compress(data)), ("x", data)):
        file = tmp_path / f"certificate.{suffix}"
        file.write_bytes(content)
        assert verify_certificate(scene, file).verdict == certificate["verdict"]


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(CertificateError, match="No such file"):
        read_certificate(tmp_path / "none.json")
    with pytest.raises(CertificateError, match="directory"):
        read_certificate(tmp_path)


def nodes(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield every container of the certificate with each of its keys."""
    items: Any = value.items() if isinstance(value, dict) else enumerate(value)
    for key, inner in items:
        yield value, key
        if isinstance(inner, (dict, list)):
            yield from nodes(inner)


JUNK: list[Callable[[random.Random, Any], Any]] = [
    lambda rng, _: rng.choice([None, True, "", "obstacle", [], {}, [[]], HUGE, -1, 0, 1, 2, 1e300]),
    lambda rng, _: rng.randrange(-3, 70),
    lambda rng, _: rng.uniform(-10, 10),
    lambda _, old: [old],
    lambda _, old: [*old, *old] if isinstance(old, list) else old,
    lambda _, old: old[1:] if isinstance(old, list) else old,
    lambda _, old: -old if isinstance(old, (int, float)) else old,
    lambda _, old: {**old, "edge": 1} if isinstance(old, dict) else old,
]


@pytest.mark.parametrize("name", HAND_MADE)
def test_junk_never_crashes_the_checker(name: str) -> None:
    """Values of a certificate replaced at random: valid, rejected or unreadable, and soon."""
    rng = random.Random(name)
    scene, certificate = hand_made(name)
    refused = 0
    for _ in range(120):
        wrong = copy.deepcopy(certificate)
        for _ in range(rng.randrange(1, 4)):
            container, key = rng.choice(list(nodes(wrong)))
            container[key] = rng.choice(JUNK)(rng, container[key])
        try:
            verify_certificate(scene, wrong)
        except CertificateError as error:
            refused += 1
            assert len(str(error)) < 400
            assert "\n" not in str(error)
    assert refused > 60


def test_units_hold_every_number_of_a_scene() -> None:
    for number in (1e-50, -1.0000000000000002e-50, 1e12, 0.1, -0.0):
        assert units(number) == number * 2**LENGTH_BITS or units(number) % 2 == 0
        assert units(number) / 2**LENGTH_BITS == number
