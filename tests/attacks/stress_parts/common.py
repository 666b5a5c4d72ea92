"""What all parts share: settings, one row of the table, and asking the planner with all checks on.

A *failure* is anything that must never happen: a wrong verdict, a contradiction, a rejected
certificate, an exception that is no `SceneError`, a limit that does not stop the search, a search
that had to be rebuilt. The scene that failed is written to a file, so that it can be solved again.
"""

from __future__ import annotations

import faulthandler
import json
import sys
import time
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from attacks.stress_parts.certificates import certificate_failure
from planar_planner import Options, Planner, SceneError
from planar_planner.planning.result import Result
from worlds.scene import Scene

Query = Callable[[Options, bool], Result]
Solver = Callable[[Mapping[str, Any]], Query]

LIMITS = Options(max_cells=200_000, timeout=20.0)
OVERTIME = 30.0  # seconds past a time limit after which a query is late; machines are busy
HANGING = 120.0  # seconds past it after which the whole run is ended, with where it hangs
REFUSED = "refused"  # stands for a verdict: the scene was rejected with a message
CRASHED = "crashed"  # the same: an exception that no input may cause
CASES_KEPT = 20  # failing scenes written to files, for each row: more say nothing new


def planner(scene: Mapping[str, Any]) -> Query:
    """Return queries to a planner on a scene; tests plant others in its place.

    They take the options, and whether to make a certificate.
    """
    made = Planner(scene)
    return lambda options, certificate: made.solve(options=options, certificate=certificate)


def kept(settings: Settings, scene: Mapping[str, Any]) -> Query:
    """Return queries to one planner, which keeps its cells, made when it is first asked."""
    made: list[Query] = []

    def query(options: Options, certificate: bool) -> Result:
        if not made:
            made.append(settings.solver(scene))
        return made[0](options, certificate)

    return query


@dataclass(frozen=True)
class Settings:
    """How much to do, and of whom to ask it.

    Attributes
    ----------
    quick : bool
        A sample of the work, for every change; otherwise all of it.
    seed : int
        Seed of everything random; the same seed gives the same scenes.
    most : int
        Upper limit of the number of cases in each row, for tests of the harness itself.
    processes : int
        How many may work at a time in the parts that can share their work.
    solver : callable
        Called as `planner`, in its place.
    failures : path
        Folder for the scenes that failed; made when there is one.
    """

    quick: bool = False
    seed: int = 0
    most: int = 2**31
    processes: int = 1
    solver: Solver = planner
    failures: Path = Path("stress-failures")

    def count(self, full: int, quick: int) -> int:
        """Return how many cases to do."""
        return min(self.most, quick if self.quick else full)


@dataclass
class Row:
    """One line of the table; `tried` cases gave so many `path`, `no_path`, ... answers.

    `seconds` were spent in the planner, `checking` on certificates. `note` says what a reader of
    the table has to know, `failures` hold one line each. Parts that ask for no verdict (faults,
    hostile input) leave the verdicts at 0 and count in `tried` alone.
    """

    part: str
    case: str
    tried: int = 0
    path: int = 0
    no_path: int = 0
    undecided: int = 0
    refused: int = 0
    seconds: float = 0.0
    checking: float = 0.0
    note: str = ""
    failures: list[str] = field(default_factory=list)

    def add(self, other: Row, *, answers: bool = True) -> None:
        """Add another row: its failures and time, and its answers if they are to be counted."""
        self.seconds += other.seconds
        self.checking += other.checking
        self.failures += other.failures
        if answers:
            for name in ("tried", "path", "no_path", "undecided", "refused"):
                setattr(self, name, getattr(self, name) + getattr(other, name))


@dataclass(frozen=True)
class Answer:
    """What the planner said of a scene: a verdict, `REFUSED` or `CRASHED`."""

    verdict: str
    text: str
    result: Result | None = None


def ask(
    settings: Settings,
    row: Row,
    scene: Scene,
    options: Options = LIMITS,
    *,
    certified: bool = False,
    query: Query | None = None,
) -> Answer:
    """Solve a scene; count the answer in `row`, and as failures what no answer may show.

    If `certified`, the answer's certificate is made and checked. A `query` is asked instead of a
    new planner.
    """
    began = time.perf_counter()
    faulthandler.dump_traceback_later(
        options.timeout + HANGING, exit=True, file=sys.__stderr__ or sys.stderr
    )
    try:
        result = (query or settings.solver(scene))(options, certified)
        answer = Answer(result.verdict, result.reason, result)
    except SceneError as error:
        answer = Answer(REFUSED, str(error))
    except Exception as error:
        answer = Answer(CRASHED, f"{type(error).__name__}: {error}")
    finally:
        faulthandler.cancel_dump_traceback_later()
    seconds = time.perf_counter() - began
    row.tried += 1
    row.seconds += seconds
    if answer.verdict == CRASHED:
        fail(settings, row, scene, f"crashed: {answer.text}")
    else:
        setattr(row, answer.verdict, getattr(row, answer.verdict) + 1)
    if seconds > options.timeout + OVERTIME:
        fail(settings, row, scene, f"took {seconds:.1f} s at a limit of {options.timeout:g} s")
    rebuilds = 0 if answer.result is None else answer.result.stats.search_rebuilds
    if rebuilds:
        fail(settings, row, scene, f"search_rebuilds is {rebuilds}")
    if certified and answer.result is not None:
        began = time.perf_counter()
        wrong = certificate_failure(scene, answer.result, options.contact_tolerance)
        row.checking += time.perf_counter() - began
        if wrong is not None:
            fail(settings, row, scene, f"certificate of {answer.verdict} rejected: {wrong}")
    return answer


def expect(
    settings: Settings,
    row: Row,
    scene: Scene,
    allowed: Collection[str],
    options: Options = LIMITS,
    *,
    certified: bool = False,
    query: Query | None = None,
) -> Answer:
    """Ask, and count any answer but those `allowed` (and an undecided one) as a failure."""
    answer = ask(settings, row, scene, options, certified=certified, query=query)
    if answer.verdict not in {*allowed, "undecided", CRASHED}:  # a crash is counted already
        wanted = " or ".join(sorted(allowed))
        fail(settings, row, scene, f"{answer.verdict} where {wanted} is true ({answer.text})")
    return answer


def fail(settings: Settings, row: Row, scene: Scene | None, what: str) -> None:
    """Record a failure; the scene goes into a file that the line names."""
    name = "" if scene is None else str(scene.get("name", ""))
    line = f"{row.part}, {row.case}: {name}: {what}"
    if scene is not None and len(row.failures) < CASES_KEPT:
        settings.failures.mkdir(parents=True, exist_ok=True)
        plain = "".join(c if c.isalnum() else "-" for c in f"{row.part}-{row.case}-{name}")
        file = settings.failures / f"{plain[:80]}-{len(row.failures)}.json"
        file.write_text(json.dumps(scene), encoding="utf-8")
        line += f" [{file}]"
    row.failures.append(line)
