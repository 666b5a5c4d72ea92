"""Scenes and certificates with a few values replaced: readers accept them or refuse them, no more.

Also what `tests/attacks/fuzz_readers.py` calls with inputs of its own.
"""

from __future__ import annotations

import copy
import json
import math
import random
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

from attacks.stress_parts.common import Row, Settings, fail
from planar_planner import Planner, SceneError, load_scene
from planar_planner.checker.verify import verify_certificate
from planar_planner.errors import CertificateError
from planar_planner.problem.make import make_problem

PART = "hostile"
SECONDS_EACH = 20  # whole seconds after which one input counts as hanging
SCENES = ("corner", "window", "snowflake", "courtyard", "disc", "fence", "slot", "window-fixed")
PROVEN = ("corner", "corner-too-long", "window-fixed", "slide-blocked", "disc-jammed", "courtyard")
ODD: tuple[Any, ...] = (
    *(None, True, False, "", "x", "\ud800", [], {}, [[]], [0], 0, 1, -1, -0.0, 0.5, 1e-50, 1e-320),
    *(5e-324, 1e12, 1e13, 1e308, -1e308, float("nan"), float("inf"), 2**31, 2**63, 2**64, 10**400),
    *("Polygon", "MultiPolygon", "Feature", "GeometryCollection", "x_min", "robot", [1, 2, 3, 4]),
)


class HangError(Exception):
    """One input took too long."""


@contextmanager
def time_limit() -> Iterator[None]:
    """Raise `HangError` after `SECONDS_EACH`, where there are alarms."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def strike(number: int, frame: FrameType | None) -> None:
        raise HangError(f"no answer after {SECONDS_EACH} s")

    previous = signal.signal(signal.SIGALRM, strike)
    signal.alarm(SECONDS_EACH)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, previous)


def read_scene(content: Any) -> bool:
    """Whether the reader takes a scene; whatever it raises but a refusal is a defect."""
    if not isinstance(content, dict):
        return False
    try:
        make_problem(load_scene(content))
    except SceneError as error:
        if "\n" in str(error):
            raise AssertionError("a refusal of several lines") from error
        return False
    return True


def read_certificate(scene: Any, content: Any, truth: str) -> bool:
    """Whether the checker takes a certificate; whatever it raises but a refusal is a defect.

    Another verdict than the true one is a defect as well.
    """
    if not isinstance(content, dict):
        return False
    try:
        report = verify_certificate(scene, content)
    except CertificateError:
        return False
    if report.verdict != truth:
        raise AssertionError(f"a proof of {report.verdict}, but {truth} is true")
    return True


def mutated(rng: random.Random, content: Any) -> Any:
    """Return a copy with a few members dropped, doubled, swapped, nudged or replaced."""
    content = copy.deepcopy(content)
    for _ in range(rng.choice((1, 1, 1, 2, 3, 8))):
        places = list(_places(content))
        if not places:
            break
        holder, key = rng.choice(places)
        kind = rng.random()
        if kind < 0.45:
            holder[key] = copy.deepcopy(rng.choice(ODD))
        elif kind < 0.6 and isinstance(holder[key], (int, float)):
            holder[key] = _nudged(rng, holder[key])
        elif kind < 0.75:
            other, name = rng.choice(places)
            holder[key] = copy.deepcopy(other[name])
        elif kind < 0.85:
            del holder[key]
        elif isinstance(holder, list):
            holder.insert(key, copy.deepcopy(holder[key]))
        else:
            holder[f"{key}{rng.choice(('s', ' ', '0'))}"] = holder[key]
    return content


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield container and key of every member at any depth, containers of many members thinned."""
    if isinstance(value, (dict, list)):
        keys = list(value) if isinstance(value, dict) else list(range(len(value)))
        for key in keys[:: 1 + len(keys) // 50]:
            yield value, key
            yield from _places(value[key])


def _nudged(rng: random.Random, value: float) -> Any:
    if isinstance(value, int):  # truth values, too
        return value + rng.choice((-1, 1))
    return rng.choice((-value, value * 2, value / 2, math.nextafter(value, math.inf), value + 1))


def scenes(settings: Settings) -> Row:
    """Change the shipped scenes and read them."""
    row = Row(PART, "scenes with values replaced")
    originals = [load_scene(name).to_dict() for name in SCENES]

    def once(rng: random.Random) -> tuple[Any, Callable[[], bool]]:
        content = mutated(rng, rng.choice(originals))
        return content, lambda: read_scene(content)

    return _repeat(settings, row, settings.count(40_000, 1000), once)


def certificates(settings: Settings) -> Row:
    """Change the certificates of shipped scenes and check them: those that pass prove the truth."""
    row = Row(PART, "certificates with values replaced")
    originals = []
    for name in PROVEN:
        scene = load_scene(name)
        result = Planner(scene).solve(certificate=True)
        originals.append((scene, json.loads(json.dumps(result.certificate)), result.verdict))

    def once(rng: random.Random) -> tuple[Any, Callable[[], bool]]:
        scene, original, truth = rng.choice(originals)
        content = mutated(rng, original)
        return content, lambda: read_certificate(scene, content, truth)

    return _repeat(settings, row, settings.count(20_000, 300), once)


def _repeat(
    settings: Settings,
    row: Row,
    count: int,
    once: Callable[[random.Random], tuple[Any, Callable[[], bool]]],
) -> Row:
    began = time.perf_counter()
    slowest, accepted = 0.0, 0
    for trial in range(count):
        rng = random.Random(f"{settings.seed} {row.case} {trial}")
        content, read = once(rng)
        struck = time.perf_counter()
        try:
            with time_limit():
                taken = read()
        except Exception as error:
            what = f"trial {trial}: {type(error).__name__}: {error}: {str(content)[:300]}"
            fail(settings, row, None, what)
            taken = False
        slowest = max(slowest, time.perf_counter() - struck)
        accepted += taken
        row.refused += not taken
        row.tried += 1
    row.seconds = time.perf_counter() - began
    row.note = f"{accepted} accepted; slowest {slowest:.2f} s"
    return row
