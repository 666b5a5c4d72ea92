"""The refusal of Moving AI's scenario files, which says how to solve one of their problems.

After ``version 1``, each line is a problem: bucket, map, the map's width and height, column and row
of start and goal, and the length of a shortest path. Columns and rows begin at 0, rows at the
uppermost. The problems are of points on a grid, so a robot has to be chosen all the same.
"""

from __future__ import annotations

from pathlib import Path

from planar_planner.errors import SceneError, cut
from planar_planner.formats.parts import ImportOptions, Notes, Parts
from planar_planner.formats.reading import text_of, whole

_FIELDS = 9
_MOST = 2**31 - 1


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Refuse a scenario file.

    Raises
    ------
    SceneError
        Always. The message names the map, the number of problems, and the options that state the
        first one in the map's frame.
    """
    del path, options, notes
    lines = [line for line in text_of(data).splitlines() if line.strip()]
    problems = lines[1:] if lines and lines[0].split()[0].lower() == "version" else lines
    example = _example(problems[0]) if problems else ""
    raise SceneError(
        f"is a list of problems ({len(problems)}) for points on the grid of a map and is not read; "
        f"solve the map with --robot or --footprint and the ends of one problem{example}"
    )


def _example(line: str) -> str:
    """Return the map and the ends of a problem: the centres of cells, with y upwards."""
    words = line.split("\t") if "\t" in line else line.split()
    if len(words) != _FIELDS:
        raise SceneError(f"must have {_FIELDS} fields, and has {len(words)}", "first problem")
    height, *ends = (whole(word, "first problem", 0, _MOST) for word in words[3:8])
    x0, y0, x1, y1 = (value + 0.5 for value in ends)
    return (
        f": the first is on {cut(words[1])} from --start {x0},{height - y0},0 "
        f"to --goal {x1},{height - y1},0"
    )
