"""Answers bit for bit, whatever the optimisation level and the compiler.

``python tests/attacks/determinism.py`` builds the core at -O0 to -O3 with every compiler that
is installed, solves all shipped scenes with a limit on cells and none on time, and compares a hash
of verdict, counts and path. It fails if two differ, and writes ``bench/results/determinism.csv``.
``--quick`` builds with the default compiler at -O0 and -O3 only, and writes nothing.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

sys.path.extend(str(Path(__file__).resolve().parents[k]) for k in (1, 2))  # tests and scenarios

from planar_planner import load_scene
from planar_planner.problem.goal import Goal, GoalSet
from planar_planner.problem.make import Polygons, make_problem
from planar_planner.scene.builtin import manifest
from support import provenance

MAX_CELLS = 20_000
COMPILERS = ("g++", "clang++")
LEVELS = ("-O0", "-O1", "-O2", "-O3")
PROJECT = """\
cmake_minimum_required(VERSION 3.25)
project(determinism LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
add_subdirectory("{root}" core)
add_executable(determinism "{root}/tests/attacks/determinism.cpp")
target_link_libraries(determinism PRIVATE planner_core)
"""


def written(polygons: Polygons | None) -> list[str]:
    """Return polygons as the driver reads them: counts in decimal, coordinates in hexadecimal."""
    if polygons is None:
        return ["0"]
    coords, rings, starts = polygons.arrays
    out = [str(len(starts) - 1)]
    for first, last in pairwise(starts):
        out.append(str(last - first))
        for ring in range(first, last):
            points = coords[rings[ring] : rings[ring + 1]]
            out.append(str(len(points)))
            out += [float(x).hex() for x in points.ravel()]
    return out


def numbers(values: Any) -> list[str]:
    """Return a box, or nothing, as the driver reads it."""
    return ["0"] if values is None else ["1", *(float(x).hex() for x in values)]


def goal_numbers(goal: Goal, rotation: bool) -> list[str]:
    """Return a goal as the driver reads it: 0 and a configuration, or 1, polygons and angles."""
    if isinstance(goal, GoalSet):
        return ["1", *written(goal.polygons), *numbers(goal.angles if rotation else None)]
    return ["0", *(float(x).hex() for x in goal)]


def scenes() -> str:
    """Return the driver's input: all shipped scenes."""
    names = list(manifest())
    out = [str(MAX_CELLS), str(len(names))]
    for name in names:
        problem = make_problem(load_scene(name))
        out += [name, str(int(problem.rotation))]
        out += written(problem.robot) + written(problem.obstacles)
        out += numbers(problem.workspace_box) + written(problem.workspace)
        out += numbers(problem.reference_bounds)
        out += [float(x).hex() for x in problem.start]
        out += goal_numbers(problem.goal, problem.rotation)
    return " ".join(out)


def run(command: list[str], text: str = "") -> str:
    """Run a command; return what it printed."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, input=text)
    if done.returncode:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def answers(compiler: str, level: str, text: str) -> dict[str, tuple[str, str]]:
    """Return scene → (verdict, hash) with the core as this compiler makes it."""
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder, "CMakeLists.txt")
        project.write_text(PROJECT.format(root=provenance.ROOT.as_posix()), encoding="utf-8")
        options = {
            "CMAKE_CXX_COMPILER": compiler,
            "CMAKE_BUILD_TYPE": "None",
            "CMAKE_CXX_FLAGS": level,
            "PLANNER_PYTHON": "OFF",
            "SKBUILD_PROJECT_VERSION_FULL": "0",
        }
        build = str(Path(folder, "build"))
        run(["cmake", "-S", folder, "-B", build, *(f"-D{k}={v}" for k, v in options.items())])
        run(["cmake", "--build", build, "--target", "determinism", "-j2"])
        lines = run([str(Path(build, "determinism"))], text).splitlines()
    return {name: (verdict, value) for name, verdict, value in map(str.split, lines)}


def main() -> int:
    """Build, solve, compare."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="two builds, nothing written")
    arguments = parser.parse_args()
    facts = provenance.print_provenance()
    compilers = ["c++"] if arguments.quick else [c for c in COMPILERS if shutil.which(c)]
    levels = ("-O0", "-O3") if arguments.quick else LEVELS
    text = scenes()
    found: dict[str, dict[str, tuple[str, str]]] = {}
    for compiler in compilers:
        facts[compiler] = run([compiler, "--version"]).splitlines()[0]
        for level in levels:
            found[f"{compiler} {level}"] = answers(compiler, level, text)
            print(f"{compiler} {level}: {len(found[f'{compiler} {level}'])} scenes", flush=True)
    first = next(iter(found.values()))
    different = [
        f"{name}: {build} gives {there[name]}, the first build {first[name]}"
        for build, there in found.items()
        for name in first
        if there[name] != first[name]
    ]
    print(*different or [f"all {len(found)} builds agree on {len(first)} scenes"], sep="\n")
    if not arguments.quick:
        rows = [[name, *first[name], len(found)] for name in first]
        header = ["scene", "verdict", "hash", "builds_that_agree"]
        if not different:
            print(f"written: {provenance.write_csv('determinism.csv', facts, header, rows)}")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
