"""Counts of work that do not depend on the machine.

For every shipped scene, for families that show how work grows (each with a law that a regression
would break: logarithmic in the clearance, linear in the length of the way, untouched by what is far
away), and for the planner without single parts.

``python bench/counts.py`` compares them with those on record, ``--check`` fails if a verdict is
another or a count is off by more than the slack, ``--update`` puts them on record.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from lib import provenance
from parts.ablation import variants
from parts.scale.families import GEAR_CRITICAL
from planar_planner import Options, load_scene, solve
from planar_planner.load import SceneLike
from planar_planner.planning.engine import ask, make_core
from planar_planner.problem.make import make_problem
from planar_planner.scene.builtin import manifest
from scenarios import corner, field, gear, maze
from scenarios.model import Scene
from worlds import growing as worlds

RECORD = Path(__file__).with_name("counts.json")
FORMAT = "planar-planner/counts"
COUNTS = {  # statistic and its heading
    "probe_checks": "first try",
    "cells": "cells",
    "labelled_cells": "labelled",
    "separation_evaluations": "separations",
    "search_expansions": "expansions",
}
# Parts are left out on scenes where they matter, and that take a moment without them too.
PARTS = {
    "slot-jammed": ("no joint, DISP query", "no joint, Eq. 3 query", "no star test"),
    "corner-too-long": ("no joint obstruction", "level by level"),
    "gear": ("no joint, no query", "search from scratch", "cover, not partition"),
}
# Allowed in either direction. Counts repeat exactly on one machine; another C library may round a
# sine otherwise and so change a few cells.
SLACK = 0.10
LEAST = 20  # a count may always differ by so much: 10 % of a few cells is no difference


def families() -> dict[str, Scene]:
    """Return scenes of the families, by what stands in the record."""
    critical = corner.critical_length(corner.DEFAULT_WIDTH)
    scenes = {
        f"corner {sign * clearance:+.0e}": corner.corner(critical + sign * clearance)
        for sign in (-1, 1)
        for clearance in (1e-3, 1e-6, 1e-9)
    }
    scenes |= {
        f"gear {sign * 1e-6:+.0e}": gear.gear(GEAR_CRITICAL + sign * 1e-6) for sign in (1, -1)
    }
    scenes |= {f"baffles {count}": worlds.growing_channel(count) for count in (30, 100, 300)}
    scenes |= {f"lane {count}": worlds.fixed_channel(count) for count in (100, 3000)}
    scenes |= {f"teeth {pieces}": worlds.toothed(pieces, 1.6) for pieces in (5, 50)}
    scenes |= {f"far {far}": field.field(400, far=far) for far in (10, 3000)}
    scenes["maze 32"] = maze.maze(32)
    return scenes


def counted() -> dict[str, dict[str, Any]]:
    """Solve every shipped scene, the families, and some without a part."""
    found: dict[str, dict[str, Any]] = {}
    shipped = {name: load_scene(name) for name in manifest()}
    asked: dict[str, SceneLike] = {**shipped, **families()}
    for name, scene in asked.items():
        result = solve(scene)
        counts = {key: int(result.stats[key]) for key in COUNTS}
        found[name] = {"verdict": result.verdict, **counts}
    by_name = {variant.name: variant for variant in variants.ABLATIONS}
    for scene_name, parts in PARTS.items():
        problem = make_problem(shipped[scene_name])
        for part in parts:
            variant = by_name[part]
            core = make_core(problem, variant.without, variant.query)
            answer = ask(core, problem, Options())
            counts = {key: int(answer["stats"][key]) for key in COUNTS}
            found[f"{scene_name}: {part}"] = {"verdict": answer["verdict"], **counts}
    return found


def recorded() -> dict[str, dict[str, Any]]:
    """Return what is on record; nothing if there is no record yet."""
    if not RECORD.is_file():
        return {}
    content = json.loads(RECORD.read_text(encoding="utf-8"))
    if content.get("format") != FORMAT:
        raise SystemExit(f"{RECORD}: is not a {FORMAT}")
    scenes: dict[str, dict[str, Any]] = content["scenes"]
    return scenes


def differs(old: int, new: int) -> bool:
    """Whether a count has changed by more than is allowed."""
    return abs(new - old) > max(SLACK * old, LEAST)


def compared(old: dict[str, Any] | None, new: dict[str, Any] | None) -> tuple[str, bool]:
    """Return the columns of one scene, and whether something differs by more than is allowed."""
    if old is None or new is None:
        return "not on record" if old is None else "no longer shipped", True
    bad = old["verdict"] != new["verdict"]
    verdict = new["verdict"] if not bad else f"{old['verdict']} -> {new['verdict']} !"
    columns = [f"{verdict:<10}"]
    for key in COUNTS:
        if key not in old:
            columns.append(f"{new[key]:>11,} {'':>9}  ")
            continue
        change = f"{100.0 * (new[key] - old[key]) / max(old[key], 1):+.1f} %"
        mark = " !" if differs(old[key], new[key]) else "  "
        bad = bad or differs(old[key], new[key])
        columns.append(f"{new[key]:>11,} {'' if new[key] == old[key] else change:>9}{mark}")
    return " ".join(columns), bad


def print_comparison(old: dict[str, dict[str, Any]], new: dict[str, dict[str, Any]]) -> list[str]:
    """Print a line a scene; return the scenes that differ by more than is allowed."""
    headings = " ".join(f"{heading:>11} {'change':>9}  " for heading in COUNTS.values())
    print(f"{'scene':<36} {'verdict':<10} {headings}")
    bad = []
    for name in [*new, *(name for name in old if name not in new)]:
        columns, differing = compared(old.get(name), new.get(name))
        print(f"{name:<36} {columns}")
        if differing:
            bad.append(name)
    return bad


def update(new: dict[str, dict[str, Any]]) -> None:
    """Put the counts on record, a scene a line."""
    scenes = ",\n".join(f'    "{name}": {json.dumps(counts)}' for name, counts in new.items())
    RECORD.write_text(
        f'{{\n  "format": "{FORMAT}",\n  "scenes": {{\n{scenes}\n  }}\n}}\n', encoding="utf-8"
    )


def main() -> int:
    """Compare, and check or update if asked."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="exit 1 if a scene differs")
    what.add_argument("--update", action="store_true", help="put the counts on record")
    arguments = parser.parse_args()
    print(f"commit {provenance.provenance()['commit']}")
    new = counted()
    bad = print_comparison(recorded(), new)
    if arguments.update:
        update(new)
        print(f"\nwritten: {RECORD}")
    elif arguments.check and bad:
        print(
            f"\nmore than {100 * SLACK:.0f} % off, or another verdict: {', '.join(bad)}\n"
            "If that is meant, say why in the commit: python bench/counts.py --update"
        )
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
