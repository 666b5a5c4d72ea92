"""Comparison with OMPL on the same scene: times, counts and soundness of paths.

Both clocks start with the scene's polygons in memory. This planner's clock ends when the answer is
certified, and a sampler's clock ends with its solve. The core's continuous check, which does not
depend on a motion validator's resolution, checks again every path that a sampler calls exact.
"""

from __future__ import annotations

import importlib.util
import itertools
import json
import math
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import OptionsError
from planar_planner.load import SceneLike, load_scene
from planar_planner.ompl.samplers import DEFAULT_SAMPLERS, INSTALL_HINT, check_samplers
from planar_planner.planning.certificate import make_certificate
from planar_planner.planning.engine import ask, make_core
from planar_planner.planning.options import Options
from planar_planner.planning.path_judge import Judge
from planar_planner.planning.placement import check_placements, find_placements
from planar_planner.planning.result import Result, make_result
from planar_planner.problem.make import Problem, make_problem, point_goal
from planar_planner.scene.import_report import NOT_IMPORTED, ImportReport
from planar_planner.scene.model import Scene

GRACE = 30.0
"""Seconds beyond the limit after which a sampler that exceeds it is ended; they include the import
of OMPL and the reading of the scene."""

MAX_SEED = 2**31
"""OMPL's generators take a seed of 32 bits other than 0."""


@dataclass(frozen=True)
class Settings:
    """Settings of a comparison.

    Attributes
    ----------
    planners : tuple of str
        Names of OMPL's planners.
    runs : int
        Repetitions, each sampler's with a seed of its own.
    timeout : float
        Seconds for one run, ours too.
    resolution : float
        Resolution of OMPL's motion validation, as a fraction of the space's extent; in (0, 1].
    seed : int
        Run i (from 0) of a sampler uses the seed ``seed + i + 1``.
    """

    planners: tuple[str, ...] = DEFAULT_SAMPLERS
    runs: int = 11
    timeout: float = 10.0
    resolution: float = 0.002
    seed: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "planners", check_samplers(self.planners))
        if not 1 <= self.runs <= 10_000:
            raise OptionsError(f"runs must be between 1 and 10000, not {self.runs!r}")
        if not (self.timeout > 0 and math.isfinite(self.timeout)):
            raise OptionsError(f"timeout must be positive and finite, not {self.timeout!r}")
        if not 0 < self.resolution <= 1:
            raise OptionsError(f"resolution must be in (0, 1], not {self.resolution!r}")
        if not 0 <= self.seed <= MAX_SEED:
            raise OptionsError(f"seed must be between 0 and {MAX_SEED}, not {self.seed!r}")


@dataclass(frozen=True)
class OurRun:
    """One query of this planner, on a fresh core; times are in seconds.

    Attributes
    ----------
    seconds : float
        Wall-clock time from the scene's polygons in memory until the answer is certified: building
        the core, and search. From then on the certificate can be exported.
    core_seconds : float
        The part of it that the core took, by its own clock.
    certificate_seconds : float
        Time of exporting the certificate, evidence and JSON object; not part of `seconds`.
    length, turning : float
        Length and turning of the path; 0 without a path.
    """

    verdict: str
    reason: str
    seconds: float
    core_seconds: float
    certificate_seconds: float
    cells: int
    length: float
    turning: float
    soundness: str


@dataclass(frozen=True)
class SamplerRun:
    """One run of one of OMPL's planners.

    Attributes
    ----------
    exact : bool
        Whether OMPL calls the solution exact.
    prepare_seconds : float
        Time from the scene's polygons in memory until the planner is made: building the state
        check, OMPL's space and its setup, the query, the planner; not a number if the process
        failed.
    seconds : float
        Time of the planner's setup and solve alone; infinite without an exact solution.
    checks : int
        Number of state validity checks.
    soundness : str
        ``sound``, ``collides`` or ``unknown`` (`Judge.path`); empty without an exact solution.
    check_ns, native_check_ns : float
        Time of one check as OMPL calls it through Python, and of the check itself; nanoseconds.
    error : str
        The reason for a missing answer, if the process failed.
    """

    planner: str
    seed: int
    exact: bool
    prepare_seconds: float
    seconds: float
    checks: int
    length: float
    turning: float
    soundness: str
    check_ns: float
    native_check_ns: float
    error: str = ""

    @property
    def total_seconds(self) -> float:
        """Time over the same span as `OurRun.seconds`; infinite without an exact solution."""
        return self.prepare_seconds + self.seconds if self.exact else math.inf


@dataclass(frozen=True)
class SceneComparison:
    """All runs on one scene.

    Attributes
    ----------
    reading_seconds : float
        Further time that a user waits: checking the scene in Python; the same for all planners.
    imported : ImportReport
        What an importer did to the scene's geometry.
    """

    scene: str
    reading_seconds: float
    ours: tuple[OurRun, ...]
    samplers: dict[str, tuple[SamplerRun, ...]]
    imported: ImportReport = NOT_IMPORTED


def require_ompl() -> None:
    """Check before the work that OMPL is installed.

    Raises
    ------
    OptionsError
        If it is not; the message says how to install it.
    """
    if importlib.util.find_spec("ompl") is None:
        raise OptionsError(INSTALL_HINT)


