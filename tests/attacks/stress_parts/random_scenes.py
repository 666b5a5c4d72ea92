"""Random scenes: every certificate is checked, and three drawings of each scene must agree.

A scene, its mirror image (exact: a sign changes) and the same with start and goal exchanged have
the same answer; any of them may be undecided, but a path and a proof of none are a contradiction.
Scenes whose ends collide or whose polygons came out invalid are drawn again.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor

from attacks.stress_parts.common import CRASHED, REFUSED, Answer, Row, Settings, ask, fail
from planar_planner import Options
from worlds.maps import Similarity, exchanged, similar
from worlds.random_kinds import KINDS, random_world
from worlds.scene import Scene

PART = "random"
OPTIONS = Options(max_cells=3_000, timeout=5.0)
FULL, QUICK = 1_000, 25  # scenes of each kind
CHUNK = 25  # scenes that a process draws at a time
TRIES = 300
MIRRORS = (Similarity(mirrored=True), Similarity(1j, mirrored=True), Similarity(-1, mirrored=True))


def run(settings: Settings) -> list[Row]:
    """Draw and check scenes of every kind."""
    count = settings.count(FULL, QUICK)
    jobs = [
        (settings, kind, first, min(first + CHUNK, count))
        for kind in KINDS
        for first in range(0, count, CHUNK)
    ]
    rows = {kind: Row(PART, kind) for kind in KINDS}
    for done in _in_processes(settings.processes, jobs):
        rows[done.case].add(done)
    return list(rows.values())


def _in_processes(processes: int, jobs: list[tuple[Settings, str, int, int]]) -> Iterator[Row]:
    if processes == 1:
        yield from map(_drawn, jobs)
    else:
        with ProcessPoolExecutor(processes) as pool:
            yield from pool.map(_drawn, jobs)


def _drawn(job: tuple[Settings, str, int, int]) -> Row:
    """Draw and check some scenes of a kind."""
    settings, kind, first, last = job
    row = Row(PART, kind)
    for number in range(first, last):
        scene, answer = drawn(settings, row, f"{settings.seed} {kind} {number}")
        check(settings, row, scene, answer)
    return row


def drawn(settings: Settings, row: Row, seed: str) -> tuple[Scene, Answer]:
    """Draw scenes until one is not refused, and count its answer; the seed says all of it."""
    rng = random.Random(seed)
    for _ in range(TRIES):
        scene = {**random_world(row.case, rng), "name": seed}
        once = Row(row.part, row.case)
        answer = ask(settings, once, scene, OPTIONS, certified=True)
        row.add(once, answers=answer.verdict != REFUSED)
        if answer.verdict != REFUSED:
            return scene, answer
    raise RuntimeError(f"{TRIES} scenes refused: {seed}")


def check(settings: Settings, row: Row, scene: Scene, answer: Answer) -> None:
    """Check that the scene's other drawings do not contradict its answer."""
    mirror = random.Random(str(scene["name"])).choice(MIRRORS)
    said = {answer.verdict}
    for other in (similar(scene, mirror), exchanged(scene)):
        assert other is not None  # these mirrors keep boxes
        once = Row(row.part, row.case)
        said.add(ask(settings, once, other, OPTIONS).verdict)
        row.add(once, answers=False)
    if len(said - {"undecided", CRASHED}) > 1:
        fail(settings, row, scene, f"contradiction between drawings: {sorted(said)}")
