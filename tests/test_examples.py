"""Every example of README.md, CONTRIBUTING.md and docs/ runs and gives what is shown.

`documents.running` says how; files that examples read are in ``tests/documents/files``.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from documents.fenced import fenced_blocks
from documents.running import run_page

ROOT = Path(__file__).parents[1]
FILES = Path(__file__).parent / "documents" / "files"
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty current directory, without a window for pictures."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    return tmp_path


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_examples_run(page: Path, folder: Path) -> None:
    shutil.copytree(FILES, folder, dirs_exist_ok=True)
    run_page(fenced_blocks(page), folder)


def page_of(folder: Path, text: str) -> Path:
    page = folder / "page.md"
    page.write_text(text, encoding="utf-8")
    return page


@pytest.mark.parametrize(
    "text",
    [
        "```python\nprint(1)\n# 2\n```",
        "```python\n3 * 2\n# 5\n```",
        "```python\nraise ValueError\n```",
        "```sh\nplanar-planner check gear-jammed # exits 0\n```",
        "```sh\nplanar-planner check no-such-scene\n```",
        "```sh\nmake everything\n```",
        "```\nplanar-planner check gear\n```",
        "```console\n$ planar-planner check gear\nno path\n```",
        "```sh\nplanar-planner check gear | grep -q 'no path'\n```",
        "```klingon\nHeghlu'meH\n```",
    ],
)
def test_wrong_examples_are_refused(text: str, folder: Path) -> None:
    blocks = fenced_blocks(page_of(folder, text))
    with pytest.raises((AssertionError, ValueError)):
        run_page(blocks, folder)


@pytest.mark.parametrize(
    "text",
    [
        "```python\nn = 2\n```\nText.\n```python\nprint(n)\nprint(n + 1)\n# 3\nn * 2\n# 4\n```",
        "```sh\nplanar-planner check gear-jammed  # exits 1\nplanar-planner check gear-jammed\n```",
        "```console\n$ planar-planner check gear\ngear: path …\n```",
        "```sh\nplanar-planner check gear --json - | grep -q '\"path\"'\n```",
        "<!-- not run: there is no such command -->\n```sh\nmake everything\n```",
        "<!-- file: n.txt -->\n\n```text\n7\n```\n```python\nopen('n.txt').read()\n# '7\\n'\n```",
    ],
)
def test_right_examples_pass(text: str, folder: Path) -> None:
    run_page(fenced_blocks(page_of(folder, text)), folder)
