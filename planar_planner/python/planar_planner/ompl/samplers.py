"""The names of OMPL's sampling planners that the comparison knows. Needs no OMPL."""

from __future__ import annotations

import importlib
from collections.abc import Iterable
from types import ModuleType

from planar_planner.errors import OptionsError, shown
from planar_planner.scene.fields import close_matches

INSTALL_HINT = "OMPL is not installed: pip install 'planar-planner[ompl]'"

SAMPLERS = (
    "RRTConnect",
    "RRT",
    "PRM",
    "KPIECE1",
    "BKPIECE1",
    "LBKPIECE1",
    "BITstar",
    "RRTstar",
    "InformedRRTstar",
    "SORRTstar",
    "AORRTC",
    "PRMstar",
    "FMT",
    "BFMT",
)
"""Geometric planners in OMPL's Python wheel, which does not bind EST, SBL, LazyPRM and AITstar."""

DEFAULT_SAMPLERS = ("RRTConnect", "PRM", "KPIECE1", "BITstar")


class MissingOmplError(ImportError):
    """OMPL is needed but not installed; the message is one line that says how to install it."""

    def __init__(self) -> None:
        super().__init__(INSTALL_HINT)


def import_ompl(module: str) -> ModuleType:
    """Import one of OMPL's modules, such as ``base``.

    Raises
    ------
    MissingOmplError
        If OMPL is not installed.
    """
    try:
        return importlib.import_module(f"ompl.{module}")
    except ModuleNotFoundError as error:
        if error.name is not None and error.name.split(".")[0] == "ompl":
            raise MissingOmplError from None
        raise


def check_samplers(names: Iterable[str]) -> tuple[str, ...]:
    """Return the names, each once and in order.

    Raises
    ------
    OptionsError
        If a name is unknown, with a likely spelling, or if there is no name.
    """
    known = {name.lower(): name for name in SAMPLERS}
    found: list[str] = []
    for name in names:
        if name.lower() not in known:
            hint = close_matches(name, SAMPLERS) or f"; known are {', '.join(SAMPLERS)}"
            raise OptionsError(f"unknown planner {shown(name)}{hint}")
        if known[name.lower()] not in found:
            found.append(known[name.lower()])
    if not found:
        raise OptionsError("at least one planner must be named")
    return tuple(found)
