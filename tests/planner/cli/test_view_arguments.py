"""`solve --plot FILE --view … --theta …`: what is drawn, and what is refused."""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import pytest

from planar_planner.cli.arguments.view import VIEWS, angles, view_of
from planar_planner.cli.main import main
from planar_planner.errors import OptionsError


@pytest.mark.parametrize("view", [view for view in VIEWS if view != "wall"])
def test_each_view_of_a_path_is_written(
    tmp_path: Path, view: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "picture.png"
    assert main(["solve", "open", "--plot", str(file), "--view", view, "--quiet"]) == 0
    assert file.stat().st_size > 1000
    assert capsys.readouterr().err == ""


def test_a_view_without_content_is_said_and_not_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "picture.png"
    assert main(["solve", "open", "--plot", str(file), "--view", "wall", "--quiet"]) == 0
    assert not file.exists()
    assert "is not written: no wall of cells" in capsys.readouterr().err


def test_no_path_is_explained_without_being_asked(tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    assert main(["solve", "corner-too-long", "--plot", str(file), "--quiet"]) == 1
    assert "where the wall was found thinnest" in file.read_text(encoding="utf-8")


def test_angles_imply_slices_and_may_be_negative(tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    arguments = ["solve", "open", "--plot", str(file), "--theta", "-0.5,90deg", "--quiet"]
    assert main(arguments) == 0
    assert "θ = 90°" in file.read_text(encoding="utf-8")


def test_angles_are_radians_or_degrees() -> None:
    assert angles("0,1.5,90deg, -45deg") == [0.0, 1.5, math.pi / 2, -math.pi / 4]
    for text in ("", "x", "1,,2", "1_0", "inf", "nandeg"):
        with pytest.raises(argparse.ArgumentTypeError):
            angles(text)


def test_what_does_not_fit_together_is_refused() -> None:
    def given(plot: str | None, view: str | None, theta: list[float] | None) -> str | None:
        return view_of(argparse.Namespace(plot=plot, view=view, theta=theta))

    assert given(None, None, None) is None
    assert given("a.png", None, [0.0]) == "slices"
    assert given("a.png", "space", None) == "space"
    for plot, view, theta in ((None, "wall", None), (None, None, [0.0]), ("a.png", "wall", [0.0])):
        with pytest.raises(OptionsError):
            given(plot, view, theta)
