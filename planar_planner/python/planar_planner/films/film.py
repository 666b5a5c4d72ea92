"""Films of a result, as GIF or MP4; this module reads results and decides nothing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from planar_planner.errors import OptionsError
from planar_planner.films.canvas import Frame, check_size
from planar_planner.films.drive import drive_frames
from planar_planner.films.gif import check_gif_rate, write_gif
from planar_planner.films.material import Material
from planar_planner.films.mp4 import check_mp4_size, find_ffmpeg, write_mp4
from planar_planner.films.pace import Pace
from planar_planner.films.sweep import sweep_frames

FILM_SUFFIXES = (".gif", ".mp4")
DEFAULT_SIZE = (800, 600)


def write_film(
    material: Material,
    file: Path,
    *,
    suffix: str,
    pace: Pace,
    size: tuple[int, int] = DEFAULT_SIZE,
) -> None:
    """Write a film of the robot on its path or, without a path, of the cells angle by angle.

    The same input gives the same bytes, with the same versions of matplotlib, Pillow and ffmpeg.

    Parameters
    ----------
    material : Material
        The result of `planar_planner.films.material.gather`.
    file : path
        File to write.
    suffix : str
        .gif or .mp4; it may differ from the file's own suffix.
    pace : Pace
        Speed and number of frames.
    size : (width, height)
        In pixels.

    Raises
    ------
    OptionsError
        If format, pace and size are not compatible, if ffmpeg is missing, or if there is neither a
        path nor an angle to sweep.
    OutputError
        If ffmpeg fails.
    """
    check_film(suffix, pace, size)
    frames = film_frames(material, pace, size)
    if suffix.lower() == ".gif":
        write_gif(frames, pace.fps, file)
    else:
        write_mp4(frames, size, pace.fps, file)


def check_film(suffix: str, pace: Pace, size: tuple[int, int]) -> None:
    """Check before the work that a film can be written.

    Raises
    ------
    OptionsError
        As for `write_film`, except for what depends on the answer.
    """
    if suffix.lower() not in FILM_SUFFIXES:
        raise OptionsError(f"a film ends in {' or '.join(FILM_SUFFIXES)}, not {suffix!r}")
    check_size(size)
    if suffix.lower() == ".gif":
        check_gif_rate(pace.fps)
    else:
        check_mp4_size(size)
        find_ffmpeg()


def film_frames(material: Material, pace: Pace, size: tuple[int, int]) -> Iterator[Frame]:
    """Return the frames of the robot on its path, or of the cells if there is no path.

    Raises
    ------
    OptionsError
        If there is neither a path nor an angle to sweep.
    """
    if len(material.result.path):
        return drive_frames(material, pace, size)
    if not material.problem.rotation:
        raise OptionsError(
            "nothing moves: there is no path, and the robot may not turn; "
            "write .html instead, or a picture with solve --plot"
        )
    if not len(material.cells):
        raise OptionsError("nothing to show: there is no path, and no cell was made")
    return sweep_frames(material, pace, size)
