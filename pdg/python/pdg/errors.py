"""The errors that a caller of `pdg` can cause, all of them a `PdgError`."""

from __future__ import annotations

import reprlib


class PdgError(ValueError):
    """An argument that the library cannot compute with.

    Attributes
    ----------
    problem : str
        What is wrong.
    name : str
        The argument, as the function's signature calls it.
    index : int or None
        Row (vertex, or component of a configuration) that is wrong, where there is one.
    value : object
        The offending value, or None.
    """

    def __init__(
        self, problem: str, name: str = "", index: int | None = None, value: object = None
    ) -> None:
        super().__init__(problem, name, index, value)
        self.problem = problem
        self.name = name
        self.index = index
        self.value = value

    def __str__(self) -> str:
        place = self.name if self.index is None else f"{self.name}[{self.index}]"
        got = "" if self.value is None else f" (got {reprlib.repr(self.value)})"
        return f"{place}: {self.problem}{got}" if place else f"{self.problem}{got}"


class BodyError(PdgError):
    """A body that is not made of valid polygons with area."""


class PlacementError(PdgError):
    """A configuration that places a body outside the range of exact arithmetic."""
