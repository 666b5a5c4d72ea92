"""Films: what the frames show, their number and timing, the same bytes twice, and refusals."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_planner import Planner
from planar_planner.errors import OptionsError, OutputError
from planar_planner.explain.cells import LABEL_COLOURS, LABELS
from planar_planner.films import gif, mp4
from planar_planner.films.film import check_film, film_frames, write_film
from planar_planner.films.gif import write_gif
from planar_planner.films.material import Material, gather
from planar_planner.films.pace import Pace
from planar_planner.pictures import MIDWAY

SIZE = (240, 200)
SHORT = Pace(seconds=0.6, fps=10.0, hold=0.2)


def material_of(name: str) -> Material:
    planner = Planner(name)
    return gather(planner, planner.solve())


@pytest.fixture(scope="module")
def driven() -> Material:
    return material_of("gear")


@pytest.fixture(scope="module")
def too_long() -> Material:
    return material_of("corner-too-long")


def like(frame: np.ndarray, colour: str, tolerance: int = 30) -> np.ndarray:
    wanted = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])
    return (np.abs(frame.astype(int) - wanted) <= tolerance).all(axis=2)


def test_the_robot_moves_and_stands_still_at_both_ends(driven: Material) -> None:
    frames = list(film_frames(driven, SHORT, SIZE))
    assert len(frames) == 7 + 2 + 2  # ends included, two held frames at each
    assert {frame.shape for frame in frames} == {(200, 240, 3)}
    for still in (frames[:3], frames[-3:]):
        assert all((frame == still[0]).all() for frame in still)
    centres = [np.argwhere(like(frame, MIDWAY)).mean(axis=0) for frame in frames[2:9]]
    assert all(np.hypot(*(b - a)) > 2.0 for a, b in itertools.pairwise(centres))


def test_gif_holds_all_frames_for_their_time_and_is_deterministic(
    driven: Material, tmp_path: Path
) -> None:
    files = [tmp_path / name for name in ("a.gif", "b.gif")]
    for file in files:
        write_film(driven, file, suffix=".gif", pace=SHORT, size=SIZE)
    assert files[0].read_bytes() == files[1].read_bytes()
    with Image.open(files[0]) as film:
        assert film.size == SIZE
        assert film.info["loop"] == 0
        durations = []
        for k in range(film.n_frames):
            film.seek(k)
            durations.append(film.info["duration"])
    assert sum(durations) == 1100
    assert durations[0] == durations[-1] == 300  # held frames are one that stands longer


def test_rounding_of_gif_durations_does_not_add_up(tmp_path: Path) -> None:
    frames = [np.full((8, 8, 3), 20 * k, dtype=np.uint8) for k in range(12)]
    write_gif(frames, 30.0, tmp_path / "a.gif")
    with Image.open(tmp_path / "a.gif") as film:
        total = 0
        for k in range(film.n_frames):
            film.seek(k)
            total += film.info["duration"]
    assert total == 400


def test_a_gif_that_would_fill_the_memory_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(gif, "MAX_PIXELS", 64 * 5)
    frames = [np.full((8, 8, 3), 20 * (k // 2), dtype=np.uint8) for k in range(12)]
    write_gif(frames[:10], 10.0, tmp_path / "a.gif")
    with pytest.raises(OptionsError, match=r"write \.mp4"):
        write_gif(frames, 10.0, tmp_path / "b.gif")


def test_mp4_is_playable_and_deterministic(driven: Material, tmp_path: Path) -> None:
    files = [tmp_path / name for name in ("a.mp4", "b.mp4")]
    for file in files:
        write_film(driven, file, suffix=".mp4", pace=SHORT, size=SIZE)
    assert files[0].read_bytes() == files[1].read_bytes()
    read_back = subprocess.run(
        [
            *(mp4.find_ffmpeg(), "-loglevel", "error", "-i", str(files[0])),
            *("-f", "rawvideo", "-pix_fmt", "rgb24", "-"),
        ],
        capture_output=True,
        check=True,
    ).stdout
    frames = np.frombuffer(read_back, dtype=np.uint8).reshape(-1, 200, 240, 3)
    assert len(frames) == 11
    drawn = list(film_frames(driven, SHORT, SIZE))
    assert np.abs(frames[6].astype(int) - drawn[6]).mean() < 4.0
    body = like(drawn[6], MIDWAY, 40)
    assert body.sum() > 40
    assert frames[6][body].mean(axis=0) == pytest.approx(drawn[6][body].mean(axis=0), abs=25)


def test_without_a_path_the_cells_are_swept_through_all_angles(too_long: Material) -> None:
    assert too_long.result.verdict == "no_path"
    frames = list(film_frames(too_long, SHORT, SIZE))
    assert len(frames) == 7
    assert any((a != b).any() for a, b in itertools.pairwise(frames))
    seen = set(too_long.cells.label.tolist())
    for label in seen:
        colour = LABEL_COLOURS[LABELS[label]]
        assert any(like(frame, colour, 3).sum() > 20 for frame in frames), LABELS[label]


def test_cells_are_made_where_the_answer_needed_none() -> None:
    planner = Planner("open")
    result = planner.solve()
    assert len(planner.cells()) == 0
    shown = gather(planner, result)
    assert shown.second_search
    assert len(shown.cells) > 0
    assert len(gather(planner, result, cells_needed=False).cells) == 0


@pytest.mark.parametrize("scene", ["window-fixed", "slide-blocked"])
def test_nothing_moves_where_nothing_can(scene: str) -> None:
    with pytest.raises(OptionsError, match="nothing moves"):
        film_frames(material_of(scene), SHORT, SIZE)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Pace(speed=1.0, seconds=1.0), "one of them"),
        (lambda: Pace(speed=0.0), "speed"),
        (lambda: Pace(seconds=float("nan")), "seconds"),
        (lambda: Pace(fps=0.0), "fps"),
        (lambda: Pace(hold=-1.0), "hold"),
        (lambda: Pace(seconds=801.0).moving_frames(1.0), "frames"),
        (lambda: Pace(speed=1e-300).moving_frames(1e300), "frames"),
        (lambda: check_film(".gif", Pace(fps=60.0), SIZE), "50 frames"),
        (lambda: check_film(".mp4", Pace(), (241, 200)), "even"),
        (lambda: check_film(".avi", Pace(), SIZE), "avi"),
    ],
)
def test_refusals(make, message: str) -> None:
    with pytest.raises(OptionsError, match=message):
        make()


@pytest.mark.parametrize("size", [(100, 300), (300, 5000)])
def test_sizes_are_bounded(driven: Material, size: tuple[int, int]) -> None:
    with pytest.raises(OptionsError, match="160 to 4096"):
        next(iter(film_frames(driven, SHORT, size)))


def test_speed_is_travel_a_second() -> None:
    assert Pace(speed=2.0, fps=10.0).moving_frames(8.0) == 41
    assert Pace(fps=10.0).moving_frames(8.0) == 101
    assert Pace(speed=1.0).moving_frames(0.0) == 2


def test_a_missing_ffmpeg_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mp4.shutil, "which", lambda _: None)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(OptionsError, match=r"planar-planner\[animate\]"):
        check_film(".mp4", Pace(), SIZE)


def test_a_failing_ffmpeg_is_reported(tmp_path: Path) -> None:
    frames = [np.zeros((200, 240, 3), dtype=np.uint8)] * 3
    with pytest.raises(OutputError, match="ffmpeg"):
        mp4.write_mp4(frames, SIZE, 10.0, tmp_path / "missing" / "a.mp4")
