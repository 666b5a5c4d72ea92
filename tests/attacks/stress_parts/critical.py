"""Both sides of critical values down to 1e-12 of them: no verdict may be wrong, however near.

Where the truth is known from a theorem (`families.families`) each answer is compared with it. Two
more families have no formula: a slot whose scenes are nested, so that a path at one width and none
at a larger one would be a contradiction, and the gears, which are expected to behave so. Each
answer's certificate is checked. The note says down to which relative distance a side was decided.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from attacks.stress_parts.common import Row, Settings, ask, expect, fail
from planar_planner import Options
from scenarios import gear, slot
from worlds.critical import Family, families
from worlds.scene import Scene, plain

PART = "critical"
SIDES = {"path": "with a path", "no_path": "without"}
EXPONENTS = [0.5 * k for k in range(2, 25)]  # relative distances 10^-1 ... 10^-12
QUICK_EXPONENTS = [1.0, 4.0, 8.0, 12.0]
ULPS = 3  # neighbours of the critical value itself that are tried as well
CELLS, QUICK_CELLS = 50_000, 20_000
RESOLUTIONS = {"default": Options().resolution, "finest": 1e-15}
HALVINGS = 60  # at most; a bracket is below 1e-12 of its value by then
OFF_MIDDLE = 0.4637  # where a bracket is parted: critical values like to be the middle of something


@dataclass
class Side:
    """One side of a family's critical value: its row, and what was decided at each level."""

    row: Row
    decided: dict[str, list[float]] = field(default_factory=dict)
    undecided: dict[str, list[float]] = field(default_factory=dict)

    def note(self) -> str:
        """Say how near the critical value a side is decided, at each level of resolution."""
        parts = []
        for level in RESOLUTIONS:
            first_open = max(self.undecided.get(level, []), default=-math.inf)
            safe = [d for d in self.decided.get(level, []) if d > first_open]
            text = f"decided to {min(safe):.0e}" if safe else "nowhere decided"
            until = "" if first_open < 0 else f", undecided from {first_open:.0e}"
            parts.append(f"{level}: {text}{until}")
        return "; ".join(parts)


def run(settings: Settings) -> Iterator[Row]:
    """Ask on both sides of every family."""
    for family in list(families())[: settings.most]:
        yield from _family(settings, family)
    for name, make, bracket in _nested()[: settings.count(2, 1)]:
        yield _monotone(settings, name, make, bracket)


def _exponents(settings: Settings) -> list[float]:
    return (QUICK_EXPONENTS if settings.quick else EXPONENTS)[: settings.most]


def _levels(settings: Settings) -> dict[str, Options]:
    cells = QUICK_CELLS if settings.quick else CELLS
    return {
        level: Options(max_cells=cells, timeout=10.0, resolution=resolution)
        for level, resolution in RESOLUTIONS.items()
    }


def parameters(settings: Settings, family: Family) -> list[float]:
    """Return parameters on both sides, and the doubles next to the critical value."""
    distances = [sign * 10.0**-e for e in _exponents(settings) for sign in (-1, 1)]
    found = [family.near(distance) for distance in distances]
    if not family.grid:
        near = [family.critical] * 2
        for _ in range(min(ULPS, settings.most)):
            found += near
            near = [math.nextafter(near[0], 0.0), math.nextafter(near[1], math.inf)]
    return sorted(set(found))


def _family(settings: Settings, family: Family) -> list[Row]:
    sides = {truth: Side(Row(PART, f"{family.name}, {side}")) for truth, side in SIDES.items()}
    for parameter in parameters(settings, family):
        scene = {**family.make(parameter), "name": f"{family.name} at {parameter!r}"}
        truth = "path" if family.has_path(parameter) else "no_path"
        side = sides[truth]
        distance = abs(parameter / family.critical - 1.0)
        for level, options in _levels(settings).items():
            answer = expect(settings, side.row, scene, {truth}, options, certified=True)
            into = side.undecided if answer.verdict == "undecided" else side.decided
            into.setdefault(level, []).append(distance)
    for side in sides.values():
        side.row.note = side.note()
    return [side.row for side in sides.values()]


def _nested() -> list[tuple[str, Callable[[float], Scene], tuple[float, float]]]:
    """Name, scene of a parameter, and a bracket of the critical one: no path, path."""
    return [
        ("T-slot, nested", lambda neck: plain(slot.slot(neck)), (slot.JAMMED_NECK, slot.PATH_NECK)),
        ("gears", lambda gap: plain(gear.gear(gap)), (gear.JAMMED_GAP, gear.PATH_GAP)),
    ]


def _monotone(
    settings: Settings,
    name: str,
    make: Callable[[float], Scene],
    bracket: tuple[float, float],
) -> Row:
    """Bisect until undecided, look round the bracket; there is one threshold or a contradiction."""
    row = Row(PART, f"{name}: one threshold")
    answers: dict[float, str] = {}
    levels = _levels(settings)

    def look(parameter: float, options: Options) -> str:
        scene = {**make(parameter), "name": f"{name} at {parameter!r}"}
        verdict = ask(settings, row, scene, options, certified=True).verdict
        if verdict in {"path", "no_path"}:
            if answers.get(parameter, verdict) != verdict:
                fail(settings, row, scene, f"contradiction: {verdict} and not")
            answers[parameter] = verdict
        return verdict

    low, high = bracket
    for _ in range(settings.count(HALVINGS, HALVINGS)):
        between = low + OFF_MIDDLE * (high - low)
        verdict = look(between, levels["finest"])
        if verdict not in {"path", "no_path"} or high - low < 1e-12 * high:
            break
        low, high = (low, between) if verdict == "path" else (between, high)
    for exponent in _exponents(settings):
        for parameter in (low * (1.0 - 10.0**-exponent), high * (1.0 + 10.0**-exponent)):
            look(parameter, levels["default"])
    closed = [parameter for parameter, verdict in answers.items() if verdict == "no_path"]
    opened = [parameter for parameter, verdict in answers.items() if verdict == "path"]
    if closed and opened:
        low, high = max(closed), min(opened)
        row.note = f"no path at {low!r}, a path at {high!r}, {high / low - 1.0:.1e} apart"
        if low >= high:
            fail(settings, row, make(low), row.note)
    return row
