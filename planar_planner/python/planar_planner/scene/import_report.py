"""What the import of a file in another format has to say; every result of the scene carries it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class ImportReport:
    """What an importer did to the geometry of a file; empty for scene files and Python's objects.

    Attributes
    ----------
    notes : tuple of str
        What was read, dropped, rounded, guessed or chosen, one sentence each.
    holds_for : str
        The verdict that carries over to the curves of the file, ``path`` or ``no_path``; empty if
        both do.
    """

    notes: tuple[str, ...] = ()
    holds_for: str = ""

    def to_json(self) -> dict[str, Any]:
        """Return the members that the report has in the JSON object of every result."""
        return {"notes": list(self.notes), "holds_for": self.holds_for}


NOT_IMPORTED = ImportReport()
"""The report of scene files and of Python's objects."""
