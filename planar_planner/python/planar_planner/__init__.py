"""Complete motion planning for polygonal robots that translate and rotate in the plane.

>>> from planar_planner import load_scene, solve
>>> result = solve(load_scene("gear"))
>>> result.verdict
'path'
"""

from __future__ import annotations

TYPE_CHECKING = False  # as typing says: the command line starts without importing typing

if TYPE_CHECKING:
    from typing import Any

    from planar_planner.checker.verify import Verification, verify_certificate
    from planar_planner.errors import (
        CertificateError,
        CertificateRejected,
        OptionsError,
        OutputError,
        PlannerError,
        SceneError,
        VerificationTimeoutError,
    )
    from planar_planner.explain.cells import Cells, cells_on_path, theta_slice
    from planar_planner.explain.thinnest_place import Bottleneck
    from planar_planner.formats.parts import ImportOptions
    from planar_planner.load import load_scene
    from planar_planner.margins.find import margin
    from planar_planner.margins.result import Margin, NarrowPlace
    from planar_planner.margins.surroundings import NearestPoints
    from planar_planner.planning.engine import Listener
    from planar_planner.planning.options import Options
    from planar_planner.planning.outcome import DecidedBy, StopReason
    from planar_planner.planning.planner import Planner, solve
    from planar_planner.planning.result import (
        NoPath,
        PathFound,
        Result,
        Seconds,
        Statistics,
        Undecided,
    )
    from planar_planner.scene.goal_forms import Escape, GoalRegion
    from planar_planner.scene.import_report import ImportReport
    from planar_planner.scene.model import Scene

    __version__: str

_HOMES = {
    "Bottleneck": "explain.thinnest_place",
    "Cells": "explain.cells",
    "CertificateError": "errors",
    "CertificateRejected": "errors",
    "VerificationTimeoutError": "errors",
    "DecidedBy": "planning.outcome",
    "Escape": "scene.goal_forms",
    "GoalRegion": "scene.goal_forms",
    "ImportOptions": "formats.parts",
    "ImportReport": "scene.import_report",
    "Listener": "planning.engine",
    "Margin": "margins.result",
    "NarrowPlace": "margins.result",
    "NearestPoints": "margins.surroundings",
    "NoPath": "planning.result",
    "Options": "planning.options",
    "OptionsError": "errors",
    "OutputError": "errors",
    "PathFound": "planning.result",
    "Planner": "planning.planner",
    "PlannerError": "errors",
    "Result": "planning.result",
    "Scene": "scene.model",
    "SceneError": "errors",
    "Seconds": "planning.result",
    "Statistics": "planning.result",
    "StopReason": "planning.outcome",
    "Undecided": "planning.result",
    "Verification": "checker.verify",
    "cells_on_path": "explain.cells",
    "load_scene": "load",
    "margin": "margins.find",
    "solve": "planning.planner",
    "theta_slice": "explain.cells",
    "verify_certificate": "checker.verify",
}

__all__ = [
    "Bottleneck",
    "Cells",
    "CertificateError",
    "CertificateRejected",
    "DecidedBy",
    "Escape",
    "GoalRegion",
    "ImportOptions",
    "ImportReport",
    "Listener",
    "Margin",
    "NarrowPlace",
    "NearestPoints",
    "NoPath",
    "Options",
    "OptionsError",
    "OutputError",
    "PathFound",
    "Planner",
    "PlannerError",
    "Result",
    "Scene",
    "SceneError",
    "Seconds",
    "Statistics",
    "StopReason",
    "Undecided",
    "Verification",
    "VerificationTimeoutError",
    "cells_on_path",
    "load_scene",
    "margin",
    "solve",
    "theta_slice",
    "verify_certificate",
]


def __getattr__(name: str) -> Any:
    """Import a public name on first use, so that the command line starts without numpy."""
    if name == "__version__":
        from planar_planner.version import package_version

        globals()[name] = package_version()
        return globals()[name]
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import importlib

    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
