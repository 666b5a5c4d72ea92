"""The version of the installed distribution, which `pyproject.toml` alone states."""

from __future__ import annotations

from importlib.metadata import version


def package_version() -> str:
    """Return the version of planar-planner."""
    return version("planar-planner")
