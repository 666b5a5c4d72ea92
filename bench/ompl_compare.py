"""Ours against OMPL's planners: ``python bench/ompl_compare.py [SCENE ...]``.

All shipped scenes, and any scene files named. OMPL runs from its Python wheel, with our compiled
state check called through Python, and natively (``ompl_native/``, where OMPL's development package
is installed), each run in a process with a seed of its own, at two resolutions of motion
validation. Every path is checked again continuously. Ours is certificate-ready: core and
certificate by the wall clock. The last table sets our median against the least median among OMPL's
planners that solve the scene with at least 95 % of their paths sound. ``--quick``: one resolution,
two scenes, one planner, in less than a minute.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path

from ompl_driver import PLANNERS, DriverMissingError, Request, build_driver, dump, run_driver
from ompl_picture import draw
from provenance import RESULTS, print_provenance, write_csv

from planar_planner.builtin import manifest
from planar_planner.compare import (
    OurRun,
    SamplerRun,
    Settings,
    check_scene,
    run_ours,
    run_samplers,
    sampler_run,
)
from planar_planner.comparison import Rows, aligned, spread
from planar_planner.errors import OptionsError, SceneError
from planar_planner.judge import Judge
from planar_planner.samplers import INSTALL_HINT

WHEEL_PLANNERS = ("RRTConnect", "PRM", "KPIECE1", "BITstar")
RESOLUTIONS = (0.01, 0.002)
SOUND = 0.95  # least share of sound paths with which a time counts
QUICK_SCENES = ("bug-trap", "slot-jammed")
MS = 1e3


@dataclass(frozen=True)
class Entry:
    """One planner on one scene: `source` is ``ours``, ``wheel`` or ``native``."""

    scene: str
    source: str
    planner: str
    resolution: float | None
    seconds: tuple[float, ...]
    checks: tuple[int, ...]
    lengths: tuple[float, ...]
    soundness: tuple[str, ...]

    @property
    def solved(self) -> int:
        """Runs with an answer."""
        return sum(math.isfinite(value) for value in self.seconds)

    @property
    def sound(self) -> float:
        """Share of the paths that are certified free; 0 without a path."""
        return self.soundness.count("sound") / len(self.soundness) if self.soundness else 0.0

    @property
    def collide(self) -> float:
        """Share of the paths that are shown to collide."""
        return self.soundness.count("collides") / len(self.soundness) if self.soundness else 0.0


@dataclass(frozen=True)
class Plan:
    """What to run."""

    scenes: tuple[str, ...]
    wheel: tuple[str, ...]
    native: tuple[str, ...]
    resolutions: tuple[float, ...]
    runs: int
    limit: float
    seed: int


def entry_of_ours(scene: str, runs: Sequence[OurRun]) -> Entry:
    """Return ours as an entry."""
    decided = [run.verdict != "undecided" for run in runs]
    return Entry(
        scene,
        "ours",
        runs[0].verdict,
        None,
        tuple(r.seconds if ok else math.inf for r, ok in zip(runs, decided, strict=True)),
        (),
        tuple(run.length for run in runs if run.verdict == "path"),
        tuple(run.soundness for run in runs if run.verdict == "path"),
    )


def entry_of(scene: str, source: str, resolution: float, runs: Sequence[SamplerRun]) -> Entry:
    """Return a sampler as an entry; a run that failed is told of at once."""
    for run in runs:
        if run.error:
            print(f"  {source} {run.planner}, seed {run.seed}: {run.error}", file=sys.stderr)
    exact = [run for run in runs if run.exact]
    return Entry(
        scene,
        source,
        runs[0].planner,
        resolution,
        tuple(run.seconds for run in runs),
        tuple(run.checks for run in runs),
        tuple(run.length for run in exact),
        tuple(run.soundness for run in exact),
    )


def entries(scene: str, plan: Plan, driver: Path | None) -> Iterator[Entry]:
    """Run everything on a scene. Without a path, once is enough: a sampler ends at its limit."""
    loaded, problem = check_scene(scene)
    judge = Judge(problem)
    run_ours(problem, judge, plan.limit)  # once untimed
    ours = [run_ours(problem, judge, plan.limit) for _ in range(plan.runs)]
    yield entry_of_ours(loaded.name, ours)
    hopeless = ours[0].verdict == "no_path"
    runs = 1 if hopeless else plan.runs
    settings = Settings(runs=runs, limit=plan.limit, seed=plan.seed)
    with tempfile.TemporaryDirectory() as folder:
        dumped = Path(folder) / "problem.txt"
        dumped.write_text(dump(problem), encoding="ascii")
        for resolution in plan.resolutions[-1:] if hopeless else plan.resolutions:
            settings = replace(settings, resolution=resolution)
            for planner in plan.wheel:
                found = list(run_samplers(loaded, judge, planner, settings))
                yield entry_of(loaded.name, "wheel", resolution, found)
            if driver is None:
                continue
            for planner in plan.native:
                found = []
                for seed in range(plan.seed + 1, plan.seed + 1 + runs):
                    request = Request(planner, seed, plan.limit, resolution)
                    answer = run_driver(driver, dumped, request)
                    found.append(sampler_run(planner, seed, answer, judge))
                yield entry_of(loaded.name, "native", resolution, found)


def best_of_ompl(found: Sequence[Entry]) -> Entry | None:
    """Return the sampler with the least median among those whose paths are sound enough."""
    fit = [
        entry
        for entry in found
        if entry.source != "ours"
        and entry.sound >= SOUND
        and math.isfinite(spread(entry.seconds).median)
    ]
    return min(fit, key=lambda entry: spread(entry.seconds).median, default=None)


def verdict_rows(found: Sequence[Entry]) -> Rows:
    """Return the last table: per scene, ours beside the best of OMPL."""
    rows: Rows = [("scene", "ours", "ms", "quartiles", "best of OMPL", "ms", "ours/best")]
    for scene in dict.fromkeys(entry.scene for entry in found):
        here = [entry for entry in found if entry.scene == scene]
        ours = next(entry for entry in here if entry.source == "ours")
        mine = spread(ours.seconds)
        best = best_of_ompl(here)
        beside = ("none", "-", "")
        if best is not None:
            theirs = spread(best.seconds).median
            name = f"{best.planner} {best.source} {best.resolution:g}"
            lost = " LOST" if mine.median > theirs else ""
            beside = (name, f"{MS * theirs:.3g}", f"{mine.median / theirs:.2f}{lost}")
        quartiles = f"{MS * mine.lower:.3g} to {MS * mine.upper:.3g}"
        rows.append((scene, ours.planner, f"{MS * mine.median:.3g}", quartiles, *beside))
    return rows


def line_of(entry: Entry) -> str:
    """Return one entry as a line of progress."""
    times = spread(entry.seconds)
    share = f"sound {100 * entry.sound:3.0f} %" if entry.soundness else ""
    resolution = "" if entry.resolution is None else f"{entry.resolution:g}"
    return (
        f"{entry.scene:<18} {entry.source:<7} {entry.planner:<12} {resolution:<6} "
        f"{entry.solved:>2}/{len(entry.seconds):<3} {MS * times.median:>10.4g} ms  {share}"
    )


def csv_row(entry: Entry) -> tuple[object, ...]:
    """Return one entry as a row of the CSV file; an infinite time is a run to the limit."""
    times = spread(entry.seconds)
    return (
        entry.scene,
        entry.source,
        entry.planner,
        "" if entry.resolution is None else entry.resolution,
        len(entry.seconds),
        entry.solved,
        *(f"{value:.6g}" for value in (times.median, times.lower, times.upper)),
        f"{spread(entry.checks).median:.0f}" if entry.checks else "",
        f"{spread(entry.lengths).median:.6g}" if entry.lengths else "",
        f"{entry.sound:.3f}" if entry.soundness else "",
        f"{entry.collide:.3f}" if entry.soundness else "",
    )


HEADER = (
    *("scene", "source", "planner", "resolution", "runs", "solved"),
    *("median_s", "lower_s", "upper_s", "checks", "length", "sound", "collide"),
)


def parse(argv: Sequence[str] | None = None) -> tuple[Plan, bool]:
    """Return what to run, and whether it is the quick comparison."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="files besides the shipped ones")
    parser.add_argument("--only", action="store_true", help="only the scenes named, not all")
    parser.add_argument("--runs", type=int, default=11, help="of each planner (default: 11)")
    parser.add_argument("--limit", type=float, default=10.0, help="seconds a run (default: 10)")
    parser.add_argument("--seed", type=int, default=0, help="run i has the seed SEED + i + 1")
    parser.add_argument("--quick", action="store_true", help="a short comparison, for CI")
    given = parser.parse_args(argv)
    if given.quick:
        scenes = tuple(given.scenes) or QUICK_SCENES
        return Plan(scenes, ("RRTConnect",), ("RRTConnect",), RESOLUTIONS[1:], 3, 1.0, 0), True
    shipped = () if given.only else tuple(manifest())
    plan = Plan(
        (*shipped, *given.scenes),
        WHEEL_PLANNERS,
        PLANNERS,
        RESOLUTIONS,
        given.runs,
        given.limit,
        given.seed,
    )
    return plan, False


