"""Whatever a caller passes, the error is a PdgError that names the argument."""

from __future__ import annotations

import inspect
import math
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import pdg
import pdg.grasp
from pdg import grasp, sets

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
POSE = (0.5, 0.5, 0.1)
SEARCH: dict[str, Any] = {
    "absolute_tolerance": 0.1,
    "relative_tolerance": 0.0,
    "timeout": 1.0,
    "max_iterations": 10,
    "max_facets": 100,
    "history": False,
}
Call = tuple[Callable[..., object], dict[str, Any]]


def calls() -> list[Call]:
    """Every public function with arguments that it takes.

    They are made anew for each test: what a module holds may outlive the core at exit.
    """
    ball = sets.Ball(2)
    contact = grasp.point_contact((1, 0), (-1, 0), 0.5)
    joints = [grasp.revolute((2, 1)), grasp.revolute((2, -1))]
    finger = grasp.finger(contact, joints)
    wrenches = grasp.grasp_wrench_set([contact])
    return [
        (pdg.convex_pieces, {"body": SQUARE, "cover": True}),
        (pdg.even_odd_pieces, {"rings": [SQUARE], "cover": True}),
        (
            pdg.polygon_defect,
            {"coords": SQUARE, "ring_starts": np.array([0, 4]), "polygon_starts": np.array([0, 1])},
        ),
        (pdg.convex_separators, {"B": SQUARE}),
        (pdg.translational_depth, {"A": SQUARE, "B": SQUARE, "pose": POSE}),
        (pdg.generalized_depth_lower_bound, {"A": SQUARE, "B": SQUARE, "pose": POSE}),
        (
            pdg.generalized_depth_upper_bound,
            {"A": SQUARE, "B": SQUARE, "pose": POSE, "method": "best"},
        ),
        (
            pdg.generalized_depth_bracket,
            {
                "A": SQUARE,
                "B": SQUARE,
                "pose": POSE,
                "relative_tolerance": 0.1,
                "timeout": 1.0,
                "max_nodes": 5,
            },
        ),
        (pdg.displacement, {"body": SQUARE, "q0": POSE, "q1": POSE}),
        (pdg.generalized_distance_bracket, {"body": SQUARE, "q0": POSE, "q1": POSE}),
        (pdg.motion_bounds, {"half_extents": POSE, "radius": 1.0}),
        (
            pdg.c_obstacle_query,
            {"A": SQUARE, "B": SQUARE, "cell": [*POSE, 0.1, 0.1, 0.1], "method": "published"},
        ),
        (pdg.penetration_distance, {"A": ball, "Q": ball, **SEARCH}),
        (sets.AffineImage, {"matrix": np.eye(2), "inner": ball, "offset": (1, 2)}),
        (sets.Ball, {"dimension": 2, "radius": 1.0, "centre": (0, 0)}),
        (sets.Box, {"half_extents": (1, 1), "centre": (0, 0)}),
        (sets.CrossPolytope, {"radii": (1, 1), "centre": (0, 0)}),
        (sets.Ellipsoid, {"axes": np.eye(2), "centre": (0, 0)}),
        (sets.MinkowskiSum, {"sets": [ball]}),
        (sets.PointSet, {"points": SQUARE}),
        (sets.Scaled, {"factor": 2.0, "inner": ball}),
        (sets.Segment, {"start": (0, 0), "end": (1, 0)}),
        (sets.UnionHull, {"sets": [ball]}),
        (sets.as_convex_set, {"value": ball, "accuracy": 1e-9}),
        (ball.support, {"u": (1, 0)}),
        (ball.supports, {"directions": np.eye(2)}),
        (grasp.frictionless, {"position": (1, 0), "normal": (1, 0)}),
        (
            grasp.point_contact,
            {"position": (1, 0, 0), "normal": (1, 0, 0), "friction": 0.5, "tangent": (0, 1, 0)},
        ),
        (
            grasp.soft_finger,
            {
                "position": (1, 0, 0),
                "normal": (1, 0, 0),
                "friction": 0.5,
                "torsion": 0.1,
                "tangent": (0, 1, 0),
            },
        ),
        (grasp.contact_map, {"contact": contact, "length": 1.0}),
        (grasp.revolute, {"point": (0, 0, 0), "axis": (1, 0, 0)}),
        (grasp.prismatic, {"axis": (1, 0)}),
        (
            grasp.finger,
            {
                "contact": contact,
                "joints": joints,
                "coupling": np.eye(2),
                "modes": ("active", "free"),
            },
        ),
        (grasp.finger_forces, {"finger": finger, "length": 1.0}),
        (
            grasp.grasp_wrench_set,
            {"contacts": [contact], "norm": "l1", "length": 1.0, "idle": True},
        ),
        (grasp.active_wrench_set, {"fingers": [finger], "norm": "l1", "length": 1.0, "idle": True}),
        (grasp.force_closure, {"wrenches": wrenches, "timeout": 1.0}),
        (grasp.force_efficiency, {"wrenches": wrenches, "Q": sets.Ball(3), **SEARCH}),
    ]


