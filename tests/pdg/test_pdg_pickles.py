"""Bodies, sets, grasps and results survive pickling, and give the same results afterwards."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import pdg
from pdg import grasp, sets
from worlds.bodies.random_bodies import blob

POSE = (0.4, -0.3, 0.7)
POSES = [POSE, (9.0, 9.0, 0.0), (0.0, 0.0, 3.0)]
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
ELL = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)]
RANDOM = np.random.default_rng(77)


class Disc:
    """A caller's own set."""

    dimension = 2

    def __init__(self, radius: float) -> None:
        self.radius = radius

    def support(self, u: np.ndarray) -> tuple[float, np.ndarray]:
        length = float(np.linalg.norm(u))
        return self.radius * length, self.radius * u / length


CONTACTS = [
    grasp.soft_finger(at, -np.array(at), 0.5, 0.1)
    for at in ((1.0, 0, 0), (-0.5, 0.8, 0.2), (-0.5, -0.8, 0.1), (0.0, 0.1, 1.0))
]
FINGER = grasp.finger(
    grasp.point_contact((0, 1), (0, -1), 0.5),
    [grasp.revolute((-1.13, 1.65)), grasp.revolute((-1.08, 1.05))],
    modes=("active", "active"),
)


def active() -> grasp.WrenchSet:
    wrenches = grasp.active_wrench_set([FINGER])
    assert wrenches is not None
    return wrenches


# Made anew for each test: what a module holds may outlive the core at exit.
SETS: list[Callable[[], sets.ConvexSet]] = [
    lambda: sets.Ball(2, 1.5, (0.1, 0.2)),
    lambda: sets.Ellipsoid((1, 2), (0.3, 0)),
    lambda: sets.Ellipsoid([(1, 2, 0), (0, 1, 1)]),
    lambda: sets.Box((1, 0.5)),
    lambda: sets.CrossPolytope((1, 0.5), (0.1, 0)),
    lambda: sets.PointSet(SQUARE),
    lambda: sets.Segment((0, 0), (1, 2)),
    lambda: sets.MinkowskiSum([sets.Box((1, 0.5)), sets.Ball(2)]),
    lambda: sets.UnionHull([sets.Box((1, 0.5)), sets.Ball(2, 0.7)]),
    lambda: sets.AffineImage([(1, 2), (0, 1)], sets.Ball(2), (0.1, 0)),
    lambda: sets.Scaled(-2, sets.PointSet(SQUARE)),
    lambda: sets.as_convex_set(Disc(0.7), "disc", 1e-9),
    lambda: sets.MinkowskiSum([Disc(0.7), sets.Ball(2)]),
    lambda: grasp.grasp_wrench_set(CONTACTS, "l1"),
    active,
]
PICKLED = pytest.mark.parametrize(
    "again", [lambda one: pickle.loads(pickle.dumps(one)), copy.copy, copy.deepcopy]
)
Again = Callable[[Any], Any]


def same(one: Any, other: Any) -> bool:
    """Whether values are equal to the last bit, field by field."""
    if dataclasses.is_dataclass(one):
        fields = [field.name for field in dataclasses.fields(one)]
        return type(one) is type(other) and all(
            same(getattr(one, name), getattr(other, name)) for name in fields
        )
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and np.array_equal(one, other, equal_nan=one.dtype == float)
    return type(one) is type(other) and one == other


def test_same_finds_differences() -> None:
    depth = pdg.translational_depth(SQUARE, SQUARE, POSE)
    assert same(depth, pdg.translational_depth(SQUARE, SQUARE, POSE))
    assert not same(depth, pdg.translational_depth(SQUARE, SQUARE, (0.4, -0.3, 0.8)))


@PICKLED
@pytest.mark.parametrize("cover", [True, False])
@pytest.mark.parametrize(
    "body",
    [SQUARE, ELL, [SQUARE, ELL], blob(RANDOM), blob(RANDOM)],
    ids=["square", "ell", "both", "blob", "another blob"],
)
def test_pieces(body: Any, cover: bool, again: Again) -> None:
    pieces = pdg.convex_pieces([pdg.convex_pieces(body, cover=cover), SQUARE], cover=cover)
    other = again(pieces)
    assert type(other) is pdg.ConvexPieces
    assert len(other) == len(pieces)
    assert all(np.array_equal(one, two) for one, two in zip(pieces, other, strict=True))
    assert (other.radius, other.radii) == (pieces.radius, pieces.radii)
    bracket = pdg.generalized_depth_bracket(pieces, SQUARE, POSES, 1e-2)
    assert same(bracket, pdg.generalized_depth_bracket(other, SQUARE, POSES, 1e-2))


