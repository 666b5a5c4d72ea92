"""Complete motion planning for polygonal robots that translate and rotate in the plane.

>>> from planar_planner import load_scene, solve
>>> result = solve(load_scene("gear"))
>>> result.verdict
'path'
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planar_planner.bottleneck import Bottleneck
    from planar_planner.cells import Cells, cells_of, cells_on_path, theta_slice
    from planar_planner.certificate_form import CertificateError
    from planar_planner.errors import OptionsError, SceneError
    from planar_planner.margins.find import margin
    from planar_planner.margins.result import Margin
    from planar_planner.options import Options
    from planar_planner.planner import Planner, solve
    from planar_planner.result import NoPath, PathFound, Result, Undecided
    from planar_planner.scene import Scene, load_scene
    from planar_planner.verify import Rejected, verify_certificate

    __version__: str

_HOMES = {
    "Bottleneck": "bottleneck",
    "Cells": "cells",
    "CertificateError": "certificate_form",
    "Margin": "margins.result",
    "NoPath": "result",
    "Options": "options",
    "OptionsError": "errors",
    "PathFound": "result",
    "Planner": "planner",
    "Rejected": "verify",
    "Result": "result",
    "Scene": "scene",
    "SceneError": "errors",
    "Undecided": "result",
    "cells_of": "cells",
    "cells_on_path": "cells",
    "load_scene": "scene",
    "margin": "margins.find",
    "solve": "planner",
    "theta_slice": "cells",
    "verify_certificate": "verify",
}

__all__ = [
    "Bottleneck",
    "Cells",
    "CertificateError",
    "Margin",
    "NoPath",
    "Options",
    "OptionsError",
    "PathFound",
    "Planner",
    "Rejected",
    "Result",
    "Scene",
    "SceneError",
    "Undecided",
    "cells_of",
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
        from importlib.metadata import version

        globals()[name] = version("planar-planner")
        return globals()[name]
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