class Stranger:
    """Has a dimension and a support function, but no sensible ones."""

    dimension = "two"

    def support(self, u: object) -> str:
        return f"{u}"


class Impostor:
    """Says that it is a geometry."""

    __geo_interface__ = 7


JUNK: list[Any] = [
    None,
    True,
    -1,
    7,
    -1.5,
    math.nan,
    math.inf,
    -math.inf,
    1j,
    "junk",
    b"junk",
    object(),
    len,
    [],
    [[]],
    [None],
    ["junk"],
    [1, 2],
    [1, 2, 3],
    [1, [2]],
    [[1, 2, 3, 4]],
    [[math.nan] * 3],
    {"type": "Polygon"},
    {"type": "Point", "coordinates": [0, 0]},
    np.array("junk"),
    np.array([[1j, 2]]),
    np.zeros((2, 2, 2, 2)),
    np.array([None, None], dtype=object),
    np.full((4, 2), 1e300),
    [(0, 0), (1, 1), (1, 0), (0, 1)],
    Stranger(),
    Impostor(),
    [Stranger()],
    iter([1]),
]


def cases() -> list[Any]:
    return [
        pytest.param(k, name, id=f"{function.__name__}-{name}")
        for k, (function, arguments) in enumerate(calls())
        for name in arguments
    ]


def test_every_public_function_is_tried() -> None:
    tried = [function for function, _ in calls()]
    # A caller does not make these; they are made by a function above.
    made = {pdg.Batch, pdg.ConvexPieces, pdg.ConvexSeparators, sets.ConvexSet, sets.SupportSet}
    for module in (pdg, sets, grasp):
        for name in module.__all__:
            one = getattr(module, name)
            if inspect.isfunction(one) or (module is sets and one not in made):
                assert one in tried, name


@pytest.mark.parametrize(("k", "name"), cases())
def test_junk_is_refused_by_name(k: int, name: str) -> None:
    function, arguments = calls()[k]
    function(**arguments)
    refused = 0
    for junk in JUNK:
        try:
            function(**{**arguments, name: junk})
        except pdg.PdgError as error:
            refused += error.name.startswith(name)
            # Or another argument, where that one no longer fits.
            assert error.name.startswith(tuple(arguments)), (junk, error)
            assert str(error).startswith(error.name)
    assert refused >= len(JUNK) // 2


def test_one_tree() -> None:
    for name in pdg.__all__:
        one = getattr(pdg, name)
        if isinstance(one, type) and issubclass(one, Exception):
            assert issubclass(one, pdg.PdgError)
    assert issubclass(pdg.PdgError, ValueError)


@pytest.mark.parametrize(
    "body",
    [
        [(0, 0), (1, 1), (1, 0), (0, 1)],
        [(0, 0), (1, 1)],
        "POLYGON EMPTY",
        "POINT (1 2)",
        {"type": "Polygon"},
    ],
)
def test_a_broken_body_has_its_own_error(body: Any) -> None:
    with pytest.raises(pdg.BodyError) as caught:
        pdg.translational_depth(SQUARE, body)
    assert caught.value.name == "B"


def test_a_pose_out_of_range_has_its_own_error() -> None:
    huge = 3e150 * (np.array(SQUARE) - 1)
    with pytest.raises(pdg.PlacementError, match=r"pose\[1\]: places the body outside") as caught:
        pdg.translational_depth(huge, SQUARE, [(0, 0, 0), (0, 3e150, 0)])
    assert (caught.value.name, caught.value.index) == ("pose", 1)
    with pytest.raises(pdg.PlacementError) as caught:
        pdg.translational_depth(huge, SQUARE, (0, 3e150, 0))
    assert (caught.value.index, caught.value.value) == (None, (0.0, 3e150, 0.0))


def test_errors_pickle() -> None:
    error = pdg.BodyError("is broken", "A", 3, [1.0, 2.0])
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is pdg.BodyError
    assert str(again) == str(error) == "A[3]: is broken (got [1.0, 2.0])"
