"""What must not change a verdict: where a scene lies, its units, how it is drawn, which way.

Every shipped scene is put on a grid (`maps.snapped`) and its answer must be the manifest's; tight
scenes, near critical values, are on it as they are (`families`). Then

- *exact* maps and redrawings give the same problem to the last bit: any other verdict than the
  true one, or a refusal, is a contradiction;
- *rounded* maps give a near problem: every coordinate moves by at most a few units in the last
  place of the largest one. They are applied only to scenes whose answer is known to survive that
  (`has_margin`), and where rounding may make a polygon invalid the refusal is no contradiction.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import shapely

from attacks.stress_parts.common import REFUSED, Answer, Row, Settings, ask, expect
from planar_planner import Options, load_scene
from worlds import redraw
from worlds.critical import families
from worlds.maps import Similarity, exchanged, rounded, similar, size, snapped
from worlds.scene import Scene
from worlds.shipped import with_point_goals

PART = "invariance"
FAR = (3, 6, 9)  # powers of ten: shifts in sizes of the scene, and units
FAR_BITS = (10, 20, 30)  # the same as powers of two, for exact maps
FACTOR_BITS = 10  # of a random exact factor's parts: arbitrary angles, to a degree's twentieth
TIGHT = 2.0**-18  # of a scene's size: step of a tight scene's parameter; its halves are on the grid
MARGIN = 1e-6  # of a scene's size; rounding at 1e9 sizes from the origin moves a point by 1.6e-7

OFF_GRID = frozenset({"peg", "peg-jammed", "exact-maze-ulp", "sliding-block-ulp"})
"""Exact fits in decimals, and twins off by a last place: on a grid they are other scenes. What must
not change them is tried by attacks/exact_fits.py."""

Change = Callable[[Scene, random.Random], Scene | None]


@dataclass(frozen=True)
class Subject:
    """A scene on its grid, and its true answer; `tight` if that is nearly another."""

    name: str
    scene: Scene
    truth: str
    tight: bool

    @property
    def options(self) -> Options:
        """Limits: tight scenes may take cells without end where they stand aslant."""
        return Options(max_cells=10_000 if self.tight else 300_000, timeout=10.0)


def run(settings: Settings) -> Iterator[Row]:
    """Apply every change to every shipped scene, and to tight ones."""
    shipped, tight = list(_shipped())[: settings.most], list(_tight())[: settings.most]
    subjects = shipped + (tight[::4] if settings.quick else tight)
    rows, steady = _as_they_are(settings, subjects)
    yield from rows
    for case, change, draws, is_exact in _cases():
        row = Row(PART, case, note="" if is_exact else "rounded")
        for subject in subjects if is_exact else steady:
            if settings.quick and len(subjects) > 2 and _chance(case, subject) < 0.6:
                continue
            allowed = {subject.truth} if is_exact else {subject.truth, REFUSED}
            for draw in range(1 if subject.tight else settings.count(draws, 1)):
                rng = random.Random(f"{settings.seed} {case} {subject.name} {draw}")
                changed = change(subject.scene, rng)
                if changed is not None:
                    expect(settings, row, changed, allowed, subject.options)
        yield row


def _chance(case: str, subject: Subject) -> float:
    return random.Random(f"{case} {subject.name}").random()


def _shipped() -> Iterator[Subject]:
    for name, entry in with_point_goals().items():
        if name in OFF_GRID:
            continue
        scene = snapped(load_scene(name).to_dict())
        yield Subject(name, scene, str(entry["expected"]), tight=False)


def _tight() -> Iterator[Subject]:
    """Yield the families one grid step on either side of their critical values.

    Those whose scenes lie on the grid as they are: their truth is then known.
    """
    for family in families():
        unit = TIGHT * size(family.make(family.near(0.0)))
        near = math.floor(family.critical / unit)
        for parameter in (unit * (near + k) for k in (-1, 0, 1, 2)):
            scene = {**family.make(parameter), "name": f"{family.name} at {parameter!r}"}
            if snapped(scene) == scene:
                truth = "path" if family.has_path(parameter) else "no_path"
                yield Subject(scene["name"], scene, truth, tight=True)


def _as_they_are(settings: Settings, subjects: list[Subject]) -> tuple[list[Row], list[Subject]]:
    """Ask for the scenes unchanged; return rows, and the scenes that rounding cannot change."""
    base = Row(PART, "unchanged, on a grid")
    margins = Row(PART, "robot eroded: has the scene a margin?")
    steady = []
    for subject in subjects:
        answer = expect(settings, base, subject.scene, {subject.truth}, subject.options)
        if has_margin(settings, margins, subject, answer):
            steady.append(subject)
    count = len(subjects) - len(steady)
    margins.note = f"{count} have none of {MARGIN:g} sizes: they are not in the rounded maps"
    return [base, margins], steady


def has_margin(settings: Settings, row: Row, subject: Subject, answer: Answer) -> bool:
    """Whether moving each point by `MARGIN` sizes cannot change the answer.

    A path: its certified clearance is larger than the sum of the robot's and the obstacles'
    motions. No path: there is none either for the robot eroded by that sum; where it meets an
    obstacle, a moved robot meets the moved obstacle.
    """
    scene = subject.scene
    margin = 2 * MARGIN * size(scene)
    if answer.result is not None and answer.verdict == "path":
        return bool(answer.result.stats.least_clearance > margin)
    body = shapely.MultiPolygon(
        [shapely.Polygon(p[0], p[1:]) for p in redraw.polygons(scene["robot"])]
    )
    eroded = shapely.geometry.mapping(body.buffer(-margin, join_style="mitre"))
    return ask(settings, row, {**scene, "robot": eroded}, subject.options).verdict == "no_path"


def _cases() -> Iterator[tuple[str, Change, int, bool]]:
    """Yield name, change, how many random draws of it to take, and whether it is exact."""
    yield "turned by 90, 180, 270 degrees", _quarter_turned, 3, True
    yield "turned by arbitrary angles", _turned, 8, True
    yield "mirrored", lambda s, _: similar(s, Similarity(mirrored=True)), 1, True
    yield "mirrored and turned by arbitrary angles", _mirrored_turned, 4, True
    yield "start and goal exchanged", lambda s, _: exchanged(s), 1, True
    for power, bits in zip(FAR, FAR_BITS, strict=True):
        yield f"translated by 1e{power} sizes", _translated(bits), 3, True
    for bits in (*(-b for b in reversed(FAR_BITS)), *FAR_BITS):
        yield f"scaled by 2^{bits}", _scaled(bits), 1, True
    yield "turned, mirrored, translated, scaled", _anything, 8, True
    yield "rings shuffled", redraw.shuffled, 4, True
    yield "collinear vertices added", redraw.with_collinear, 3, True
    yield "duplicate vertices added", redraw.with_duplicates, 3, True
    yield "obstacles cut into triangles", redraw.obstacles_cut, 2, True
    yield "obstacles cut finely, and overlapping", redraw.obstacles_cut_fine, 1, True
    yield "robot cut into triangles", redraw.robot_cut, 2, True
    yield "walls drawn as an obstacle", redraw.walls_drawn, 1, True
    yield "all redrawings at once, anywhere", _redrawn_anywhere, 4, True
    yield "turned by arbitrary angles, theta too", _turned_rounded, 8, False
    for power in FAR:
        yield f"translated by 1e{power} sizes, off the grid", _translated_rounded(power), 3, False
    for power in (*(-p for p in reversed(FAR)), *FAR):
        yield f"scaled by 1e{power}", _scaled_rounded(power), 1, False


def _factor(rng: random.Random) -> complex:
    """Return a random complex number of `FACTOR_BITS` bits: any angle, and some scale."""
    largest = 2**FACTOR_BITS
    angle = rng.uniform(0.0, 2.0 * math.pi)
    return complex(round(largest * math.cos(angle)), round(largest * math.sin(angle)))


def _shift(scene: Scene, bits: int, rng: random.Random) -> complex:
    """Return a shift by 2^bits sizes in x, y or both: exact on the scene's grid."""
    x, y = rng.choice(((1, 0), (0, -1), (-1, 1), (1, 1)))
    return complex(x, y) * size(scene) * 2.0**bits


