"""Generated occupancy maps: images of every kind that Pillow writes, in every mode of Nav2."""

from __future__ import annotations

import io
import random
from collections.abc import Callable, Iterator

import numpy as np
from PIL import Image

from ..model import Drawing

Maker = Callable[[random.Random], tuple[str, bytes]]
MAKERS: dict[str, Maker] = {}
ROWS, COLUMNS = 9, 12


def feature(make: Maker) -> Maker:
    """Register a maker of an image under its name."""
    MAKERS[make.__name__] = make
    return make


def drawings(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield maps, each feature in turn, with random modes, thresholds and places."""
    names = [name for name in MAKERS if only in name]
    for k in range(count):
        name = names[k % len(names)]
        image, data = MAKERS[name](rng)
        text, hints = _yaml(name, image, rng)
        files = {"map.yaml": text.encode(), image: data}
        unknown = rng.random() < 0.5
        yield Drawing(name, "map.yaml", files, {"unknown": unknown}, "", "", hints)


def _yaml(name: str, image: str, rng: random.Random) -> tuple[str, dict[str, object]]:
    mode = rng.choice([None, "trinary", "scale", "raw"])
    if "threshold" in name:
        mode = rng.choice([None, "trinary", "scale"])
    occupied, free = (
        (0.6, 0.2) if "threshold" in name else rng.choice([(0.65, 0.25), (0.65, 0.196)])
    )
    negate = rng.choice([0, 0, 1]) if mode != "raw" else 0
    yaw = rng.choice([0, 0, 0.5, -2.0])
    resolution = rng.choice(["0.05", "0.1", "1", "5.0e-2"])
    origin: tuple[object, object] = rng.choice([(0, 0), (-10.5, 3.25), (2, "-1.5e+0")])
    if name == "yaml_numbers":
        resolution, origin = rng.choice(["5e-2", "1e-05", "1E2"]), ("-1e1", "8e-17")
    lines = [
        f"image: {image}",
        f"resolution: {resolution}",
        f"origin: [{origin[0]}, {origin[1]}, {yaw}]",
        f"negate: {negate}",
        f"occupied_thresh: {occupied}",
        f"free_thresh: {free}",
    ]
    if mode is not None:
        lines.append(f"mode: {mode}")
    hints: dict[str, object] = {
        "mode": mode or "trinary",
        "occupied": occupied,
        "free": free,
        "negate": bool(negate),
        "resolution": float(resolution),
        "origin": (float(origin[0]), float(origin[1]), float(yaw)),
        "image": image,
    }
    return "\n".join(lines) + "\n", hints


def _grey(rng: random.Random) -> np.ndarray:
    levels = np.array([0, 0, 0, 254, 255, 255, 205, 128, 60, 100])
    state = np.random.default_rng(rng.randrange(2**32))
    return levels[state.integers(0, len(levels), (ROWS, COLUMNS))].astype(np.uint8)


def _alpha(rng: random.Random) -> np.ndarray:
    state = np.random.default_rng(rng.randrange(2**32))
    return np.array([0, 255, 255, 128])[state.integers(0, 4, (ROWS, COLUMNS))].astype(np.uint8)


def _saved(image: Image.Image, name: str, kind: str, **more: object) -> tuple[str, bytes]:
    stream = io.BytesIO()
    image.save(stream, kind, **more)
    return name, stream.getvalue()


@feature
def pgm_binary(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)), "m.pgm", "PPM")


@feature
def pgm_text(rng: random.Random) -> tuple[str, bytes]:
    values = _grey(rng)
    body = "\n".join(" ".join(map(str, row)) for row in values)
    return "m.pgm", f"P2\n# a comment\n{COLUMNS} {ROWS}\n255\n{body}\n".encode()


@feature
def pgm_maxval(rng: random.Random) -> tuple[str, bytes]:
    """Values up to 100 or 1023 instead of 255."""
    most = rng.choice([100, 15, 1023])
    values = np.rint(_grey(rng).astype(float) * most / 255).astype(int)
    if rng.random() < 0.5:
        body = "\n".join(" ".join(map(str, row)) for row in values)
        return "m.pgm", f"P2 {COLUMNS} {ROWS} {most}\n{body}\n".encode()
    data = values.astype(">u2" if most > 255 else np.uint8).tobytes()
    return "m.pgm", f"P5\n{COLUMNS} {ROWS}\n{most}\n".encode() + data


@feature
def pgm_comment(rng: random.Random) -> tuple[str, bytes]:
    head = f"P5\n# CREATOR: map_saver 0.050 m/pix\n{COLUMNS} {ROWS}\n255\n"
    return "m.pgm", head.encode() + _grey(rng).tobytes()


@feature
def pbm(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)).convert("1", dither=0), "m.pbm", "PPM")


@feature
def png_grey(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)), "m.png", "PNG")


@feature
def png_threshold(rng: random.Random) -> tuple[str, bytes]:
    """Cells whose occupancy is a threshold: 102 is 0.6, 204 is 0.2."""
    values = _grey(rng)
    values[::2, ::3] = 102
    values[1::2, ::3] = 204
    return _saved(Image.fromarray(values), "m.png", "PNG")


@feature
def png_grey_alpha(rng: random.Random) -> tuple[str, bytes]:
    bands = Image.fromarray(_grey(rng)), Image.fromarray(_alpha(rng))
    return _saved(Image.merge("LA", bands), "m.png", "PNG")


@feature
def png_opaque_alpha(rng: random.Random) -> tuple[str, bytes]:
    """An alpha channel that is opaque everywhere, as image editors add it."""
    opaque = Image.new("L", (COLUMNS, ROWS), 255)
    grey = Image.fromarray(_grey(rng))
    if rng.random() < 0.5:
        return _saved(Image.merge("LA", (grey, opaque)), "m.png", "PNG")
    return _saved(Image.merge("RGBA", (grey, grey, grey, opaque)), "m.png", "PNG")


@feature
def png_rgb(rng: random.Random) -> tuple[str, bytes]:
    grey = Image.fromarray(_grey(rng))
    return _saved(Image.merge("RGB", (grey, grey, grey)), "m.png", "PNG")


@feature
def png_colours(rng: random.Random) -> tuple[str, bytes]:
    bands = [Image.fromarray(_grey(rng)) for _ in range(3)]
    return _saved(Image.merge("RGB", bands), "m.png", "PNG")


@feature
def png_rgba(rng: random.Random) -> tuple[str, bytes]:
    grey = Image.fromarray(_grey(rng))
    return _saved(
        Image.merge("RGBA", (grey, grey, grey, Image.fromarray(_alpha(rng)))), "m.png", "PNG"
    )


@feature
def png_palette(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)).convert("P"), "m.png", "PNG")


@feature
def png_palette_transparent(rng: random.Random) -> tuple[str, bytes]:
    image = Image.fromarray(_grey(rng)).convert("P")
    return _saved(image, "m.png", "PNG", transparency=rng.choice([0, 255]))


@feature
def png_one_bit(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)).convert("1", dither=0), "m.png", "PNG")


@feature
def png_16_bit(rng: random.Random) -> tuple[str, bytes]:
    values = _grey(rng).astype(np.uint16) * 257
    return _saved(Image.fromarray(values), "m.png", "PNG")


@feature
def png_grey_key(rng: random.Random) -> tuple[str, bytes]:
    """One grey value that is transparent (a tRNS chunk)."""
    return _saved(Image.fromarray(_grey(rng)), "m.png", "PNG", transparency=rng.choice([0, 255]))


@feature
def jpeg(rng: random.Random) -> tuple[str, bytes]:
    values = np.kron(_grey(rng) > 200, np.ones((8, 8))).astype(np.uint8) * 255
    return _saved(Image.fromarray(values), "m.jpg", "JPEG", quality=100, subsampling=0)


@feature
def bmp(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)), "m.bmp", "BMP")


@feature
def gif(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.fromarray(_grey(rng)), "m.gif", "GIF")


@feature
def yaml_numbers(rng: random.Random) -> tuple[str, bytes]:
    """Numbers as printf writes them, which YAML 1.1 takes for text and yaml-cpp for numbers."""
    return _saved(Image.fromarray(_grey(rng)), "m.png", "PNG")


@feature
def all_free(rng: random.Random) -> tuple[str, bytes]:
    return _saved(Image.new("L", (COLUMNS, ROWS), 127), "m.png", "PNG")
