"""README.md and docs/ agree with the rest: links, statistics, navigation."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

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
    text = page.read_text(encoding="utf-8")
    listed = re.findall(r"^\.\. (?:auto\w+|data):: (\w+)$", text, re.MULTILINE)
    module = importlib.import_module(package)
    public = {name for name in module.__all__ if callable(getattr(module, name))}
    assert public - {"Result"} <= set(listed), "add it to the page"


def test_statistics_are_documented_as_the_core_lists_them() -> None:
    """Running docs/statistics_table.py again changes nothing."""
    place = ROOT / "docs" / "statistics_table.py"
    spec = importlib.util.spec_from_file_location(place.stem, place)
    assert spec is not None
    assert spec.loader is not None
    statistics_table = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(statistics_table)
    assert statistics_table.block() in (ROOT / "docs" / "method.md").read_text(encoding="utf-8"), (
        "python docs/statistics_table.py writes it"
    )


def test_every_room_is_on_the_map() -> None:
    method = (ROOT / "docs" / "method.md").read_text(encoding="utf-8")
    section = method.partition("## Where things are")[2].partition("\n## ")[0]
    named = set(re.findall(r"`([\w/]+)/`", section))
    for package in ("pdg", "planar_planner"):
        for root in (ROOT / package / "native", ROOT / package / "python" / package):
            sources = [path for path in root.rglob("*") if path.suffix in (".py", ".hpp")]
            rooms = {path.parent.relative_to(root).as_posix() for path in sources} - {"."}
            assert rooms and rooms <= named, root
