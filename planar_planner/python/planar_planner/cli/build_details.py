"""The output of `planar-planner --version`: the facts that reproduce a bug report."""

from __future__ import annotations

import platform
import sys
from importlib.metadata import PackageNotFoundError, version

from planar_planner.version import package_version

_LIBRARIES = ("numpy", "shapely", "matplotlib", "rich")


def build_details() -> str:
    """Return the version in the first line, then facts about the build and the system."""
    lines = [f"planar-planner {package_version()}"]
    rows = {**_core(), **_surroundings()}
    width = max(map(len, rows))
    lines += [f"  {name:{width}}  {text}" for name, text in rows.items()]
    return "\n".join(lines)


def _core() -> dict[str, str]:
    try:
        from planar_planner._core import build_info
    except ImportError as error:
        return {"core": f"cannot be imported: {error}"}
    facts = build_info()
    flags = f" ({facts['flags']})" if facts["flags"] else ""
    return {
        "commit": facts["commit"] or "unknown: not built in a git checkout",
        "core": f"{facts['version']}, {facts['build_type']}{flags}",
        "compiler": facts["compiler"],
        "ABI": f"{facts['abi']}; nanobind {facts['nanobind']}",
    }


def _surroundings() -> dict[str, str]:
    return {
        "Python": f"{platform.python_implementation()} {platform.python_version()}",
        "platform": platform.platform(),
        "libraries": ", ".join(map(_library, _LIBRARIES)),
        "installed": str(sys.modules["planar_planner"].__path__[0]),
    }


def _library(name: str) -> str:
    try:
        return f"{name} {version(name)}"
    except PackageNotFoundError:
        return f"{name} missing"
