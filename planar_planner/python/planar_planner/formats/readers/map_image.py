"""Images of occupancy maps as levels of colour and opacity."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, cut
from planar_planner.formats.reading import require

MAX_CELLS = 2**26
"""Largest number of cells of a map, 8192 × 8192; reading takes some ten bytes per cell."""

_FORMATS = ("PPM", "PNG", "BMP", "JPEG", "GIF")
_WIDE = ("I", "I;16", "I;16B")  # Pillow's names of 16-bit grey; it scales such PGM files to 65535


@dataclass(frozen=True)
class Image:
    """An image, the highest row first.

    Attributes
    ----------
    colours : NDArray, shape (rows, columns, 1 or 3)
        Levels of grey, or of red, green and blue; integers from 0 to `top`.
    alpha : NDArray, shape (rows, columns), or None
        Opacity from 0 to `top`; None if the image has no alpha channel.
    top : int
        255 or 65535.
    """

    colours: NDArray[Any]
    alpha: NDArray[Any] | None
    top: int

    @property
    def coloured(self) -> bool:
        """Whether any cell is not grey."""
        first = self.colours[..., :1]
        return bool((self.colours[..., 1:] != first).any())


def decoded(data: bytes) -> Image:
    """Decode an image.

    Raises
    ------
    SceneError
        If it is none, too large, or of a kind that is not read; without a source.
    """
    module: Any = require("PIL.Image", "reading a map's image", "ros")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the warnings are about size, which is checked here
            image = module.open(BytesIO(data), formats=_FORMATS)
            _check_size(*image.size)
            see_through = "transparency" in image.info
            if image.mode == "P" or see_through:
                image = image.convert("RGBA" if see_through else "RGB")
            elif image.mode == "1":
                image = image.convert("L")
            pixels = np.asarray(image)
    except SceneError:
        raise
    except module.UnidentifiedImageError:
        raise SceneError("is no image in PGM, PNG, BMP, JPEG or GIF") from None
    except Exception as error:  # decoders raise many types on a broken file
        raise SceneError(f"is not an image: {cut(str(error))}") from None
    if image.mode in _WIDE:
        return Image(pixels.astype(np.int32)[..., None], None, 65535)
    if pixels.dtype != np.uint8 or image.mode not in ("L", "LA", "RGB", "RGBA"):
        raise SceneError("must be grey or have red, green and blue", value=image.mode)
    if image.mode == "L":
        return Image(pixels[..., None], None, 255)
    if image.mode == "RGB":
        return Image(pixels, None, 255)
    return Image(pixels[..., :-1], pixels[..., -1], 255)


def _check_size(columns: int, rows: int) -> None:
    if columns * rows > MAX_CELLS:
        raise SceneError(f"has more than {MAX_CELLS} cells")


def summed(image: Image, *, with_opacity: bool) -> tuple[NDArray[np.int32], int]:
    """Return the sum of each cell's levels, as integers, and the largest possible sum.

    Grey counts as three equal colours; opacity is a fourth level if it is asked for and there.
    """
    weight = 3 // image.colours.shape[2]
    total = image.colours.sum(axis=2, dtype=np.int32) * np.int32(weight)
    if not with_opacity or image.alpha is None:
        return total, 3 * image.top
    return total + image.alpha, 4 * image.top
