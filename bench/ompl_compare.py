"""Ours against OMPL's planners: ``python bench/ompl_compare.py [SCENE ...]``.

All shipped scenes, and any files named: scenes or other formats (docs/formats.md), with options
for what those leave open. OMPL runs from its Python wheel, with our compiled
state check called through Python, and natively (``ompl_native/``, where OMPL's development package
is installed), each run in a process with a seed of its own, at two resolutions of motion
validation, natively at a third, finer one where the second does not make a planner's paths sound.
Every path is checked again continuously.

All clocks start with the scene's polygons in memory. Ours ends when the answer is certified;
exporting the certificate comes then, in a column of its own. A sampler's ends with its solve. The
last table sets our median against the least median among OMPL's planners that solve the scene with
at least 95 % of their paths sound: over this same span, and, harsher, without their preparation
(building the state check, OMPL's space). ``--quick``: one resolution, two scenes, one planner, in
less than a minute.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path

from lib.provenance import print_provenance, write_csv
from parts.ompl.driver import PLANNERS, DriverMissingError, Request, build_driver, dump, run_driver
from parts.ompl.picture import draw
from parts.ompl.table import (
    HEADER,
    SOUND,
    Entry,
    csv_row,
    entry_of,
    entry_of_ours,
    line_of,
    verdict_rows,
)
from planar_planner.cli.arguments.importing import add_importing, import_options
from planar_planner.errors import OptionsError, SceneError
from planar_planner.formats.parts import ImportOptions
from planar_planner.load import load_scene
from planar_planner.ompl.compare import (
    SamplerRun,
    Settings,
    check_scene,
    run_ours,
    run_samplers,
    sampler_run,
)
from planar_planner.ompl.comparison import aligned
from planar_planner.ompl.samplers import INSTALL_HINT
from planar_planner.planning.path_judge import Judge
from planar_planner.scene.builtin import manifest
from worlds.shipped import with_point_goals

WHEEL_PLANNERS = ("RRTConnect", "PRM", "KPIECE1", "BITstar")
RESOLUTIONS = (0.01, 0.002)
FINEST = 0.0005  # natively, for a planner whose paths at the last of them are not sound enough
QUICK_SCENES = ("bug-trap", "slot-jammed")


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
    importing: ImportOptions


def entries(scene: str, plan: Plan, driver: Path | None) -> Iterator[Entry]:
    """Run everything on a scene. Without a path, once is enough: a sampler ends at its limit."""
    own = ImportOptions() if scene in manifest() else plan.importing
    loaded, problem = check_scene(load_scene(scene, own))
    judge = Judge(problem)
    run_ours(problem, judge, plan.limit)  # once untimed
    ours = [run_ours(problem, judge, plan.limit) for _ in range(plan.runs)]
    yield entry_of_ours(loaded.name, ours)
    hopeless = ours[0].verdict == "no_path"
    runs = 1 if hopeless else plan.runs
    settings = Settings(runs=runs, timeout=plan.limit, seed=plan.seed)
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
                native = Native(driver, dumped, judge, planner, settings)
                entry = entry_of(loaded.name, "native", resolution, native.runs(resolution))
                yield entry
                if resolution == plan.resolutions[-1] and entry.soundness and entry.sound < SOUND:
                    yield entry_of(loaded.name, "native", FINEST, native.runs(FINEST))


@dataclass(frozen=True)
class Native:
    """One planner of the C++ driver on one scene."""

    driver: Path
    dumped: Path
    judge: Judge
    planner: str
    settings: Settings

    def runs(self, resolution: float) -> list[SamplerRun]:
        """Run it as often as the settings say, at this resolution instead of theirs."""
        first = self.settings.seed + 1
        found = []
        for seed in range(first, first + self.settings.runs):
            request = Request(self.planner, seed, self.settings.timeout, resolution)
            answer = run_driver(self.driver, self.dumped, request)
            found.append(sampler_run(self.planner, seed, answer, self.judge))
        return found


def parse(argv: Sequence[str] | None = None) -> tuple[Plan, bool]:
    """Return what to run, and whether it is the quick comparison."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="files besides the shipped ones")
    parser.add_argument("--only", action="store_true", help="only the scenes named, not all")
    parser.add_argument("--runs", type=int, default=11, help="of each planner (default: 11)")
    parser.add_argument("--limit", type=float, default=10.0, help="seconds a run (default: 10)")
    parser.add_argument("--seed", type=int, default=0, help="run i has the seed SEED + i + 1")
    parser.add_argument("--quick", action="store_true", help="a short comparison, for CI")
    add_importing(parser)
    given = parser.parse_args(argv)
    importing = import_options(given)
    if given.quick:
        scenes = tuple(given.scenes) or QUICK_SCENES
        one = ("RRTConnect",)
        return Plan(scenes, one, one, RESOLUTIONS[1:], 3, 1.0, 0, importing), True
    shipped = () if given.only else tuple(with_point_goals())
    plan = Plan(
        (*shipped, *given.scenes),
        WHEEL_PLANNERS,
        PLANNERS,
        RESOLUTIONS,
        given.runs,
        given.limit,
        given.seed,
        importing,
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
    print("times: from the scene's polygons in memory; ours to the certified answer, then export")
    print("\n".join(aligned(verdict_rows(found))))
    if not quick:
        print(f"\nwritten: {write_csv('ompl.csv', facts, HEADER, map(csv_row, found)).name}")
        draw(found, plan.limit, "ompl.png")
    ours = [entry for entry in found if entry.source == "ours"]
    return int(any(e.planner == "undecided" or set(e.soundness) - {"sound"} for e in ours))


if __name__ == "__main__":
    sys.exit(main())
