"""The writer of GIF films, by Pillow."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from pathlib import Path

import numpy as np
from PIL import Image

from planar_planner.errors import OptionsError
from planar_planner.films.canvas import Frame

MAX_FPS = 50.0
"""GIF counts hundredths of a second, and players slow down frames shorter than two of them."""

MAX_PIXELS = 1_000_000_000
"""Most pixels of all distinct frames, one byte each in memory: 83 s at 800 x 600 and 25 fps."""


def write_gif(frames: Iterable[Frame], fps: float, file: Path) -> None:
    """Write a GIF that repeats without end.

    All frames use the palette of the first frame, so that nothing flickers. Equal frames in
    succession become one frame with a longer duration.

    Raises
    ------
    OptionsError
        If there are more than 50 frames per second, or more than 10⁹ pixels in all.
    """
    check_gif_rate(fps)
    images: list[Image.Image] = []
    ends: list[int] = []  # hundredths of a second since the beginning, so roundings do not add up
    palette: Image.Image | None = None
    last: Frame | None = None
    for k, frame in enumerate(frames):
        end = round(100.0 * (k + 1) / fps)
        if last is not None and np.array_equal(frame, last):
            ends[-1] = end
            continue
        image = Image.fromarray(frame)
        if (len(images) + 1) * image.width * image.height > MAX_PIXELS:
            raise OptionsError(
                f"a GIF may have at most {MAX_PIXELS:,} pixels in all: "
                "write .mp4, or raise speed, or lower seconds, fps or size"
            )
        if palette is None:
            palette = image.quantize(255, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
        images.append(image.quantize(palette=palette, dither=Image.Dither.NONE))
        ends.append(end)
        last = frame
    durations = [10 * (end - begin) for begin, end in zip(chain([0], ends), ends, strict=False)]
    images[0].save(
        file,
        format="GIF",
        save_all=True,
        append_images=images[1:],
        duration=durations,
        loop=0,
        optimize=False,
        disposal=1,
    )


def check_gif_rate(fps: float) -> None:
    """Refuse a rate that GIF cannot represent.

    Raises
    ------
    OptionsError
        If there are more than 50 frames per second.
    """
    if fps > MAX_FPS:
        raise OptionsError(f"a GIF shows at most {MAX_FPS:g} frames per second, not {fps:g}")
