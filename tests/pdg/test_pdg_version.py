"""The version is that of the distribution, and other unknown names are errors."""

from __future__ import annotations

from importlib.metadata import version

import pytest

import pdg


def test_the_version_is_the_distribution_s() -> None:
    assert pdg.__version__ == version("planar-planner")


def test_other_names_are_errors() -> None:
    with pytest.raises(AttributeError, match="module 'pdg' has no attribute 'no_such_name'"):
        _ = pdg.no_such_name