def _quarter_turned(scene: Scene, rng: random.Random) -> Scene | None:
    return similar(scene, Similarity(rng.choice((1j, -1, -1j))))


def _turned(scene: Scene, rng: random.Random) -> Scene | None:
    return similar(scene, Similarity(_factor(rng)))


def _mirrored_turned(scene: Scene, rng: random.Random) -> Scene | None:
    return similar(scene, Similarity(_factor(rng), mirrored=True))


def _translated(bits: int) -> Change:
    return lambda scene, rng: similar(scene, Similarity(shift=_shift(scene, bits, rng)))


def _scaled(bits: int) -> Change:
    return lambda scene, _: similar(scene, Similarity(2.0**bits))


def _anything(scene: Scene, rng: random.Random) -> Scene | None:
    unit = 2.0 ** rng.randrange(-40, 2)  # with the rest below the gate's largest coordinate, 1e12
    by = Similarity(
        unit * _factor(rng),
        unit * 2.0**FACTOR_BITS * _shift(scene, rng.randrange(10, 19), rng),
        rng.random() < 0.5,
    )
    return similar(scene, by)


def _redrawn_anywhere(scene: Scene, rng: random.Random) -> Scene | None:
    pieces = rng.choice((redraw.obstacles_cut, redraw.with_collinear, redraw.walls_drawn))
    drawn = redraw.with_duplicates(redraw.shuffled(pieces(scene, rng), rng), rng)
    return _anything(drawn, rng)


def _turned_rounded(scene: Scene, rng: random.Random) -> Scene | None:
    return rounded(scene, rng.uniform(-math.pi, math.pi), 1.0, (0.0, 0.0))


def _translated_rounded(power: int) -> Change:
    def change(scene: Scene, rng: random.Random) -> Scene | None:
        far, angle = 10.0**power * size(scene), rng.uniform(-math.pi, math.pi)
        return rounded(scene, 0.0, 1.0, (far * math.cos(angle), far * math.sin(angle)))

    return change


def _scaled_rounded(power: int) -> Change:
    return lambda scene, _: rounded(scene, 0.0, 10.0**power, (0.0, 0.0))
