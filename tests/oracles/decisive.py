"""Grid steps at which the flood fill proves the expected verdict of a shipped scene.

Run as a script (``python tests/oracles/decisive.py [name ...]``) to prove them all, or some.
"""

import json
import sys
import time
from pathlib import Path
from typing import Any, Literal, TypedDict

FOLDER = Path(__file__).parents[2] / "scenarios"

QUICK: dict[str, float] = {  # a few seconds each at most: proved in every run of the tests
    "open": 0.2,
    "window": 0.1,
    "window-fixed": 0.1,
    "slide": 0.05,
    "slide-blocked": 0.05,
    "courtyard": 0.1,
    "fence": 0.1,
    "bug-trap": 0.1,
    "bug-trap-closed": 0.08,
    "slot": 0.04,
    "slot-jammed": 0.05,
    "piano": 0.035,
    "piano-jammed": 0.05,
    "snowflake": 0.03,
    "snowflake-jammed": 0.03,
    "maze-blocked": 0.1,
}
SLOW: dict[str, float] = {  # ten seconds to several minutes each
    "disc": 0.05,
    "disc-jammed": 0.05,
    "comb-jammed": 0.05,
    "comb": 0.03,
    "maze": 0.04,
    "gear-wide": 0.05,
    "gear-jammed": 0.03,
    "corner-too-long": 0.008,
    "field": 0.13,
}


class Listed(TypedDict):
    """What is used here of a scene's entry in the manifest."""

    name: str
    file: str
    expected: Literal["path", "no_path"]


def listed() -> dict[str, Listed]:
    """Entries of the manifest by name."""
    content: dict[str, Any] = json.loads((FOLDER / "manifest.json").read_text(encoding="utf-8"))
    return {entry["name"]: entry for entry in content["scenes"]}


def proves(name: str) -> bool:
    """Tell whether the grid proves the expected verdict of a scene."""
    from oracles.grid import decide

    entry = listed()[name]
    scene = json.loads((FOLDER / entry["file"]).read_text(encoding="utf-8"))
    step = {**QUICK, **SLOW}[name]
    return decide(scene, step, claim=entry["expected"], hulls=name == "field")


def main() -> int:
    """Prove the named scenes, or all; exit 1 if one is not decided."""
    failed = 0
    for name in sys.argv[1:] or [*QUICK, *SLOW]:
        began = time.perf_counter()
        proved = proves(name)
        failed += not proved
        verdict = listed()[name]["expected"] if proved else "NOT DECIDED"
        print(f"{name:20} {verdict:12} {time.perf_counter() - began:7.1f} s", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))
    sys.exit(main())
