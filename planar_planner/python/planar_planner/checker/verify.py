"""The checker of certificates: docs/certificate.md as code.

Whatever it accepts is an inequality between integers, and `demand` is its only way to reject (but
`find`, for names of nothing).
"""

from __future__ import annotations

from typing import NamedTuple

from planar_planner.checker.absence import check_disc, check_end, check_separation
from planar_planner.checker.case import check_pieces, demand, make_case
from planar_planner.checker.form import Source, read_certificate
from planar_planner.checker.path import check_path
from planar_planner.load import load_scene
from planar_planner.problem.fingerprint import fingerprint
from planar_planner.problem.make import make_problem
from planar_planner.problem.rings import judged_by_geos
from planar_planner.scene.model import Scene


class Report(NamedTuple):
    """What a valid certificate proves."""

    verdict: str  # "path" or "no_path"
    proof: str  # "path", "separation", "disc" or "end"
    contact_tolerance: float  # the path's ends may be so far from start and goal
    claims: int  # that were checked: boxes, faces, pairs on intervals


def verify_certificate(
    scene: Source | Scene, certificate: Source, contact_tolerance: float = 0.0
) -> Report:
    """Check a certificate against a scene, in exact arithmetic.

    Parameters
    ----------
    scene : Scene, str, path or mapping
        A loaded scene, or anything that `load_scene` takes.
    certificate : str, path or mapping
        A file (docs/certificate.md), or its content.
    contact_tolerance : float, optional
        A path may begin and end off contact by this length, if the certificate says so.

    Returns
    -------
    Report
        What is proven: ``verdict``, ``proof``, ``contact_tolerance`` and ``claims``, their number.

    Raises
    ------
    SceneError
        If the scene is not valid.
    CertificateError
        If the certificate cannot be read.
    CertificateRejected
        If it does not prove what it claims.
    """
    problem = make_problem(scene if isinstance(scene, Scene) else load_scene(scene), judged_by_geos)
    content = read_certificate(certificate)
    case = make_case(problem, content)
    tolerance, proof = content.get("contact_tolerance", 0.0), content.get("claim", "path")
    demand(content["scene"] == fingerprint(problem), "scene", "is not the one certified")
    demand(0 <= tolerance <= contact_tolerance, "contact_tolerance", "is more than allowed")
    check_pieces(case, content)
    proofs = {"separation": check_separation, "disc": check_disc, "end": check_end}
    claims = proofs.get(proof, check_path)(case, content)
    return Report(content["verdict"], proof, tolerance, claims)
