"""What generators, second readers and the judge hand to each other. Plain structs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

Region = Any
"""A shapely geometry: shapely ships no types."""


@dataclass(frozen=True)
class Drawing:
    """One generated input.

    Attributes
    ----------
    feature : str
        What the drawing is about; results are counted by it.
    name : str
        The file among `files` that is imported.
    files : mapping of str to bytes
        All files, by their names in one folder.
    options : mapping
        Options of the import: ``unknown``, ``roles``, ``tolerance`` and so on.
    must_say : str
        Regular expression that a note must match if the file is read; empty if none must.
    told : str
        Regular expression of notes that tell of a difference; empty for the judge's own.
    hints : mapping
        What the second reader of the format needs to know beyond the files.
    """

    feature: str
    name: str
    files: Mapping[str, bytes]
    options: Mapping[str, Any] = field(default_factory=dict)
    must_say: str = ""
    told: str = ""
    hints: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Exact:
    """A region as polygons; boundaries may be off by `slack`, a length in the file's unit."""

    region: Region
    slack: float


@dataclass(frozen=True)
class Raster:
    """A region as filled cells of a grid.

    Attributes
    ----------
    filled : NDArray of bool, shape (rows, columns)
    x, y : NDArray of float64, shape (rows, columns)
        Centres of the cells in the scene's frame.
    cell : float
        Width of a cell in the scene's unit.
    slack : float
        Farthest that a boundary may be off, in the scene's unit, beyond one cell.
    """

    filled: NDArray[np.bool_]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    cell: float
    slack: float


@dataclass(frozen=True)
class Reading:
    """One region that the file may be said to mean.

    Attributes
    ----------
    title : str
        For people.
    truth : Exact or Raster
    must_say : str
        Regular expression that a note must match for this reading to be right.
    """

    title: str
    truth: Exact | Raster
    must_say: str = ""


class Verdict(Enum):
    """How the importer did."""

    AGREED = "agreed"
    UNTOLD = "untold"  # the region is right, but a note that is due is missing
    REFUSED = "refused"  # a SceneError
    TOLD = "told"  # the region differs, and a note says that something was left out
    SILENT = "SILENT"  # the region differs without a word: the fault
    CRASHED = "crashed"  # another exception, or a message with a raw Python value
    SKIPPED = "skipped"  # the second reader cannot judge it


@dataclass(frozen=True)
class Outcome:
    """The judgement on one drawing."""

    drawing: Drawing
    verdict: Verdict
    detail: str
    notes: Sequence[str] = ()
    seconds: float = 0.0
