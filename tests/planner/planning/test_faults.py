"""What a planner is after a query that failed, and what an output is that cannot be written."""

from __future__ import annotations

import importlib
import json
import shutil
import signal
from pathlib import Path
from typing import Any

import pytest

import planar_planner
from planar_planner import Statistics
from planar_planner.cli.main import main
from planar_planner.errors import OutputError
from support.stand_in_core import FakeCore


class ListenerError(Exception):
    pass


@pytest.fixture
def scene_file(tmp_path: Path, scene_dict: dict[str, Any]) -> str:
    file = tmp_path / "small.json"
    file.write_text(json.dumps(scene_dict), encoding="utf-8")
    return str(file)


def raising(error: BaseException) -> Any:
    def during_solve(listener: Any) -> None:
        raise error

    return staticmethod(during_solve)


def test_out_of_memory_is_undecided_and_costs_the_core(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    fake_core.during_solve = raising(MemoryError("std::bad_alloc"))
    result = planner.solve(certificate=True)
    assert (result.verdict, result.reason) == ("undecided", "out of memory")
    assert (len(result.path), result.stats, result.certificate) == (0, Statistics(), None)
    fake_core.during_solve = FakeCore.during_solve
    assert planner.solve().verdict == "path"
    assert len(fake_core.built) == 2  # cells half divided are not asked again


def test_exception_of_a_listener_passes_and_costs_the_core(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    fake_core.during_solve = raising(ListenerError())
    with pytest.raises(ListenerError):
        planner.solve()
    fake_core.during_solve = FakeCore.during_solve
    assert planner.solve().verdict == "path"
    assert len(fake_core.built) == 2


def test_interrupt_that_a_library_made_another_error_of(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """As numpy does where it is struck on import."""

    def struck(_: Any) -> None:
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            raise ImportError("numpy was struck") from None

    fake_core.during_solve = staticmethod(struck)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        assert main(["solve", scene_file]) == 3
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
    assert capsys.readouterr().err == "planar-planner: interrupted\n"


def test_bad_ends_do_not_cost_the_core(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    fake_core.placements = staticmethod(
        lambda q: {"state": "outside", "exact": False, "what": "reference_bounds", "depth": 1.0}
    )
    with pytest.raises(planar_planner.SceneError, match="outside reference_bounds"):
        planner.solve()
    fake_core.placements = FakeCore.placements
    assert planner.solve().verdict == "path"
    assert len(fake_core.built) == 1


def test_a_listener_cannot_ask_its_own_planner(
    fake_core: type[FakeCore], scene_dict: dict[str, Any]
) -> None:
    planner = planar_planner.Planner(scene_dict)
    fake_core.during_solve = staticmethod(lambda listener: listener({}))
    with pytest.raises(RuntimeError, match="one query at a time"):
        planner.solve(listener=lambda _: bool(planner.solve()))
    fake_core.during_solve = FakeCore.during_solve
    assert planner.solve().verdict == "path"


def test_report_of_an_answer_without_statistics(
    fake_core: type[FakeCore], scene_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    fake_core.during_solve = raising(MemoryError())
    assert main(["solve", scene_file, "--json", "-"]) == 3
    assert json.loads(capsys.readouterr().out)["reason"] == "out of memory"
    assert main(["solve", scene_file]) == 3
    captured = capsys.readouterr()
    assert captured.out.startswith("small: undecided (out of memory)\n")
    assert captured.err == ""


@pytest.mark.parametrize("option", ["--json", "--plot"])
def test_directory_that_vanishes_during_the_search(
    fake_core: type[FakeCore],
    scene_file: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    option: str,
) -> None:
    folder = tmp_path / "there"
    folder.mkdir()
    fake_core.during_solve = staticmethod(lambda _: shutil.rmtree(folder))
    assert main(["solve", scene_file, "--quiet", option, str(folder / "out.png")]) == 2
    err = capsys.readouterr().err
    assert err == f"planar-planner: cannot write {folder / 'out.png'}: No such file or directory\n"


def test_memory_that_runs_out_while_writing_keeps_the_old_file(
    fake_core: type[FakeCore],
    scene_file: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def write_text(self: Path, text: str, encoding: str) -> int:
        raise MemoryError

    file = tmp_path / "out.json"
    file.write_text("old")
    command = importlib.import_module("planar_planner.cli.commands.solve")
    monkeypatch.setattr(Path, "write_text", write_text)
    arguments = main.__globals__["parse"](["solve", scene_file, "--json", str(file)])
    arguments.stated = main.__globals__["Stated"]()
    with pytest.raises(OutputError, match="out of memory"):
        command.run(arguments)
    assert file.read_text() == "old"
    assert sorted(f.name for f in tmp_path.iterdir()) == ["out.json", "small.json"]


def test_picture_through_a_link_to_a_file_without_a_suffix(
    fake_core: type[FakeCore], scene_file: str, tmp_path: Path
) -> None:
    """The format is that of the name given; nothing but the link's target is written."""
    folder = tmp_path / "pictures"
    folder.mkdir()
    (folder / "target").write_text("old")
    (folder / "link.png").symlink_to(folder / "target")
    for command in ("solve", "show"):
        assert main([command, scene_file, "--plot", str(folder / "link.png")]) == 0
        assert (folder / "target").read_bytes().startswith(b"\x89PNG")
        assert (folder / "link.png").is_symlink()
        assert sorted(f.name for f in folder.iterdir()) == ["link.png", "target"]
        (folder / "target").write_text("old")
