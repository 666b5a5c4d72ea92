"""The roles that the layers, ids, classes and labels of a drawing state."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fnmatch import fnmatchcase

ROLES = (
    "robot",
    "obstacle",
    "workspace",
    "reference_bounds",
    "start",
    "goal",
    "origin",
    "ignore",
)

_KNOWN = (
    ("obstacle*", "obstacle"),
    ("workspace*", "workspace"),
    ("reference_bounds*", "reference_bounds"),
)
_WORDS = re.compile(r"(robot|start|goal|origin)s?(?![a-z])", re.IGNORECASE)
"""Roles of words, since other words begin like these: ``original``, ``startled``, ``robotics``."""


def role_of(names: Iterable[str], given: Iterable[tuple[str, str]]) -> str | None:
    """Return the role of the first name that a pattern fits; case does not matter.

    Parameters
    ----------
    names : iterable of str
        Names of an element, the closest first: its id, label and classes, then those of its groups.
    given : iterable of (pattern, role)
        The user's patterns, which come before the known ones; ``*`` stands for any text.
    """
    patterns = (*given, *_KNOWN)
    for name in names:
        for pattern, role in patterns:
            if fnmatchcase(name.lower(), pattern.lower()):
                return role
        word = _WORDS.match(name)
        if word:
            return word[1].lower()
    return None
