"""A result as text for people: the verdict in one line, and a small table for notebooks."""

from __future__ import annotations

import html
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from planar_planner.errors import cut, one_line, shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class _Answer(Protocol):
    """What the texts take from a result."""

    @property
    def scene(self) -> str: ...
    @property
    def verdict(self) -> str: ...
    @property
    def reason(self) -> str: ...
    @property
    def path(self) -> NDArray[np.float64]: ...
    @property
    def path_length(self) -> float: ...
    @property
    def least_clearance(self) -> float: ...


_VERDICTS = {"path": "path found", "no_path": "no path, proven", "undecided": "undecided"}


def result_line(result: _Answer) -> str:
    """Return class, scene, figures and reason in one short line."""
    figures = "".join(f"{name} {value}, " for name, value in _figures(result).items())
    return f"<{type(result).__name__} {shown(result.scene)}: {figures}{one_line(result.reason)}>"


def result_html(result: _Answer) -> str:
    """Return a table of the same as HTML; names from files cannot end it or add to it."""
    rows = {"scene": result.scene, "verdict": _VERDICTS[result.verdict], "by": result.reason}
    lines = "".join(
        f"<tr><th style='text-align:left'>{name}</th>"
        f"<td style='text-align:left'>{html.escape(one_line(cut(value)))}</td></tr>"
        for name, value in (rows | _figures(result)).items()
    )
    return f"<table>{lines}</table>"


def _figures(result: _Answer) -> dict[str, str]:
    if result.verdict != "path":
        return {}
    return {
        "length": f"{result.path_length:.6g}",
        "waypoints": str(len(result.path)),
        "least clearance": f"{result.least_clearance:.3g}",
    }


def headline(result: _Answer, paint: Callable[[str], str] = str) -> str:
    """Return the verdict in one line; `paint` may colour its words."""
    reason = one_line(f" ({result.reason})") if result.reason else ""
    return f"{one_line(result.scene)}: {paint(_VERDICTS[result.verdict])}{reason}"
