"""Ends that touch: resting, flush, exactly fitting, and off contact by units in the last place.

Touching is free; overlapping is not, by however little. Rounding cannot tell them apart, so that
`undecided` is what to expect without a contact tolerance; but a path from an end that truly
overlaps, a refusal or "no path" from one that truly does not, would be wrong. Truths are rational
(`exact`). With a tolerance τ an end that overlaps by less counts as touching.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from attacks.stress_parts.common import REFUSED, Row, Settings, expect
from oracles.exact import polygons as exact
from planar_planner import Options
from scenarios import model as draw
from worlds.lattice import lattice_scene
from worlds.maps import Similarity, exchanged, similar
from worlds.random_kinds import star
from worlds.scene import Scene, plain

PART = "contact"
TOLERANCE = 1e-6
OPTIONS = Options(max_cells=20_000, timeout=5.0)
TOLERANT = Options(max_cells=20_000, timeout=5.0, contact_tolerance=TOLERANCE)
FREE = {"path"}
BLOCKED = {"no_path"}
NOT_FREE = {"no_path", REFUSED}  # the end overlaps: refused, or proven to be no free one
FAR = 16.0
OPEN = (-FAR, -FAR, FAR, FAR)
DEPTHS = [0.7 * 10.0**-k for k in range(3, 16)]
ULPS = (0, 1, 2, 5, 10, 100, 10**3, 10**4, 10**5, 10**7, 10**9)
FULL, QUICK = 400, 6  # random falls of each kind

SQUARE = draw.box_ring(-0.5, -0.5, 0.5, 0.5)
TRIANGLE = [(-0.5, -0.5), (0.75, -0.5), (0.25, 0.75)]
ANGLE = [(-0.5, -0.5), (0.5, -0.5), (0.5, -0.25), (-0.25, -0.25), (-0.25, 0.5), (-0.5, 0.5)]
ROBOTS = (SQUARE, TRIANGLE, ANGLE)


@dataclass(frozen=True)
class Case:
    """A scene, and the answers that are true without and with a contact tolerance."""

    row: str
    scene: Scene
    plain: frozenset[str]
    tolerant: frozenset[str]


def run(settings: Settings) -> list[Row]:
    """Ask every case without and with a tolerance, and with start and goal exchanged."""
    rows: dict[str, Row] = {}
    done: dict[str, int] = {}
    for case in _cases(settings):
        done[case.row] = done.get(case.row, 0) + 1
        if done[case.row] > settings.most:
            continue
        for name, allowed, options in (
            (case.row, case.plain, OPTIONS),
            (f"{case.row}; tolerance {TOLERANCE:g}", case.tolerant, TOLERANT),
        ):
            row = rows.setdefault(name, Row(PART, name))
            for scene in (case.scene, exchanged(case.scene)):
                expect(settings, row, scene, allowed, options, certified=True)
    return list(rows.values())


def _cases(settings: Settings) -> Iterator[Case]:
    for ring in ROBOTS:
        for turns in (True, False):
            yield from _resting(ring, turns)
    yield from _fitting()
    yield from _overlapping()
    yield from _thin_wall()
    yield from _pinched(settings)
    for number in range(settings.count(4 * FULL, 4 * QUICK)):
        yield from _on_lattice(random.Random(f"{settings.seed} lattice {number}"))
    for number in range(settings.count(FULL, QUICK)):
        yield from _fallen(random.Random(f"{settings.seed} fall {number}"))


def _case(
    row: str,
    ring: draw.Ring,
    obstacles: list[draw.Geometry],
    ends: tuple[draw.Configuration, draw.Configuration],
    allowed: set[str],
    *,
    tolerant: set[str] | None = None,
    workspace: draw.Box | draw.Geometry = OPEN,
    bounds: draw.Box | None = None,
    turns: bool = True,
) -> Case:
    scene = draw.scene(
        row,
        "An end in contact.",
        workspace=workspace,
        reference_bounds=bounds,
        robot=draw.polygon(ring),
        obstacles=obstacles,
        start=ends[0],
        goal=ends[1],
        rotation=turns,
    )
    return Case(row, plain(scene), frozenset(allowed), frozenset(tolerant or allowed))


def _resting(ring: draw.Ring, turns: bool) -> Iterator[Case]:
    """Yield robots that touch at θ = 0, exactly, in every way that a plan may begin."""
    post = draw.box(2.0, -1.0, 3.0, 3.0)
    room = (-4.0, 0.0, 8.0, 6.0)
    floor = [draw.box(-4.0, -2.0, 8.0, 0.0), post]
    hall = draw.polygon([(-4.0, 0.0), (8.0, 0.0), (8.0, 6.0), (2.0, 7.0), (-4.0, 6.0)])
    wall = [draw.box(2.0, -1.0, 3.0, 7.0)]
    # every robot's lowest side is at −0.5, its leftmost point at −0.5
    rest, goal = (0.0, 0.5, 0.0), (6.0, 3.0, 0.0 if not turns else 1.0)
    flush, beside = (-3.5, 0.5, 0.0), (3.5, 2.0, 0.0)
    for case, start, obstacles, space in (
        ("resting on the workspace's floor", rest, [post], room),
        ("resting on an obstacle", rest, floor, OPEN),
        ("resting on a polygonal workspace's floor", rest, [post], hall),
        ("flush in a corner of the workspace", flush, [post], room),
        ("flush in a corner of a polygonal workspace", flush, [post], hall),
        ("flush between an obstacle and the floor", (3.5, 0.5, 0.0), [post], room),
        ("touching an obstacle's side", beside, [post], room),
        ("corner to corner with an obstacle", (3.5, 3.5, 0.0), [post], room),
    ):
        far = goal if start[0] < 3.0 else (-2.0, 3.0, goal[2])
        ends = (start, far)
        yield _case(case, ring, obstacles, ends, FREE, workspace=space, turns=turns)
        if space is not OPEN and post in obstacles and start[0] < 2.0:
            yield _case(
                f"{case}, walled in", ring, wall, ends, BLOCKED, workspace=space, turns=turns
            )
    yield _case(
        "reference point on its bounds",
        ring,
        [post],
        ((-1.0, 4.0, 0.0), (5.0, 4.5, goal[2])),
        FREE,
        bounds=(-1.0, -1.0, 5.0, 4.5),
        turns=turns,
    )


def _fitting() -> Iterator[Case]:
    """Yield parts in slots and passages of exactly their width: there is a path, by sliding."""
    for half in (0.5, 0.3, 1.0 / 3.0):  # ± the same double: the fit is exact
        part = draw.box_ring(-half, -0.75, half, 0.75)
        sides = [draw.box(-FAR, -3.0, -half, 2.0), draw.box(half, -3.0, FAR, 2.0)]
        block = [*sides, draw.box(-FAR, -4.0, FAR, -3.0)]
        plug = draw.box(-half, 1.5, half, 2.0)
        for turns in (True, False):
            end = (0.0, 4.0, 1.0 if turns else 0.0)
            inside = (0.0, -1.0, 0.0)
            for name, obstacles, start, goal, allowed in (
                ("exactly fitting slot, out of it", block, inside, end, FREE),
                ("exactly fitting slot, from its bottom", block, (0.0, -2.25, 0.0), end, FREE),
                ("exactly fitting slot, within it", block, inside, (0.0, 0.5, 0.0), FREE),
                ("exactly fitting slot, closed", [*block, plug], inside, end, BLOCKED),
                ("exactly fitting passage", sides, (0.0, -5.0, 0.0), end, FREE),
            ):
                yield _case(name, part, obstacles, (start, goal), allowed, turns=turns)
    room = (-0.5, -0.5, 2.5, 0.5)
    for goal, pin, allowed in (
        ((2.0, 0.0, 0.0), [], FREE),
        ((2.0, 0.0, 0.0), [draw.box(0.9, 0.4, 1.1, 0.5)], BLOCKED),
    ):
        yield _case(
            "exactly fitting corridor, the workspace's",
            SQUARE,
            pin,
            ((0.0, 0.0, 0.0), goal),
            allowed,
            workspace=room,
        )


def _overlapping() -> Iterator[Case]:
    """Yield ends that overlap by a known depth: 0.5 − y is exact for y near 0.5."""
    post = draw.box(2.0, -1.0, 3.0, 3.0)
    for depth in DEPTHS:
        y = 0.5 - depth
        tolerated = FREE if Fraction(1, 2) - Fraction(y) < Fraction(TOLERANCE) else NOT_FREE
        for space, floor in (
            ((-4.0, 0.0, 8.0, 6.0), []),
            (OPEN, [draw.box(-4.0, -2.0, 8.0, 0.0)]),
        ):
            yield _case(
                "sunk into the floor by 1e-3 ... 1e-15",
                SQUARE,
                [post, *floor],
                ((0.0, y, 0.0), (6.0, 3.0, 1.0)),
                NOT_FREE,
                tolerant=tolerated,
                workspace=space,
            )


def _thin_wall() -> Iterator[Case]:
    """Yield a robot that touches a wall thinner than the tolerance: there is no way through."""
    for thick in (1e-3, 1e-5, 1e-7, 1e-9, 1e-12):
        wall = draw.box(0.5, -FAR - 1.0, 0.5 + thick, FAR + 1.0)
        yield _case(
            "touching a wall thinner than the tolerance",
            SQUARE,
            [wall],
            ((0.0, 0.0, 0.0), (5.0, 0.0, 0.5)),
            BLOCKED,
        )


def _pinched(settings: Settings) -> Iterator[Case]:
    """Yield a rhomb just between two tips: the one place where both sides of a wall meet.

    It may not turn, so that the only way from side to side is through contact with both tips.
    """
    rhomb = [(-0.75, 0.0), (0.0, -0.5), (0.75, 0.0), (0.0, 0.5)]
    tips = [
        draw.polygon([(0.0, 0.5), (0.25, 4.0), (-0.25, 4.0)]),
        draw.polygon([(0.0, -0.5), (-0.25, -4.0), (0.25, -4.0)]),
    ]
    pinch, left, right = (0.0, 0.0, 0.0), (-2.0, 0.5, 0.0), (2.0, -1.0, 0.0)
    for ends in ((pinch, left), (pinch, right), (left, right)):
        case = _case(
            "pinched between two tips",
            rhomb,
            tips,
            ends,
            FREE,
            workspace=(-4.0, -4.0, 4.0, 4.0),
            turns=False,
        )
        yield case
        for number in range(settings.count(20, 2)):
            yield _elsewhere(case, random.Random(f"{settings.seed} pinch {number}"))


def _elsewhere(case: Case, rng: random.Random) -> Case:
    """Return the case turned, mirrored and moved, exactly; tolerances stay small beside it."""
    factor = complex(rng.randrange(-9, 10), rng.randrange(1, 10))
    shift = complex(rng.randrange(-999, 999), rng.randrange(-999, 999))
    image = similar(case.scene, Similarity(factor, shift, rng.random() < 0.5))
    assert image is not None  # no bounds of the reference point
    return replace(case, row=f"{case.row}, turned and moved", scene=image)


def _on_lattice(rng: random.Random) -> Iterator[Case]:
    """Yield a scene on a lattice, as it is and elsewhere."""
    scene, reached = lattice_scene(rng)
    truth = frozenset(FREE if reached else BLOCKED)
    case = Case("boxes on a lattice", scene, truth, truth)
    yield case
    yield _elsewhere(case, rng)


def _fallen(rng: random.Random) -> Iterator[Case]:
    """Yield random robots let fall on an obstacle, then lifted or sunk by a few last places."""
    ring = [(x, y) for x, y in star(rng, 1.0)]
    rock = star(rng, 1.5, (rng.uniform(-0.3, 0.3), -3.0))
    for angle, kind in ((0.0, "fallen on a rock"), (rng.uniform(-4.0, 4.0), "the same, turned")):
        body = exact.turned(exact.polygon(ring), angle)
        fall = exact.drop(body, exact.polygon(rock))
        if fall is None:
            continue
        touching = float(-fall)
        unit = math.ulp(touching)
        for ulps in ULPS:
            for y in (touching + ulps * unit, touching - ulps * unit):
                depth = -fall - Fraction(y)  # how far it has to rise to be free; exact
                tolerated = FREE if depth <= Fraction(TOLERANCE) else NOT_FREE
                yield _case(
                    f"{kind}, within 1e9 ulp",
                    ring,
                    [draw.polygon([(p[0], p[1]) for p in rock])],
                    ((0.0, y, angle), (rng.uniform(-5.0, 5.0), 5.0, 0.5)),
                    FREE if depth <= 0 else NOT_FREE,
                    tolerant=tolerated,
                )