@PICKLED
def test_separators(again: Again) -> None:
    body = blob(RANDOM)
    separators = pdg.convex_separators(body)
    assert len(separators) > 0
    other = again(separators)
    assert all(np.array_equal(one, two) for one, two in zip(separators, other, strict=True))
    bound = pdg.generalized_depth_upper_bound(ELL, separators, POSES, method="best")
    assert same(bound, pdg.generalized_depth_upper_bound(ELL, other, POSES, method="best"))


def test_every_kind_of_set_is_tried() -> None:
    kinds = {one for name in sets.__all__ if isinstance(one := getattr(sets, name), type)}
    assert kinds - {sets.SupportSet, sets.ConvexSet} <= {type(make()) for make in SETS}


@PICKLED
@pytest.mark.parametrize("make", SETS)
def test_sets(make: Callable[[], sets.ConvexSet], again: Again) -> None:
    one = make()
    other = again(one)
    assert type(other) is type(one)
    assert repr(other) == repr(one) or "Disc" in repr(one)
    directions = np.random.default_rng(5).normal(size=(50, one.dimension))
    for a, b in zip(one.supports(directions), other.supports(directions), strict=True):
        assert np.array_equal(a, b)
    around = sets.MinkowskiSum([one, sets.Ball(one.dimension, 10.0)])
    grown = sets.MinkowskiSum([other, sets.Ball(one.dimension, 10.0)])
    ball = sets.Ball(one.dimension)
    found = pdg.penetration_distance(around, ball, 0.1, max_iterations=30)
    assert same(found, pdg.penetration_distance(grown, ball, 0.1, max_iterations=30))


def test_a_set_keeps_its_own_copy_of_the_callers_arrays() -> None:
    radii = np.array([1.0, 2.0])
    box = sets.Box(radii)
    radii[:] = 7
    assert pickle.loads(pickle.dumps(box)).support((1, 0))[0] == box.support((1, 0))[0] == 1


def test_a_set_that_does_not_pickle_says_why() -> None:
    class Local(Disc):
        """Cannot be imported, so it cannot be pickled."""

    with pytest.raises((pickle.PicklingError, AttributeError), match="Local"):
        pickle.dumps(sets.as_convex_set(Local(1.0)))


@PICKLED
def test_grasps(again: Again) -> None:
    for one in (CONTACTS[0], FINGER, grasp.finger_forces(FINGER), FINGER.contact):
        assert same(one, again(one))
    joint = grasp.revolute((2, 0, 1), (0, 1, 0))
    assert same(joint, again(joint))
    assert same(grasp.finger_forces(FINGER), grasp.finger_forces(again(FINGER)))
    wrenches = grasp.grasp_wrench_set(CONTACTS, "l1")
    other = again(wrenches)
    assert (other.norm, other.idle) == (wrenches.norm, wrenches.idle)
    assert same(other.centres, wrenches.centres)
    assert same(other.basis, wrenches.basis)
    efficiency = grasp.force_efficiency(wrenches, max_iterations=20)
    assert same(efficiency, grasp.force_efficiency(other, max_iterations=20))
    assert same(efficiency, again(efficiency))
    assert same(grasp.force_closure(wrenches), again(grasp.force_closure(other)))


@PICKLED
@pytest.mark.parametrize("pose", [POSE, POSES])
def test_results(pose: Any, again: Again) -> None:
    cell = [*POSE, 0.01, 0.01, 0.01] if pose is POSE else [[*q, 0.01, 0.01, 0.01] for q in POSES]
    for result in (
        pdg.translational_depth(ELL, SQUARE, pose),
        pdg.generalized_depth_lower_bound(ELL, SQUARE, pose),
        pdg.generalized_depth_upper_bound(ELL, SQUARE, pose),
        pdg.generalized_depth_bracket(ELL, SQUARE, pose),
        pdg.generalized_distance_bracket(ELL, (0, 0, 0), pose),
        pdg.c_obstacle_query(ELL, SQUARE, cell),
        pdg.motion_bounds((1, 1, 1), 2.0),
        pdg.penetration_distance(sets.Ball(2), sets.Box((1, 1)), history=True),
    ):
        assert same(result, again(result))
