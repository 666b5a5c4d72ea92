"""Who imports whom: the packages' own modules by `ast`, native files by their includes.

Nothing of the project is imported or run.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

ROOT = Path(__file__).parents[2]
SOURCES = {name: ROOT / name / "python" / name for name in ("pdg", "planar_planner")}
NATIVE = tuple(ROOT / name / "native" for name in ("pdg", "planar_planner"))


class Where(Enum):
    """Where in its file an import stands."""

    MODULE = "at the top"
    FUNCTION = "inside a function"
    TYPES = "for type checkers only"


@dataclass(frozen=True)
class Import:
    """One module, or name, that a file imports.

    Attributes
    ----------
    target : str
        Dotted: the module if it is one of ours or a compiled core, else what the statement names.
    where : Where
        Where the statement stands.
    line : int
        Its line, from 1.
    """

    target: str
    where: Where
    line: int


def python_files() -> dict[str, Path]:
    """Return module name → file of both packages; a package goes by its own name."""
    found = {}
    for package, folder in SOURCES.items():
        for file in sorted(folder.rglob("*.py")):
            parts = file.relative_to(folder).with_suffix("").parts
            found[".".join((package, *(part for part in parts if part != "__init__")))] = file
    return found


def python_imports(files: Mapping[str, Path]) -> dict[str, list[Import]]:
    """Return what each module imports."""
    return {
        name: list(_imports(ast.parse(file.read_text(encoding="utf-8")), files, Where.MODULE))
        for name, file in files.items()
    }


def _imports(node: ast.AST, files: Mapping[str, Path], where: Where) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from (Import(alias.name, where, child.lineno) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            module = child.module or ""
            for alias in child.names:
                inner = f"{module}.{alias.name}"
                is_module = inner in files or alias.name == "_core"
                yield Import(inner if is_module else module, where, child.lineno)
        else:
            yield from _imports(child, files, _inside(child, where))


def _inside(node: ast.AST, where: Where) -> Where:
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return Where.FUNCTION
    if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
        return Where.TYPES
    return where


def native_files() -> dict[str, Path]:
    """Return path in the repository → file of every native source and header."""
    return {
        file.relative_to(ROOT).as_posix(): file
        for folder in NATIVE
        for file in sorted(folder.rglob("*.?pp"))
    }


def native_includes(files: Mapping[str, Path]) -> dict[str, list[str]]:
    """Return the project's files that each native file includes."""
    return {name: list(_included(name, file, files)) for name, file in files.items()}


def _included(name: str, file: Path, files: Mapping[str, Path]) -> Iterator[str]:
    folder = name.rpartition("/")[0]
    for stated in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.M):
        beside = f"{folder}/{stated}"
        if beside in files:
            yield beside
        elif stated in files:
            yield stated


def circles(graph: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """Return the circles of a graph: its strongly connected parts of two nodes or more, sorted.

    Tarjan's algorithm, without recursion.
    """
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    found = []
    for root in graph:
        if root in number:
            continue
        path = [(root, iter(graph[root]))]
        number[root] = lowest[root] = len(number)
        stack.append(root)
        while path:
            node, targets = path[-1]
            target = next((t for t in targets if t in graph and t != node), None)
            if target is None:
                path.pop()
                if path:
                    lowest[path[-1][0]] = min(lowest[path[-1][0]], lowest[node])
                if lowest[node] == number[node]:
                    part = stack[stack.index(node) :]
                    del stack[stack.index(node) :]
                    if len(part) > 1:
                        found.append(sorted(part))
            elif target not in number:
                number[target] = lowest[target] = len(number)
                stack.append(target)
                path.append((target, iter(graph[target])))
            elif target in stack:
                lowest[node] = min(lowest[node], number[target])
    return sorted(found)
