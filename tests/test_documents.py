"""README.md and docs/ agree with the rest: links, statistics, navigation."""

from __future__ import annotations

import importlib
import re
from pathlib import Path

import pytest

from planar_planner import load_scene, solve

ROOT = Path(__file__).parents[1]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if re.match(r"https?:", target):
            continue
        name, _, anchor = target.partition("#")
        file = page.parent / name if name else page
        assert file.exists(), target
        if anchor:
            assert anchor in anchors(file), target


def anchors(page: Path) -> set[str]:
    """Return the anchors that GitHub makes of a page's headings."""
    headings = re.findall(r"^#+ (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}


def test_every_page_is_in_the_navigation() -> None:
    docs = ROOT / "docs"
    index = (docs / "index.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^[\w/-]+$", index, re.MULTILINE))
    pages = {page.relative_to(docs).with_suffix("").as_posix() for page in docs.rglob("*.md")}
    assert pages - {"index"} <= listed, "name it in a toctree of docs/index.md"


@pytest.mark.parametrize("package", ["planar_planner", "pdg", "pdg.grasp"])
def test_every_public_name_is_in_the_reference(package: str) -> None:
    page = ROOT / "docs" / "api" / f"{package.replace('.', '_')}.md"
    listed = re.findall(r"^\.\. auto\w+:: (\w+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    module = importlib.import_module(package)
    public = {name for name in module.__all__ if callable(getattr(module, name))}
    assert public - {"Result"} <= set(listed), "add it to the page"


def test_every_statistic_is_explained() -> None:
    method = (ROOT / "docs" / "method.md").read_text(encoding="utf-8")
    section = method.partition("## Statistics")[2].partition("\n## ")[0]
    for key in solve(load_scene("corner")).stats:
        assert f"`{key}`" in section, key
