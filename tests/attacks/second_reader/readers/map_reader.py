"""Maps a second time, as Nav2's map server judges cells, in both of its generations.

Up to 2024 (``map_io.cpp`` of the Humble, Iron and Jazzy branches): a cell's shade is the mean of
its colours, in mode trinary of its colours and its opacity if the image has an alpha channel;
occupied if above ``occupied_thresh``, free if below ``free_thresh``, else unknown. Since 2025: the
shade is the grey value alone, thresholds belong to occupied and free, and cells that are not opaque
are unknown in trinary and scale. Where the two differ, a note has to say which was followed.
"""

from __future__ import annotations

import io
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ..model import Drawing, Raster, Reading

Shades = NDArray[np.float64]
Cells = NDArray[np.bool_]

DUE = r"alpha|transparen|opaque|threshold|grey|gray|Nav2|map server"


def read(drawing: Drawing) -> Sequence[Reading]:
    """Return the cells that are obstacles, by the older and the newer server."""
    data = drawing.files[str(drawing.hints["image"])]
    colours, alpha = _channels(data)
    older = _occupied(drawing, colours, alpha, newer=False)
    newer = _occupied(drawing, colours, alpha, newer=True)
    if np.array_equal(older, newer):
        return [Reading("Nav2", _raster(drawing, older))]
    return [
        Reading("Nav2 to 2024", _raster(drawing, older), DUE),
        Reading("Nav2 since 2025", _raster(drawing, newer), DUE),
    ]


def _channels(data: bytes) -> tuple[Shades, Shades | None]:
    """Return the colours, shape (rows, columns, n), and the opacity, all from 0 to 1."""
    with Image.open(io.BytesIO(data)) as opened:
        opened.load()
        image: Image.Image = opened
        if image.mode.startswith("I"):
            wide = np.asarray(image).astype(float)
            return (wide / 65535.0)[..., None], None
        if image.mode == "P" or "transparency" in image.info:
            image = image.convert("RGBA" if "transparency" in image.info else "RGB")
        elif image.mode == "1":
            image = image.convert("L")
        values = np.asarray(image).astype(float) / 255.0
    if values.ndim == 2:
        return values[..., None], None
    if values.shape[2] in (2, 4):
        return values[..., :-1], values[..., -1]
    return values, None


def _occupied(drawing: Drawing, colours: Shades, alpha: Shades | None, *, newer: bool) -> Cells:
    hints = drawing.hints
    unknown_too = bool(drawing.options["unknown"])
    mode, occupied, free = hints["mode"], hints["occupied"], hints["free"]
    if colours.shape[2] == 1:
        colours = np.repeat(colours, 3, axis=2)
    shade = colours @ np.array([0.299, 0.587, 0.114]) if newer else colours.mean(axis=2)
    if mode == "raw":
        value = np.rint(shade * 255)
        known = value <= 100
        walls = known & (value >= 100 * occupied)
        between = known & ~walls & (value > 100 * free)
        return walls | (unknown_too & (between | ~known))
    if alpha is not None and mode == "trinary" and not newer:
        shade = np.concatenate([colours, alpha[..., None]], axis=2).mean(axis=2)
    share = np.round(shade if hints["negate"] else 1 - shade, 9)
    walls = share >= occupied if newer else share > occupied
    unfree = share > free if newer else share >= free
    clear = np.zeros_like(walls) if alpha is None else alpha < 1
    if mode == "trinary" and not newer:
        clear = np.zeros_like(walls)
    result = walls & ~clear
    return result | (unfree | clear) if unknown_too else result


def _raster(drawing: Drawing, cells: Cells) -> Raster:
    resolution = float(drawing.hints["resolution"])
    x0, y0, yaw = drawing.hints["origin"]
    rows, columns = cells.shape
    u, v = np.meshgrid(
        (np.arange(columns) + 0.5) * resolution, (rows - np.arange(rows) - 0.5) * resolution
    )
    x, y = x0 + np.cos(yaw) * u - np.sin(yaw) * v, y0 + np.sin(yaw) * u + np.cos(yaw) * v
    return Raster(cells, x, y, resolution, 0.0)
