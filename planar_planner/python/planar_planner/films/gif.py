"""Frames → GIF, by Pillow."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from pathlib import Path

import numpy as np
from PIL import Image

from planar_planner.errors import OptionsError
from planar_planner.films.canvas import Frame

MAX_FPS = 50.0
"""GIF counts in hundredths of a second, and players slow down what is shorter than two of them."""

MAX_PIXELS = 1_000_000_000
"""Of all frames that differ, a byte each while the file is made; 83 s of 800 x 600, 25 a second."""


def write_gif(frames: Iterable[Frame], fps: float, file: Path) -> None:
    """Write a GIF that repeats for ever.

    All frames have the colours of the first one's palette, so that nothing flickers; equal frames
    that follow one another become one that stands longer.

    Raises
    ------
    OptionsError
        If there are more than 50 frames a second, or more than 10⁹ pixels in all.
    """
    check_gif_rate(fps)
    images: list[Image.Image] = []
    ends: list[int] = []  # hundredths of a second since the beginning: rounding never adds up
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
                f"a GIF of more than {MAX_PIXELS:,} pixels in all does not fit the memory: "
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
    """Refuse a rate that GIF cannot hold.

    Raises
    ------
    OptionsError
        If there are more than 50 frames a second.
    """
    if fps > MAX_FPS:
        raise OptionsError(f"a GIF shows at most {MAX_FPS:g} frames a second, not {fps:g}")
