"""Colours, sizes and files of all pictures.

The module uses figure and canvas objects and never pyplot, so it needs neither global state nor a
display. The colours are those of Okabe and Ito, distinguishable with any common colour blindness.
The start is blue and the goal vermilion, and drawings of the robot fade from one to the other.
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from planar_planner.planning.path_samples import Floats

INK = "#222222"
OBSTACLE = "#666666"  # a lighter grey is MIDWAY to the colour-blind
OUTSIDE = "#E9E9E9"  # where the body may not go, behind the workspace's outline
START = "#0072B2"  # Okabe-Ito blue
GOAL = "#D55E00"  # Okabe-Ito vermilion
END_COLOURS = {"start": START, "goal": GOAL}
MIDWAY = "#CC79A7"  # Okabe-Ito reddish purple: the robot half way
BOUNDS = "#009E73"  # Okabe-Ito bluish green
TRACE = "#000000"
OVERLAP = "#F0E442"  # Okabe-Ito yellow, hatched: where body and obstacles overlap

PADDING = 0.12  # inches round drawing, title and legend
DPI = 150
_SALT = "planar-planner"  # salt of the ids in an SVG, which would be random without it


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure with an Agg canvas; sizes in inches."""
    layout = ConstrainedLayoutEngine(w_pad=PADDING, h_pad=PADDING)
    figure = Figure(figsize=(width, height), layout=layout)
    FigureCanvasAgg(figure)
    return figure


def save_picture(
    figure: Figure, file: str | os.PathLike[str], suffix: str | None = None, dpi: float = DPI
) -> None:
    """Write a figure to exactly this file; the same figure gives the same bytes.

    Parameters
    ----------
    figure : Figure
        Figure to write.
    file : path
        File to write; no suffix is added to its name.
    suffix : str, optional
        Format, ``.png``, ``.svg`` or ``.pdf``, whatever the file's name: a link's target or a
        device has no suffix, and matplotlib would add one. The default is the file's own suffix.
    dpi : float, optional
        Dots per inch of a PNG, and of pixels in a vector format.
    """
    kind = (suffix or Path(file).suffix).lower().removeprefix(".")
    dated = {"png": {"Software": None}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}
    with mpl.rc_context({"svg.hashsalt": _SALT}), warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing")  # a name may be in any script
        figure.savefig(file, dpi=dpi, format=kind, metadata=dated[kind])


def rgba(colour: str, alpha: float) -> tuple[float, float, float, float]:
    """Return a colour ``#rrggbb`` with an opacity, as matplotlib takes it."""
    return (*_rgb(colour), alpha)


def fade(count: int) -> Floats:
    """Return colours (count, 3) from START by MIDWAY to GOAL."""
    stops = np.array([_rgb(START), _rgb(MIDWAY), _rgb(GOAL)])
    where = np.linspace(0.0, 2.0, count)
    return np.column_stack([np.interp(where, [0.0, 1.0, 2.0], stops[:, k]) for k in range(3)])


def _rgb(colour: str) -> tuple[float, float, float]:
    r, g, b = (int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    return r, g, b
