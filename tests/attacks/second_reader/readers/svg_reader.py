"""SVG a second time: painted by resvg, and by Chromium where there is one.

Chromium is the authority; resvg does not know all of CSS. Without Chromium, drawings that are
marked as beyond resvg are skipped. All painted cells are obstacles: the drawings hold nothing else.
"""

from __future__ import annotations

import base64
import io
import re
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..judge import Reader, UnreadableError
from ..model import Drawing, Raster, Reading

ZOOM = 4
"""Pixels a CSS pixel."""
HALF = 127
FLATTENED = 0.06
"""The importer's flattening tolerance of 0.05 and the painter's own, in user units."""

_PAINT = """
const [svgs, zoom, done] = arguments;
(async () => {
  const out = [];
  for (const svg of svgs) {
    try {
      const image = new Image();
      image.src = "data:image/svg+xml;base64," + svg;
      await image.decode();
      const w = Math.round(image.naturalWidth * zoom), h = Math.round(image.naturalHeight * zoom);
      const canvas = document.createElement("canvas");
      canvas.width = w; canvas.height = h;
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0, w, h);
      const rgba = context.getImageData(0, 0, w, h).data;
      const alpha = new Uint8Array(rgba.length / 4);
      for (let j = 0; j < alpha.length; j++) alpha[j] = rgba[4 * j + 3];
      let text = "";
      for (let j = 0; j < alpha.length; j += 32768)
        text += String.fromCharCode(...alpha.subarray(j, j + 32768));
      out.push([w, h, btoa(text)]);
    } catch (error) { out.push([0, 0, String(error)]); }
  }
  done(out);
})();
"""

Alpha = NDArray[np.uint8]


@contextmanager
def opened(*, with_browser: bool = True) -> Iterator[Reader]:
    """Yield the second reader, with a browser behind it if there is one."""
    chrome = _started() if with_browser else None
    try:
        yield SvgReader(chrome).read
    finally:
        if chrome is not None:
            chrome.quit()


class SvgReader:
    """Paints drawings; `disagreements` are the features that the two painters see differently."""

    def __init__(self, chrome: Any) -> None:
        self._chrome = chrome
        self.disagreements: list[str] = []

    def read(self, drawing: Drawing) -> Sequence[Reading]:
        """Return what the drawing shows, in the frames that an importer may choose."""
        text = drawing.files[drawing.name].decode()
        found = self._seen(text, drawing)
        titles: list[tuple[str, Alpha]] = [("as painted", found)]
        paint = drawing.hints.get("paint")
        said = ""
        if paint == "outline":
            inside = re.sub(r"fill(:|=\")none", r"fill\1black", text)
            inside = re.sub(r"stroke(:|=\")(#000|black)", r"stroke\1none", inside)
            titles.append(("inside of outlines", self._seen(inside, drawing)))
        elif paint == "stroke":
            plain = text.replace('stroke="black"', 'stroke="none"')
            titles.append(("without strokes", self._seen(plain, drawing)))
            said = "stroke"
        readings = []
        for title, alpha in titles:
            due = said if title == "without strokes" else ""
            readings += [
                Reading(f"{title}, {frame}", raster, due or note)
                for frame, raster, note in _frames(alpha, drawing)
            ]
        if drawing.hints.get("told"):
            return [Reading(r.title, r.truth, r.must_say or "text|image|foreign") for r in readings]
        return readings

    def _seen(self, text: str, drawing: Drawing) -> Alpha:
        small = _by_resvg(text)
        if self._chrome is None:
            if drawing.hints.get("browser") or small is None:
                raise UnreadableError("resvg does not know this feature, and there is no Chromium")
            return small
        large = self._by_chromium(text)
        if large is None:
            raise UnreadableError("Chromium refuses the file")
        if small is None or small.shape != large.shape or _differ(small, large):
            self.disagreements.append(drawing.feature)
        return large

    def _by_chromium(self, text: str) -> Alpha | None:
        assert self._chrome is not None
        data = base64.b64encode(text.encode()).decode()
        ((width, height, answer),) = self._chrome.execute_async_script(_PAINT, [data], ZOOM)
        if width == 0:
            return None
        return np.frombuffer(base64.b64decode(answer), np.uint8).reshape(height, width)


def _differ(a: Alpha, b: Alpha) -> bool:
    """Return whether two paintings differ by more than the softness of their borders."""
    other = (a > HALF) != (b > HALF)
    core = other[2:, 2:] & other[2:, :-2] & other[:-2, 2:] & other[:-2, :-2]
    return bool((core & other[1:-1, 1:-1]).any())


def _by_resvg(text: str) -> Alpha | None:
    import resvg_py
    from PIL import Image

    try:
        data = resvg_py.svg_to_bytes(
            svg_string=text, zoom=ZOOM, dpi=96, languages=["en"], skip_system_fonts=True
        )
    except ValueError:
        return None
    with Image.open(io.BytesIO(bytes(data))) as image:
        return np.asarray(image)[..., 3]


def browser() -> tuple[str, str] | None:
    """Return the paths of a browser and its driver, or None."""
    names = ("chromium", "chromium-browser", "google-chrome")
    program = next(filter(None, map(shutil.which, names)), None)
    driver = shutil.which("chromedriver")
    return (program, driver) if program and driver else None


def _started() -> Any:
    """Return a headless Chromium, or None."""
    found = browser()
    if found is None:
        return None
    program, driver = found
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        return None
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run"):
        options.add_argument(flag)
    chrome = webdriver.Chrome(options=options, service=Service(driver))
    chrome.set_script_timeout(60)
    chrome.get("about:blank")
    return chrome


def _frames(alpha: Alpha, drawing: Drawing) -> list[tuple[str, Raster, str]]:
    """Return the raster in user units, and in pixels and millimetres where units differ."""
    hints = drawing.hints
    x0, y0, width, _ = hints.get("viewbox", (0.0, 0.0, hints["canvas"], hints["canvas"]))
    scale = width / hints["canvas"]
    unit = hints.get("unit", 1.0)
    frames = [("user units", _raster(alpha, scale, x0, y0, unit), "")]
    said = r"unit|viewBox|width|mm|px"
    if "stretched" in hints:
        x0, y0, w, h = hints["stretched"]
        user = _raster(alpha, w / hints["canvas"], x0, y0, 1.0)
        y = user.y * (h / w)
        frames = [
            ("user units", Raster(user.filled, user.x, y, user.cell, user.slack), said),
            ("pixels", _raster(alpha, 1.0, 0, 0, 1.0), ""),
        ]
    elif "viewbox" in hints or "mm" in hints:
        frames.append(("pixels", _raster(alpha, 1.0, 0, 0, max(unit / scale, 1.0)), said))
        mm = 25.4 / 96
        frames.append(("millimetres", _raster(alpha, mm, 0, 0, max(unit / scale * mm, 0.1)), said))
    return frames


def _raster(alpha: Alpha, scale: float, x0: float, y0: float, unit: float) -> Raster:
    rows, columns = alpha.shape
    cell = scale / ZOOM
    x, y = np.meshgrid(
        x0 + (np.arange(columns) + 0.5) * cell, -(y0 + (np.arange(rows) + 0.5) * cell)
    )
    return Raster(alpha > HALF, x, y, cell, cell + FLATTENED * unit)
