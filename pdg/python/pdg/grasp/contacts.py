"""Contacts of a grasp, in the object's frame, and the forces that friction lets them carry.

Glossary: n inward unit normal, o and t unit tangents with n = o × t, f = (f_1, f_2, f_3, f_4) the
force along n, o, t and the moment about n, μ and μ_s the coefficients of friction, F the friction
cone, U = {f ∈ F : f_1 = 1}, G the contact map from f to the wrench on the object.

Source: [GFE] Zheng, Yamane, *Evaluation of Grasp Force Efficiency …*, 2013, section II.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pdg.errors import PdgError
from pdg.grasp import _gate
from pdg.tolerances import LEAST_TANGENT_SINE

ContactKind = Literal["frictionless", "point", "soft"]
"""Which forces a contact carries."""


@dataclass(frozen=True, slots=True, eq=False)
class Contact:
    """One contact on a solid (d = 3) or on a planar object (d = 2). Made by the functions below.

    Attributes
    ----------
    kind : {"frictionless", "point", "soft"}
        Which forces it carries; see `frictionless`, `point_contact`, `soft_finger`.
    position : ndarray of shape (d,)
        In the object's frame and unit of length; torques are taken about that frame's origin.
    normal : ndarray of shape (d,)
        Unit vector into the object.
    tangents : ndarray of shape (d - 1, d)
        Rows o and t, so that (n, o, t) is right-handed; in the plane o alone, n turned by +90°.
    friction : float
        μ: largest tangential force at a normal force of 1. 0 if frictionless.
    torsion : float
        μ_s: largest moment about the normal at a normal force of 1; a length. 0 unless soft.
    """

    kind: ContactKind
    position: NDArray[np.float64]
    normal: NDArray[np.float64]
    tangents: NDArray[np.float64]
    friction: float
    torsion: float

    @property
    def limits(self) -> NDArray[np.float64]:
        """Semi-axes of U about f = (1, 0, …): (μ, μ, μ_s), or (μ,) in the plane."""
        if len(self.position) == 2:
            return np.array([self.friction])
        return np.array([self.friction, self.friction, self.torsion])


def frictionless(position: ArrayLike, normal: ArrayLike) -> Contact:
    """Return a contact that only pushes along its normal.

    Parameters
    ----------
    position : array_like of shape (3,) or (2,)
        In the object's frame.
    normal : array_like of the same shape
        Direction into the object, of any length.

    Returns
    -------
    Contact
        Its normal is a unit vector.

    Raises
    ------
    PdgError
        For wrong shapes, numbers that are not finite, and a zero normal.
    """
    return _contact("frictionless", position, normal, 0.0, 0.0, tangent=None)


def point_contact(
    position: ArrayLike, normal: ArrayLike, friction: float, tangent: ArrayLike | None = None
) -> Contact:
    """Return a point contact with Coulomb friction: √(f_2² + f_3²) ≤ μ f_1.

    Parameters
    ----------
    position, normal : array_like
        As for `frictionless`.
    friction : float
        μ ≥ 0.
    tangent : array_like of shape (3,), optional
        Direction whose part perpendicular to the normal is o. By default o is perpendicular to
        the coordinate axis that is farthest from the normal. No result depends on the choice but
        the components of contact forces. Not for planar contacts.

    Returns
    -------
    Contact
        With unit normal and tangents.

    Raises
    ------
    PdgError
        As `frictionless`; also for a friction that is negative or not finite, and a tangent along
        the normal.
    """
    mu = _gate.coefficient(friction, "friction")
    return _contact("point", position, normal, mu, 0.0, tangent=tangent)


def soft_finger(
    position: ArrayLike,
    normal: ArrayLike,
    friction: float,
    torsion: float,
    tangent: ArrayLike | None = None,
) -> Contact:
    """Return an elliptic soft-finger contact: √((f_2² + f_3²)/μ² + f_4²/μ_s²) ≤ f_1 ([GFE] Eq. 1).

    Parameters
    ----------
    position, normal : array_like of shape (3,)
        As for `frictionless`; there are no soft contacts in the plane.
    friction : float
        μ ≥ 0.
    torsion : float
        μ_s ≥ 0, a length: largest moment about the normal at a normal force of 1.
    tangent : array_like of shape (3,), optional
        As for `point_contact`.

    Returns
    -------
    Contact
        With unit normal and tangents.

    Raises
    ------
    PdgError
        As `point_contact`.
    """
    mu, mu_s = _gate.coefficient(friction, "friction"), _gate.coefficient(torsion, "torsion")
    contact = _contact("soft", position, normal, mu, mu_s, tangent=tangent)
    if len(contact.position) == 2:
        raise PdgError("a soft finger needs a contact in space", "position", value=(2,))
    return contact


def contact_map(contact: Contact, length: float = 1.0) -> NDArray[np.float64]:
    """Return G, the map from contact forces to wrenches (force, torque/length) on the object.

    Parameters
    ----------
    contact : Contact
        In the object's frame.
    length : float, optional
        Torques are divided by it.

    Returns
    -------
    ndarray of shape (6, 4), or (3, 2) in the plane
        In space: columns (n, p × n), (o, p × o), (t, p × t), (0, n) ([GFE] Eq. 2), the lower three
        rows divided by `length`.
    """
    n, p = _gate.one_of_kind(contact, Contact, "contact").normal, contact.position
    length = _gate.positive(length, "length")
    if len(p) == 2:
        (o,) = contact.tangents
        columns = [[*d, (p[0] * d[1] - p[1] * d[0]) / length] for d in (n, o)]
        return np.array(columns).T
    o, t = contact.tangents
    forces = [np.concatenate([d, np.cross(p, d) / length]) for d in (n, o, t)]
    return np.column_stack([*forces, np.concatenate([np.zeros(3), n / length])])


def _contact(
    kind: ContactKind,
    position: ArrayLike,
    normal: ArrayLike,
    mu: float,
    mu_s: float,
    *,
    tangent: ArrayLike | None,
) -> Contact:
    p = _gate.vector(position, "position", (2, 3))
    n = _gate.unit(normal, "normal", len(p))
    if len(p) == 2:
        if tangent is not None:
            raise PdgError("a planar contact has only one tangent", "tangent", value=tangent)
        tangents = np.array([[-n[1], n[0]]])
    else:
        tangents = _tangents(n, tangent)
    return Contact(kind, p, n, _gate.frozen(tangents), mu, mu_s)


def _tangents(n: NDArray[np.float64], tangent: ArrayLike | None) -> NDArray[np.float64]:
    """Rows o and t = n × o, hence n = o × t."""
    if tangent is None:
        o = np.cross(np.eye(3)[int(np.argmin(np.abs(n)))], n)
    else:
        wanted = _gate.unit(tangent, "tangent", 3)
        o = wanted - (n @ wanted) * n
        if np.linalg.norm(o) < LEAST_TANGENT_SINE:
            raise PdgError("must not be along the normal", "tangent", value=wanted.tolist())
        o = o - (n @ o) * n  # once more: the first difference may have cancelled
    o = o / np.linalg.norm(o)
    return np.array([o, np.cross(n, o)])
