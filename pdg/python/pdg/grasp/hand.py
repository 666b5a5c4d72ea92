"""Hands: fingers with one contact each, their Jacobians, and the wrenches their joints can make.

Glossary beside that of `pdg.grasp.contacts`: J Jacobian from a finger's independent joint rates to
the velocity of its tip in the contact's frame (along n, o, t, and the spin about n), τ joint
torques with τ = Jᵀ f ([GFE] Eq. 9), C coupling from independent to all joint rates.

Source: [GFE] section III.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pdg._gate import choice, flag, items
from pdg.errors import PdgError
from pdg.grasp import _gate
from pdg.grasp.active_forces import ActiveForces, active_forces, column_space
from pdg.grasp.contacts import Contact, contact_map
from pdg.grasp.wrenches import ForceNorm, WrenchSet, checked

JointMode = Literal["active", "locked", "free"]
"""What moves an independent joint rate: a motor, nothing (it is held), or anything but a motor."""

_MODES: tuple[JointMode, ...] = ("active", "locked", "free")

JointKind = Literal["revolute", "prismatic"]
"""Whether a joint turns or slides."""


@dataclass(frozen=True, slots=True, eq=False)
class Joint:
    """One joint in its present pose, in the object's frame. Made by `revolute` and `prismatic`.

    Attributes
    ----------
    kind : {"revolute", "prismatic"}
        Whether it turns or slides.
    axis : ndarray of shape (3,) or (2,)
        Unit vector along which it slides or about which it turns; in the plane a revolute joint
        turns anticlockwise and its axis is zero.
    point : ndarray of the same shape
        A point of a revolute joint's axis; zero for a prismatic joint.
    """

    kind: JointKind
    axis: NDArray[np.float64]
    point: NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Finger:
    """A finger that touches the object at its tip. Made by `finger`.

    Attributes
    ----------
    contact : Contact
        Where and how it touches.
    jacobian : ndarray of shape (4, q), or (2, q) in the plane
        J, a column for each independent motion that is not locked.
    free : tuple of bool
        For each column whether no motor acts on it: its torque is zero.
    reach : tuple of float
        Speed and spin of the tip that unit rates could give if no arm were short and no axis
        perpendicular: what rounding in J is relative to.
    """

    contact: Contact
    jacobian: NDArray[np.float64]
    free: tuple[bool, ...]
    reach: tuple[float, float]


def revolute(point: ArrayLike, axis: ArrayLike | None = None) -> Joint:
    """Return a joint that turns about the line through `point` along `axis`.

    Parameters
    ----------
    point : array_like of shape (3,), or (2,) in the plane
        In the object's frame.
    axis : array_like of shape (3,)
        Direction of any length; not for the plane.

    Returns
    -------
    Joint
        Its axis is a unit vector.

    Raises
    ------
    PdgError
        For wrong shapes, numbers that are not finite, a zero axis, or an axis in the plane.
    """
    p = _gate.vector(point, "point", (2, 3))
    if len(p) == 3:
        return Joint("revolute", _gate.unit(axis, "axis", 3), p)
    if axis is not None:
        raise PdgError("a planar revolute joint has no axis to choose", "axis", value=axis)
    return Joint("revolute", _gate.frozen(np.zeros(2)), p)


def prismatic(axis: ArrayLike) -> Joint:
    """Return a joint that slides along `axis`.

    Parameters
    ----------
    axis : array_like of shape (3,), or (2,) in the plane
        Direction of any length.

    Returns
    -------
    Joint
        Its axis is a unit vector.

    Raises
    ------
    PdgError
        For wrong shapes, numbers that are not finite, and a zero axis.
    """
    direction = _gate.vector(axis, "axis", (2, 3))
    size = len(direction)
    return Joint("prismatic", _gate.unit(direction, "axis", size), _gate.frozen(np.zeros(size)))


def finger(
    contact: Contact,
    joints: Sequence[Joint],
    coupling: ArrayLike | None = None,
    modes: Sequence[JointMode] | None = None,
) -> Finger:
    """Return a finger from its joints in their present pose.

    Parameters
    ----------
    contact : Contact
        At the fingertip.
    joints : sequence of Joint
        q joints between palm and tip, in any order.
    coupling : array_like of shape (q, a), optional
        C: joint rates are C times a independent rates; a column (…, 1, 1)ᵀ couples two joints one
        to one. By default every joint is independent.
    modes : sequence of {"active", "locked", "free"}, optional
        Mode of each independent rate: driven by a motor, held, or moved by nothing (its torque
        is zero: an under-actuated finger). By default all are active.

    Returns
    -------
    Finger
        With its Jacobian in the contact's frame.

    Raises
    ------
    PdgError
        For shapes that do not fit together, numbers that are not finite and unknown modes.
    """
    size = len(_gate.one_of_kind(contact, Contact, "contact").position)
    joints = _gate.all_of_kind(joints, Joint, "joints")
    for i, joint in enumerate(joints):
        if len(joint.axis) != size:
            problem = "joints and contact must both be in space or both in the plane"
            raise PdgError(problem, "joints", i, joint.axis.tolist())
    C = np.eye(len(joints)) if coupling is None else _gate.array(coupling, "coupling")
    if C.ndim != 2 or C.shape[0] != len(joints):
        problem = f"expected an array of shape ({len(joints)}, a)"
        raise PdgError(problem, "coupling", value=C.shape)
    states = _modes(("active",) * C.shape[1] if modes is None else modes, C.shape[1])
    moving = [i for i, state in enumerate(states) if state != "locked"]
    J = np.zeros((2 * size - 2, len(joints)))
    for i, joint in enumerate(joints):
        J[:, i] = _tip_velocity(contact, joint)
    free = tuple(states[i] == "free" for i in moving)
    return Finger(contact, _gate.frozen((J @ C)[:, moving]), free, _reach(contact, joints, C))


def finger_forces(finger: Finger, length: float = 1.0) -> ActiveForces:
    """Return the contact forces that a finger's motors make and that friction allows.

    Parameters
    ----------
    finger : Finger
        Made by `finger`.
    length : float
        The active space range(J) ([GFE] Eq. 10) is perpendicular to the passive one, and what is
        perpendicular depends on the unit of length where forces and moments mix: f_4 enters
        divided by `length`. 1 is as published.

    Returns
    -------
    ActiveForces
        Components in the contact's frame, moments in force × length.
    """
    finger = _gate.one_of_kind(finger, Finger, "finger")
    scale = _gate.positive(length, "length")
    rows = _scales(finger.contact, scale)
    speed, spin = finger.reach
    forces = active_forces(
        finger.jacobian * rows[:, None],
        finger.free,
        finger.contact.limits / rows[1:],
        max(speed, spin * scale),
    )
    return ActiveForces(
        forces.case,
        forces.rank,
        forces.discriminant,
        forces.offset * rows,
        forces.shape * rows[:, None],
        forces.active * rows[:, None],
        forces.passive * rows[:, None],
    )


def active_wrench_set(
    fingers: Sequence[Finger], norm: ForceNorm = "linf", length: float = 1.0, idle: bool = True
) -> WrenchSet | None:
    """Return W^a, the wrenches that joint torques alone can make, in its minimal subspace.

    W^a is made as W is, of G_i(U_i^a) in place of G_i(U_i) ([GFE] Eqs. 9–15). A finger without
    any active force within friction adds nothing.

    Parameters
    ----------
    fingers : sequence of Finger
        At least one, all of one kind of object.
    norm, length, idle : as of `grasp_wrench_set`
        As for `grasp_wrench_set`; `length` also as for `finger_forces`.

    Returns
    -------
    WrenchSet or None
        Its `basis` spans the minimal subspace; where coordinate axes of wrench space span that, it
        is these. None if no finger has an active force. Ranks are decided in plain doubles, see
        `pdg.tolerances.RANK_TOLERANCE`.

    Raises
    ------
    PdgError
        As `grasp_wrench_set`.
    """
    fingers = _gate.all_of_kind(fingers, Finger, "fingers")
    scale, known = checked([one.contact for one in fingers], norm, length, "fingers")
    centres, axes = [], []
    for one in fingers:
        forces = finger_forces(one, scale)
        if forces.case == "none":
            continue
        G = contact_map(one.contact, scale)
        centres.append(G @ forces.offset)
        axes.append(G @ forces.shape)
    if not centres:
        return None
    R = minimal_basis(np.column_stack([np.column_stack(centres), *axes]))
    most = max(M.shape[1] for M in axes)
    padded = [np.pad(R.T @ M, ((0, 0), (0, most - M.shape[1]))) for M in axes]
    return WrenchSet(np.array(centres) @ R, np.array(padded), known, flag(idle, "idle"), R)


def minimal_basis(wrenches: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return orthonormal columns that span those of `wrenches`: coordinate axes if these do."""
    R = column_space(wrenches, float(np.linalg.norm(wrenches)))
    dominant = np.sort(np.argsort(-np.linalg.norm(R, axis=1), kind="stable")[: R.shape[1]])
    aligned = np.eye(len(R))[:, dominant]
    return aligned if column_space(np.hstack([R, aligned]), 1.0).shape[1] == R.shape[1] else R


