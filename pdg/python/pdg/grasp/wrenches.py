"""Sets of wrenches that a grasp can apply with unit contact forces, by their support functions.

Every primitive contact wrench set is the affine image of a ball, W_i = {c_i + M_i x : |x| ≤ 1}:
a segment, an ellipse or an ellipsoid in wrench space, with

    h_i(u) = c_i · u + |M_iᵀ u|,   attained at  c_i + M_i M_iᵀ u / |M_iᵀ u|.

For all contacts together, with the normal force as a contact force's magnitude ([GFE] Eqs. 3–5):

    norm   idle contacts    the set                       support function
    l1     allowed          conv(W_1 ∪ … ∪ W_m ∪ {0})     max(0, max h_i)
    l1     not              conv(W_1 ∪ … ∪ W_m)           max h_i
    linf   allowed          ⊕ conv(W_i ∪ {0})             Σ max(0, h_i)
    linf   not              ⊕ W_i                         Σ h_i

Table I of [GFE] is of "linf" with idle contacts; its Eq. 5 reads without.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pdg import _core
from pdg._gate import choice, flag
from pdg.errors import PdgError
from pdg.grasp import _gate
from pdg.grasp._gate import frozen
from pdg.grasp.contacts import Contact, contact_map
from pdg.sets import ConvexSet

ForceNorm = Literal["l1", "linf"]
"""How normal forces are limited: their sum is at most 1, or each of them is."""

_NORMS: tuple[ForceNorm, ...] = ("l1", "linf")


class WrenchSet(ConvexSet):
    """A grasp wrench set: wrenches with a total contact force of at most 1.

    A compiled `pdg.sets.ConvexSet` of its k coordinates. Made by `grasp_wrench_set` and
    `active_wrench_set`.

    Attributes
    ----------
    centres : ndarray of shape (m, k)
        c_i in coordinates of `basis`.
    axes : ndarray of shape (m, k, j)
        M_i in coordinates of `basis`; columns of zeros where a contact has fewer than j.
    norm : {"l1", "linf"}
        Unit sum, or unit largest, of the normal forces.
    idle : bool
        Whether a contact may push with less than its share.
    basis : ndarray of shape (D, k)
        Orthonormal columns that span the set's space; the identity for a whole wrench space. The
        wrench of coordinates x is ``basis @ x``: force, then torque/length about the frame's
        origin; D = 6, or 3 in the plane.
    """

    __slots__ = ("axes", "basis", "centres", "idle", "norm")

    def __init__(
        self,
        centres: NDArray[np.float64],
        axes: NDArray[np.float64],
        norm: ForceNorm,
        idle: bool,
        basis: NDArray[np.float64],
    ) -> None:
        columns = np.concatenate([centres[:, None, :], axes.transpose(0, 2, 1)], axis=1)
        self._native = _core.grasp_wrench_set(np.ascontiguousarray(columns), norm == "linf", idle)
        self.centres, self.axes, self.norm, self.idle = frozen(centres), frozen(axes), norm, idle
        self.basis = frozen(basis)
        self._arguments = (centres, axes, norm, idle, basis)  # read-only, so not copied


def grasp_wrench_set(
    contacts: Sequence[Contact], norm: ForceNorm = "linf", length: float = 1.0, idle: bool = True
) -> WrenchSet:
    """Return W, the wrenches that contacts can apply with a unit total force ([GFE] Eqs. 3–7).

    Parameters
    ----------
    contacts : sequence of Contact
        At least one; all in space or all in the plane. Contacts i of a hand are contacts i here.
    norm : {"linf", "l1"}
        "linf": every normal force is at most 1. "l1": their sum is at most 1.
    length : float
        Torques are divided by this length (the object's unit), so that wrenches are forces.
    idle : bool
        False: normal forces are exactly 1 each ("linf"), or sum to exactly 1 ("l1").

    Returns
    -------
    WrenchSet
        A convex set, as `pdg.penetration_distance` takes it.

    Raises
    ------
    PdgError
        For no contacts, contacts of both kinds of object, a length that is not positive, and an
        unknown norm.
    """
    contacts = _gate.all_of_kind(contacts, Contact, "contacts")
    scale, known = checked(contacts, norm, length, "contacts")
    space = 3 * (len(contacts[0].position) - 1)
    maps = [contact_map(contact, scale) for contact in contacts]
    centres = np.array([G[:, 0] for G in maps])
    axes = np.array([G[:, 1:] * c.limits for G, c in zip(maps, contacts, strict=True)])
    return WrenchSet(centres, axes, known, flag(idle, "idle"), np.eye(space))


def checked(
    contacts: Sequence[Contact], norm: object, length: float, name: str
) -> tuple[float, ForceNorm]:
    """Return length and norm if they and the contacts, an argument of that name, fit together."""
    known = choice(norm, _NORMS, "norm")
    if len(contacts) == 0:
        raise PdgError("a grasp needs at least one", name, value=0)
    for i, contact in enumerate(contacts):
        if len(contact.position) != len(contacts[0].position):
            problem = "contacts in space and in the plane do not mix"
            raise PdgError(problem, name, i, contact.position.tolist())
    return _gate.positive(length, "length"), known
