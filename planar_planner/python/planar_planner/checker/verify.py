"""A certificate against a scene: the order of the checks.

Whatever is accepted is an inequality between integers. A certificate is rejected by `demand`, by
`find` for a name of nothing, and by `check_end` for a region.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from planar_planner import certificate_keys as keys
from planar_planner.checker.absence import check_chain, check_disc, check_end
from planar_planner.checker.case import Case, make_case
from planar_planner.checker.demands import NO_DEADLINE, Deadline, demand
from planar_planner.checker.form import Source, read_certificate
from planar_planner.checker.path import check_path
from planar_planner.checker.records import ChainProof, DiscProof, PathProof, Proof, Separation
from planar_planner.checker.separation import check_separation
from planar_planner.errors import OptionsError
from planar_planner.load import load_scene
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.make import Problem, make_problem
from planar_planner.problem.rings import judged_by_geos
from planar_planner.scene.model import Scene


@dataclass(frozen=True)
class Verification:
    """What a valid certificate proves.

    Attributes
    ----------
    verdict : str
        ``"path"`` or ``"no_path"``.
    proof : str
        ``"path"``, ``"separation"``, ``"disc"``, ``"odd_chain"`` or ``"end"``
        (docs/certificate.md).
    contact_tolerance : float
        The path's ends may be so far from start and goal, in the scene's unit of length.
    claims : int
        How many boxes, faces, and pairs on intervals were checked.
    decimal_places : int or None
        It holds for the scene's lengths as decimals of so many places; None: as doubles.
    """

    verdict: str
    proof: str
    contact_tolerance: float
    claims: int
    decimal_places: int | None = None


def verify_certificate(
    scene: Source | Scene,
    certificate: Source,
    contact_tolerance: float = 0.0,
    timeout: float = math.inf,
) -> Verification:
    """Check a certificate against a scene, in exact arithmetic.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    certificate : str, path or mapping
        A file (docs/certificate.md), or its content.
    contact_tolerance : float, optional
        Length by which the ends of a path may be off start and goal, if the certificate says so.
    timeout : float, optional
        Seconds of the checks; reading is limited by the size of the file (docs/certificate.md).

    Returns
    -------
    Verification
        What is proven.

    Raises
    ------
    SceneError
        If the scene is not valid.
    CertificateRejected
        If the certificate does not prove what it claims.
    CertificateError
        If it cannot be read. `CertificateRejected` is one of these, so catch that first.
    OptionsError
        If the contact tolerance is negative or not finite, or the timeout is not positive.
    VerificationTimeoutError
        If the timeout is reached.
    """
    if not (contact_tolerance >= 0 and math.isfinite(contact_tolerance)):
        raise OptionsError(
            f"contact_tolerance must be finite and not negative, not {contact_tolerance!r}"
        )
    if not timeout > 0:
        raise OptionsError(f"timeout must be positive, not {timeout!r}")
    deadline = Deadline(timeout)
    problem = make_problem(scene if isinstance(scene, Scene) else load_scene(scene), judged_by_geos)
    return verify_problem(problem, certificate, contact_tolerance, deadline)


def verify_problem(
    problem: Problem,
    certificate: Source,
    contact_tolerance: float = 0.0,
    deadline: Deadline = NO_DEADLINE,
) -> Verification:
    """Check a certificate against a problem, which is valid; see `verify_certificate`."""
    content = read_certificate(certificate)
    demand(content.scene == fingerprint(problem), keys.SCENE, "is not the one certified")
    proven = _checked(make_case(problem, content, deadline), content.proof, contact_tolerance)
    return replace(proven, decimal_places=content.decimal_places)


def _checked(case: Case, proof: Proof, contact_tolerance: float) -> Verification:
    if isinstance(proof, PathProof):
        allowed = 0 <= proof.contact_tolerance <= contact_tolerance
        demand(allowed, keys.CONTACT_TOLERANCE, "is more than allowed")
        claims = check_path(case, proof)
        return Verification(keys.PATH, keys.PATH, proof.contact_tolerance, claims)
    if isinstance(proof, Separation):
        claims = check_separation(case, proof)
        return Verification(keys.NO_PATH, keys.SEPARATION_CLAIM, 0.0, claims)
    if isinstance(proof, DiscProof):
        claims = check_disc(case, proof)
        return Verification(keys.NO_PATH, keys.DISC_CLAIM, 0.0, claims)
    if isinstance(proof, ChainProof):
        return Verification(keys.NO_PATH, keys.CHAIN_CLAIM, 0.0, check_chain(case, proof))
    return Verification(keys.NO_PATH, keys.END_CLAIM, 0.0, check_end(case, proof))