def check_scene(scene: SceneLike) -> tuple[Scene, Problem]:
    """Load a scene and check it with its start and goal.

    Raises
    ------
    SceneError
        If it is not valid, or start or goal collide or are out of bounds.
    """
    loaded = load_scene(scene)
    problem = make_problem(loaded)
    point_goal(problem, "a comparison with samplers")
    check_placements(find_placements(make_core(problem), problem), problem, 0.0)
    return loaded, problem


Stepped = Callable[[str, int, int], None]
"""Called with what is running, how many runs are done, and how many there are."""


def compare(
    scene: SceneLike, settings: Settings, stepped: Stepped | None = None
) -> SceneComparison:
    """Run this planner and OMPL's planners on a scene, one after another.

    Raises
    ------
    OptionsError
        If OMPL is not installed.
    SceneError
        If the scene is not valid, or start or goal collide or are out of bounds.
    """
    require_ompl()
    began = time.perf_counter()
    loaded, problem = check_scene(scene)
    reading = time.perf_counter() - began
    judge = Judge(problem)
    run_ours(problem, judge, settings.timeout)  # once untimed: imports, the processor's clock
    ours = tuple(run_ours(problem, judge, settings.timeout) for _ in range(settings.runs))
    samplers: dict[str, tuple[SamplerRun, ...]] = {}
    for name in settings.planners:
        runs = []
        for run in run_samplers(loaded, judge, name, settings):
            runs.append(run)
            if stepped is not None:
                done = len(samplers) * settings.runs + len(runs)
                stepped(f"{loaded.name}, {name}", done, len(settings.planners) * settings.runs)
        samplers[name] = tuple(runs)
    return SceneComparison(loaded.name, reading, ours, samplers, loaded.imported)


def run_ours(problem: Problem, judge: Judge, timeout: float) -> OurRun:
    """Answer the query once on a fresh core, then export the certificate."""
    options = Options(timeout=timeout)
    began = time.perf_counter()
    core = make_core(problem)
    answer = ask(core, problem, options)
    answered = time.perf_counter()
    certificate = make_certificate(problem, core.evidence(), options.contact_tolerance)
    ended = time.perf_counter()
    result: Result = make_result(problem.name, answer, certificate, problem.imported)
    return OurRun(
        verdict=result.verdict,
        reason=result.reason,
        seconds=answered - began,
        core_seconds=float(result.stats.seconds.total),
        certificate_seconds=ended - answered,
        cells=int(result.stats.cells),
        length=path_length(result.path.tolist()),
        turning=path_turning(result.path.tolist()),
        soundness=judge.path(result.path) if result.verdict == "path" else "",
    )


def run_samplers(
    scene: Scene, judge: Judge, planner: str, settings: Settings
) -> Iterator[SamplerRun]:
    """Run one of OMPL's planners as often as the settings say, each time in a new process."""
    for i in range(settings.runs):
        seed = settings.seed + i + 1
        request = {
            "scene": scene.to_dict(),
            "planner": planner,
            "seed": seed,
            "timeout": settings.timeout,
            "resolution": settings.resolution,
        }
        yield sampler_run(planner, seed, _in_a_process(request), judge)


def sampler_run(planner: str, seed: int, answer: dict[str, Any], judge: Judge) -> SamplerRun:
    """Check the answer of a process of `planar_planner.ompl.sampler_run` or of a native driver."""
    exact = bool(answer.get("exact", False))
    path = answer.get("path", [])
    return SamplerRun(
        planner=planner,
        seed=seed,
        exact=exact,
        prepare_seconds=float(answer.get("prepare_seconds", math.nan)),
        seconds=float(answer["seconds"]) if exact else math.inf,
        checks=int(answer.get("checks", 0)),
        length=path_length(path),
        turning=path_turning(path),
        soundness=_judged(np.array(path, dtype=np.float64), judge) if exact else "",
        check_ns=float(answer.get("check_ns", math.nan)),
        native_check_ns=float(answer.get("native_check_ns", math.nan)),
        error=str(answer.get("error", "")),
    )


def _judged(path: NDArray[np.float64], judge: Judge) -> str:
    """Return whether a sampler's path is sound; a path between other ends is ``unknown``."""
    return judge.path(path) if judge.joins(path) else "unknown"


def _in_a_process(request: dict[str, Any]) -> dict[str, Any]:
    """Return the answer of one run; a process that fails gives a run without an answer."""
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-m", "planar_planner.ompl.sampler_run"],
            input=json.dumps(request),
            capture_output=True,
            text=True,
            timeout=2 * request["timeout"] + GRACE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return {"error": "did not stop at its limit"}
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        lines = [line for line in done.stderr.splitlines() if "nanobind" not in line]
        return {"error": lines[-1] if lines else f"ended with status {done.returncode}"}
    return answer if isinstance(answer, dict) else {"error": "answered nonsense"}


def path_length(path: Sequence[Sequence[float]]) -> float:
    """Return how far the reference point moves, in the scene's unit."""
    return sum(math.dist(a[:2], b[:2]) for a, b in itertools.pairwise(path))


def path_turning(path: Sequence[Sequence[float]]) -> float:
    """Return how much the robot turns, in radians."""
    return sum(abs(b[2] - a[2]) for a, b in itertools.pairwise(path))