def versions(plan: Plan, driver: Path | None) -> dict[str, str]:
    """Return what the samplers' runs depend on besides the provenance."""
    return {
        "ompl": f"wheel {version('ompl') if plan.wheel else 'missing'}, "
        f"native {'built' if driver else 'missing'}",
        "runs": f"{plan.runs} each, limit {plan.limit:g} s, seeds from {plan.seed + 1}; "
        "1 run of a sampler where there is no path",
    }


def main() -> int:
    """Run, print, write; 1 if a scene is undecided by ours or a path of ours is not sound."""
    plan, quick = parse()
    facts = print_provenance()
    try:
        version("ompl")
    except ModuleNotFoundError:
        print(f"wheel planners are left out: {INSTALL_HINT}")
        plan = replace(plan, wheel=())
    driver: Path | None = None
    try:
        driver = build_driver()
    except DriverMissingError as error:
        print(f"native planners are left out: {error}")
    facts |= versions(plan, driver)
    found: list[Entry] = []
    began = time.perf_counter()
    for scene in plan.scenes:
        try:
            for entry in entries(scene, plan, driver):
                print(line_of(entry), flush=True)
                found.append(entry)
        except (SceneError, OptionsError) as error:
            print(error, file=sys.stderr)
            return 2
    print(f"\n{time.perf_counter() - began:.0f} s; a time of inf is a run to the limit")
    print("\n".join(aligned(verdict_rows(found))))
    if not quick:
        print(f"\nwritten: {write_csv('ompl.csv', facts, HEADER, map(csv_row, found)).name}")
        draw(found, plan.limit, RESULTS / "ompl.png")
    ours = [entry for entry in found if entry.source == "ours"]
    return int(any(e.planner == "undecided" or set(e.soundness) - {"sound"} for e in ours))


if __name__ == "__main__":
    sys.exit(main())
