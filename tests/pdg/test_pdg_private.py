"""Only pdg itself imports its compiled core."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def imports_core(source: str) -> bool:
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.ImportFrom):
            names = {alias.name for alias in node.names}
            if node.module == "pdg._core" or (node.module == "pdg" and "_core" in names):
                return True
        if isinstance(node, ast.Import) and any(a.name == "pdg._core" for a in node.names):
            return True
    return False


@pytest.mark.parametrize("folder", ["planar_planner", "bench", "docs", "scenarios"])
def test_only_pdg_imports_its_core(folder: str) -> None:
    files = sorted((ROOT / folder).rglob("*.py"))
    assert files
    assert not [f for f in files if imports_core(f.read_text(encoding="utf-8"))]


@pytest.mark.parametrize(
    "source",
    ["from pdg._core import first_defect", "from pdg import _core", "import pdg._core as core"],
)
def test_an_import_of_the_core_is_seen(source: str) -> None:
    assert imports_core(source)
    assert not imports_core("from planar_planner import _core\nimport pdg")