def _modes(modes: Iterable[object], count: int) -> list[JointMode]:
    """Return the checked modes of so many joint rates."""
    states = items(modes, "modes")
    if len(states) != count:
        raise PdgError(f"expected {count} modes", "modes", value=len(states))
    return [choice(state, _MODES, "modes", i) for i, state in enumerate(states)]


def _tip_velocity(contact: Contact, joint: Joint) -> NDArray[np.float64]:
    """Column of J: what a unit rate of the joint does to the tip, in the contact's frame."""
    frame = np.vstack([contact.normal, contact.tangents])
    arm = contact.position - joint.point
    if len(arm) == 2:
        velocity = joint.axis if joint.kind == "prismatic" else np.array([-arm[1], arm[0]])
        return np.asarray(frame @ velocity)
    if joint.kind == "prismatic":
        return np.append(frame @ joint.axis, 0.0)
    return np.append(frame @ np.cross(joint.axis, arm), contact.normal @ joint.axis)


def _reach(
    contact: Contact, joints: Sequence[Joint], coupling: NDArray[np.float64]
) -> tuple[float, float]:
    """Speed and spin of `Finger.reach`."""
    arms = [
        1.0
        if joint.kind == "prismatic"
        else float(np.linalg.norm(contact.position) + np.linalg.norm(joint.point))
        for joint in joints
    ]
    turns = [float(joint.kind == "revolute") for joint in joints]
    rates = np.abs(coupling)
    return float((arms @ rates).max(initial=0.0)), float((turns @ rates).max(initial=0.0))


def _scales(contact: Contact, length: float) -> NDArray[np.float64]:
    """Return s with f = s g, where all components of g are forces: its moment is f_4/length."""
    return np.array([1.0, 1.0]) if len(contact.position) == 2 else np.array([1.0, 1.0, 1.0, length])
