"""Frames → MP4, by the program ffmpeg, to which raw pictures are piped."""

from __future__ import annotations

import importlib
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path

from planar_planner.errors import OptionsError, OutputError
from planar_planner.films.canvas import Frame


def write_mp4(frames: Iterable[Frame], size: tuple[int, int], fps: float, file: Path) -> None:
    """Write an MP4 (H.264, 4:2:0, which every browser and phone plays).

    One thread and bit-exact flags, so the same frames give the same bytes with the same ffmpeg.

    Raises
    ------
    OptionsError
        If there is no ffmpeg, or a side of the picture is odd.
    OutputError
        If ffmpeg fails.
    """
    check_mp4_size(size)
    command = [
        *(find_ffmpeg(), "-loglevel", "error", "-y"),
        *("-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}", "-r", f"{fps:g}"),
        *("-i", "-", "-an", "-c:v", "libx264", "-preset", "fast", "-crf", "20"),
        *("-pix_fmt", "yuv420p", "-threads", "1", "-map_metadata", "-1"),
        *("-fflags", "+bitexact", "-flags:v", "+bitexact", "-movflags", "+faststart"),
        *("-f", "mp4", str(file)),
    ]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    ) as ffmpeg:
        if ffmpeg.stdin is None or ffmpeg.stderr is None:
            raise OutputError(f"cannot write {file}: no pipe to ffmpeg")
        try:
            for frame in frames:
                ffmpeg.stdin.write(frame.tobytes())
            ffmpeg.stdin.close()
        except BrokenPipeError:
            pass  # it has stopped reading; what it says follows
        except BaseException:
            ffmpeg.kill()
            raise
        said = ffmpeg.stderr.read().decode(errors="replace").strip().splitlines()
    if ffmpeg.returncode != 0:
        raise OutputError(f"cannot write {file}: ffmpeg: {said[-1] if said else 'failed'}")


def find_ffmpeg() -> str:
    """Return the ffmpeg to use: the system's, else that of the package imageio-ffmpeg.

    Raises
    ------
    OptionsError
        If there is neither.
    """
    found = shutil.which("ffmpeg")
    if found is not None:
        return found
    try:
        program = importlib.import_module("imageio_ffmpeg").get_ffmpeg_exe()
    except (ImportError, RuntimeError):
        raise OptionsError(
            "MP4 needs ffmpeg, which is not installed: install it, "
            'or pip install "planar-planner[animate]", or write .gif or .html'
        ) from None
    return str(program)


def check_mp4_size(size: tuple[int, int]) -> None:
    """Refuse a size that 4:2:0 video cannot have.

    Raises
    ------
    OptionsError
        If a side is odd.
    """
    if size[0] % 2 or size[1] % 2:
        raise OptionsError(f"MP4 needs even sides, not {size[0]}x{size[1]}")
