"""What ``--json`` asks for: a file, or nothing but JSON on standard output. Light to import."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from planar_planner.errors import OutputError
from planar_planner.output_files import check_writable, emit, written_aside

STDOUT = "-"


@dataclass(frozen=True)
class JsonOutput:
    """Where to write a command's answer as JSON; made by `json_output`.

    Attributes
    ----------
    to_stdout : bool
        Standard output is for the JSON alone: print no text.
    file : Path or None
        File to write.
    """

    to_stdout: bool
    file: Path | None

    def write(self, content: dict[str, Any]) -> None:
        """Write the answer, an object with the members ``format`` and ``version``, if asked for.

        Raises
        ------
        OutputError
            If that fails.
        """
        if not (self.to_stdout or self.file):
            return
        text = json.dumps(content, indent=1, allow_nan=False)
        if self.to_stdout:
            emit(text)
        if self.file is not None:
            with written_aside(self.file) as aside:
                aside.write_text(text + "\n", encoding="utf-8")


def json_output(target: str | None) -> JsonOutput:
    """Return what the value of ``--json`` asks for, once it is known to be possible.

    Raises
    ------
    OutputError
        If standard output is closed or the file cannot be written.
    """
    if target == STDOUT and sys.stdout is None:
        raise OutputError("cannot write standard output: it is closed")
    if target in (None, STDOUT):
        return JsonOutput(target == STDOUT, None)
    file = Path(str(target))
    check_writable(file)
    return JsonOutput(False, file)
