"""The formats: who draws and who reads. A format's libraries are imported when it is asked for."""

from __future__ import annotations

import importlib
import random
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any

from .judge import Reader, judged
from .model import Drawing, Outcome


@dataclass(frozen=True)
class Format:
    """Where a format's generator and second reader are.

    Attributes
    ----------
    drawer, drawings, makers : str
        Module, its generator, and its tables of makers by feature, separated by spaces.
    reader, read : str
        Module and its function.
    """

    drawer: str
    reader: str
    drawings: str = "drawings"
    makers: str = "MAKERS"
    read: str = "read"

    def features(self, only: str = "") -> list[str]:
        """Return the names of the features that hold a text."""
        module = _module(self.drawer)
        tables = [getattr(module, name) for name in self.makers.split()]
        return [name for table in tables for name in table if only in name]

    def generated(self, rng: random.Random, count: int, only: str) -> Iterator[Drawing]:
        """Yield drawings."""
        make: Callable[[random.Random, int, str], Iterator[Drawing]]
        make = getattr(_module(self.drawer), self.drawings)
        yield from make(rng, count, only)


FORMATS = {
    "svg": Format("drawings.svg_drawings", "readers.svg_reader"),
    "dxf": Format("drawings.dxf_drawings", "readers.dxf_reader"),
    "map": Format("drawings.map_drawings", "readers.map_reader"),
    "mesh": Format("drawings.mesh_drawings", "readers.mesh_reader"),
    "wkt": Format(
        "drawings.gis_drawings", "readers.gis_reader", "drawings_wkt", "SHARED WKT", "read_wkt"
    ),
    "geojson": Format(
        "drawings.gis_drawings",
        "readers.gis_reader",
        "drawings_geojson",
        "SHARED GEOJSON",
        "read_geojson",
    ),
    **{
        name: Format(
            "drawings.field_drawings",
            "readers.field_reader",
            f"drawings_{name}",
            name.upper(),
            f"read_{name}",
        )
        for name in ("yap", "tpcap", "discopygal", "dynobench", "octile")
    },
}


def outcomes(
    name: str, rng: random.Random, count: int, only: str = "", *, browser: bool = True
) -> Iterator[Outcome]:
    """Yield the judgement on each drawing of a format."""
    with _reader(name, browser=browser) as reader:
        for drawing in FORMATS[name].generated(rng, count, only):
            yield judged(drawing, reader)


def _reader(name: str, *, browser: bool) -> AbstractContextManager[Reader]:
    kind = FORMATS[name]
    module = _module(kind.reader)
    if name == "svg":
        opened: AbstractContextManager[Reader] = module.opened(with_browser=browser)
        return opened
    return nullcontext(getattr(module, kind.read))


def _module(name: str) -> Any:
    return importlib.import_module(f".{name}", __package__)
