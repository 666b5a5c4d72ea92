"""What the checker shares with the planner: the reader of scenes, and nothing else.

CONTRIBUTING.md, docs/certificate.md and docs/guarantees.md say it; this file holds it.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import planar_planner
from worlds.hand_made_certificates import hand_made

PACKAGE = Path(planar_planner.__file__).parent
CHECKER = "planar_planner.checker"
SHARED_MODULES = {
    "planar_planner",
    "planar_planner.certificate_keys",
    "planar_planner.errors",
    "planar_planner.frozen_arrays",  # of a problem
    "planar_planner.load",
    "planar_planner.tolerances",  # of the readers of drawings
}
SHARED_ROOMS = {"planar_planner.formats", "planar_planner.problem", "planar_planner.scene"}
LIBRARIES = {"numpy"}
PLANNERS = ("pdg", "planar_planner._core", "planar_planner.planning", "planar_planner.explain")


def source_of(module: str) -> Path | None:
    """Return the file of a module of ours; None if there is none of that name."""
    if module.split(".", maxsplit=1)[0] not in ("planar_planner", "pdg"):
        return None  # libraries may be installed beside
    place = PACKAGE.parent.joinpath(*module.split("."))
    files = (place.with_suffix(".py"), place / "__init__.py")
    return next((file for file in files if file.is_file()), None)


def imports_of(nodes: list[ast.stmt], *, in_functions: bool) -> Iterator[str]:
    """Yield the modules that statements import, without those for types alone."""
    for node in nodes:
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0
            assert node.module is not None
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                yield inner if source_of(inner) else node.module
        elif in_functions or not isinstance(node, ast.FunctionDef):
            inner_nodes = [n for n in ast.iter_child_nodes(node) if isinstance(n, ast.stmt)]
            yield from imports_of(inner_nodes, in_functions=in_functions)


def imported_with(module: str) -> set[str]:
    """Return all modules that are imported with a module of ours, itself and packages included."""
    found: set[str] = set()
    waiting = [module]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        found.add(name)
        file = source_of(name)
        if file is None:
            continue
        waiting += imports_of(ast.parse(file.read_text("utf-8")).body, in_functions=False)
        if "." in name:
            waiting.append(name.rpartition(".")[0])
    return found


def is_shared(module: str) -> bool:
    room = ".".join(module.split(".")[:2])
    return module in SHARED_MODULES or room in SHARED_ROOMS | {CHECKER}


def ours(modules: set[str]) -> set[str]:
    return {name for name in modules if name.split(".")[0] in ("planar_planner", "pdg")}


def test_imports_of_the_checker() -> None:
    """With all that they import in turn: the reader of scenes, numpy, the standard library."""
    files = (PACKAGE / "checker").glob("*.py")
    modules = set().union(*(imported_with(f"{CHECKER}.{file.stem}") for file in files))
    assert {name for name in ours(modules) if not is_shared(name)} == set()
    libraries = {name.split(".")[0] for name in modules - ours(modules)}
    assert libraries - set(sys.stdlib_module_names) <= LIBRARIES
    assert not [name for name in modules if "readers" in name or "writers" in name]


def test_the_checker_imports_nothing_in_functions() -> None:
    for file in (PACKAGE / "checker").glob("*.py"):
        body = ast.parse(file.read_text("utf-8")).body
        everywhere = list(imports_of(body, in_functions=True))
        assert everywhere == list(imports_of(body, in_functions=False)), file


def test_the_imports_of_the_planner_are_seen() -> None:
    """The same look at the planner finds what the checker may not have."""
    modules = imported_with("planar_planner.planning.planner")
    unshared = {name for name in ours(modules) if not is_shared(name)}
    assert {"planar_planner._core", "planar_planner.planning.certificate"} <= unshared


def modules_after(code: str) -> set[str]:
    """Run code in a new Python and return the names of our modules that it has loaded."""
    report = "\nimport json, sys; print(json.dumps(sorted(sys.modules)))"
    done = subprocess.run(
        [sys.executable, "-P", "-c", code + report],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return ours(set(json.loads(done.stdout.splitlines()[-1])))


@pytest.mark.parametrize("name", ["gap", "disc", "goal_in_wall", "over_block", "bent_workspace"])
def test_a_verification_loads_none_of_the_planner(name: str, tmp_path: Path) -> None:
    """Neither its packages nor native code; in the library, and on the command line."""
    files = [tmp_path / "scene.json", tmp_path / "certificate.json"]
    for file, content in zip(files, hand_made(name), strict=True):
        file.write_text(json.dumps(content), encoding="utf-8")
    scene, certificate = map(str, files)
    loaded = modules_after(
        "from planar_planner import verify_certificate\n"
        f"assert verify_certificate({scene!r}, {certificate!r}).claims >= 0"
    )
    assert f"{CHECKER}.verify" in loaded
    assert {module for module in loaded if not is_shared(module)} == set()
    loaded = modules_after(
        f"from planar_planner.cli.main import main\nassert main(['verify', {scene!r}, "
        f"{certificate!r}]) == 0"
    )
    assert f"{CHECKER}.verify" in loaded
    assert not [module for module in loaded if module.startswith(PLANNERS)]


def test_a_solve_loads_the_planner() -> None:
    """So the names of what a verification must not load are right."""
    loaded = modules_after("from planar_planner import solve\nsolve('slide')")
    for planner in PLANNERS:
        assert any(module.startswith(planner) for module in loaded), planner
