"""The target of ``--json``: a file, or standard output for JSON only. Light to import."""

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
    """The target of a command's answer as JSON; `json_output` makes it.

    Attributes
    ----------
    to_stdout : bool
        Whether standard output receives the JSON; then it receives no text.
    file : Path or None
        File to write.
    """

    to_stdout: bool
    file: Path | None

    def write(self, content: dict[str, Any]) -> None:
        """Write the answer, an object with the members ``format`` and ``version``, if requested.

        Raises
        ------
        OutputError
            If writing fails.
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
    """Return the target that the value of ``--json`` names, after a check that it can be written.

    Raises
    ------
    OutputError
        If standard output is closed or the file cannot be written.
    """
    target = STDOUT if target == "/dev/stdout" else target
    if target == STDOUT and sys.stdout is None:
        raise OutputError("cannot write standard output: it is closed")
    if target in (None, STDOUT):
        return JsonOutput(target == STDOUT, None)
    file = Path(str(target))
    check_writable(file)
    return JsonOutput(False, file)
