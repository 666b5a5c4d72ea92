"""The rooms of the house: which folder may use which, in the order in which data passes them.

A room is a folder, or a module that stands alone. The lists below are the one place where their
order is written down: a file imports from its own room and from rooms that stand before it, never
from one that stands after it. Files do not import each other in circles, not even through imports
inside functions. An import inside a function makes a start faster, or it moves to the top.
"""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from collections.abc import Sequence
from pathlib import PurePosixPath

import pytest

from architecture.import_graph import (
    ROOT,
    Where,
    circles,
    native_files,
    native_includes,
    python_files,
    python_imports,
)

PYTHON_ROOMS = (
    "pdg._core",
    "pdg.errors",
    "pdg.stop_reason",
    "pdg.tolerances",
    "pdg.aliases",
    "pdg._gate",
    "pdg.bodies",
    "pdg.depths",
    "pdg._set_frame",
    "pdg.sets",
    "pdg.distance",
    "pdg.grasp",
    "pdg",
    "planar_planner._core",
    "planar_planner.version",
    "planar_planner.errors",
    "planar_planner.frozen_arrays",
    "planar_planner.tolerances",
    "planar_planner.certificate_keys",
    "planar_planner.output_files",
    "planar_planner.scene",
    "planar_planner.problem",
    "planar_planner.formats.parts",
    "planar_planner.formats.outlines",
    "planar_planner.formats",
    "planar_planner.formats.readers",
    "planar_planner.formats.writers",
    "planar_planner.load",
    "planar_planner.checker",
    "planar_planner.explain",
    "planar_planner.planning",
    "planar_planner.typing",
    "planar_planner.margins",
    "planar_planner.physics",
    "planar_planner.ompl",
    "planar_planner.pictures",
    "planar_planner.films",
    "planar_planner.cli",
    "planar_planner.cli.arguments",
    "planar_planner.cli.commands",
    "planar_planner.cli.parser",
    "planar_planner.cli.main",
    "planar_planner",
)

NATIVE_ROOMS = (
    "pdg/native",
    "pdg/native/geometry",
    "pdg/native/triangulation",
    "pdg/native/pieces",
    "pdg/native/separation",
    "pdg/native/slices",
    "pdg/native/depth",
    "pdg/native/bounds",
    "pdg/native/convex_sets",
    "pdg/native/penetration_distance",
    "pdg/native/bindings",
    "planar_planner/native",
    "planar_planner/native/world",
    "planar_planner/native/layers",
    "planar_planner/native/configurations",
    "planar_planner/native/labels",
    "planar_planner/native/cells",
    "planar_planner/native/paths",
    "planar_planner/native/guesses",
    "planar_planner/native/search",
    "planar_planner/native/evidence",
    "planar_planner/native/planning",
    "planar_planner/native/bindings",
)

MOST_FILES = 16
"""Code files in a folder: what a reader takes in at a glance."""

SLOW_TO_IMPORT = (
    "PIL",
    "cssselect2",
    "ezdxf",
    "imageio_ffmpeg",
    "matplotlib",
    "mpl_toolkits",
    "numpy",
    "ompl",
    "pdg._core",
    "planar_planner._core",
    "pymunk",
    "rich",
    "shapely",
    "svgpathtools",
    "tinycss2",
    "yaml",
)

FILES = python_files()
IMPORTS = python_imports(FILES)
INCLUDES = native_includes(native_files())


def room_of(module: str) -> str:
    """Return the innermost room that a module stands in."""
    inside = [room for room in PYTHON_ROOMS if f"{module}.".startswith(f"{room}.")]
    return max(inside, key=len)


def test_every_room_is_there() -> None:
    compiled = {"pdg._core", "planar_planner._core"}
    assert {room_of(module) for module in FILES} == set(PYTHON_ROOMS) - compiled
    assert {str(PurePosixPath(file).parent) for file in INCLUDES} == set(NATIVE_ROOMS)


def test_python_imports_run_downwards() -> None:
    order = {room: place for place, room in enumerate(PYTHON_ROOMS)}
    upwards = [
        f"{module}:{found.line} imports {found.target}"
        for module, imports in IMPORTS.items()
        for found in imports
        if found.target.split(".")[0] in ("pdg", "planar_planner")
        and order[room_of(found.target)] > order[room_of(module)]
    ]
    assert upwards == []


def test_python_imports_make_no_circle() -> None:
    """Not even for type checkers alone."""
    graph = {module: [found.target for found in imports] for module, imports in IMPORTS.items()}
    assert circles(graph) == []


def test_includes_run_downwards() -> None:
    order = {room: place for place, room in enumerate(NATIVE_ROOMS)}
    upwards = [
        f"{file} includes {target}"
        for file, targets in INCLUDES.items()
        for target in targets
        if order[target.rpartition("/")[0]] > order[file.rpartition("/")[0]]
    ]
    assert upwards == []


def test_includes_make_no_circle() -> None:
    assert circles(INCLUDES) == []


def slow_imports(module: str) -> set[str]:
    """Return the slow libraries that importing a module of ours brings in."""
    slow: set[str] = set()
    seen: set[str] = set()
    waiting = [module]
    while waiting:
        name = waiting.pop()
        if name in seen or name not in IMPORTS:
            continue
        seen.add(name)
        for found in IMPORTS[name]:
            if found.where is Where.MODULE:
                parts = found.target.split(".")
                prefixes = {".".join(parts[:k]) for k in range(1, len(parts) + 1)}
                slow |= prefixes & set(SLOW_TO_IMPORT)
                waiting += prefixes
    return slow


def test_imports_inside_functions_save_time() -> None:
    """Each one keeps a slow library from being imported with the file that it stands in."""
    useless = [
        f"{module}:{found.line} imports {found.target}"
        for module, imports in IMPORTS.items()
        for found in imports
        if found.where is Where.FUNCTION
        and found.target in FILES
        and not slow_imports(found.target) - slow_imports(module)
        and (module, found.target) not in LATE
    ]
    assert useless == []


LATE = {
    ("planar_planner", "planar_planner.version"),
    ("planar_planner.__main__", "planar_planner.cli.main"),
}
"""What a package's `__getattr__` imports when the attribute is first asked for, and what comes
after the process answers Ctrl-C."""


def code_files() -> list[PurePosixPath]:
    listed = subprocess.run(
        ["git", "-C", str(ROOT), "ls-files", "--cached", "--others", "--exclude-standard"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()
    code = re.compile(r"\.(py|cpp|hpp|js)$")
    return [PurePosixPath(name) for name in listed if code.search(name) and (ROOT / name).exists()]


def test_no_folder_is_crowded() -> None:
    if not (ROOT / ".git").exists():
        pytest.skip("needs the repository: it lists the files that are kept")
    crowded = {
        str(folder): count
        for folder, count in Counter(file.parent for file in code_files()).items()
        if count > MOST_FILES
    }
    assert crowded == {}


@pytest.mark.parametrize(
    ("graph", "expected"),
    [
        ({"a": ["b"], "b": ["c"], "c": []}, []),
        ({"a": ["b"], "b": ["a"]}, [["a", "b"]]),
        ({"a": ["b"], "b": ["c"], "c": ["a", "d"], "d": ["d"]}, [["a", "b", "c"]]),
        ({"a": ["b", "c"], "b": [], "c": ["b"], "d": ["e"], "e": ["d"]}, [["d", "e"]]),
    ],
)
def test_circles_are_found(graph: dict[str, Sequence[str]], expected: list[list[str]]) -> None:
    assert circles(graph) == expected
