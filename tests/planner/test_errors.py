"""All errors form one tree, keep what they say when they are copied, and print as one line."""

from __future__ import annotations

import pickle

import pytest

import planar_planner
from planar_planner import (
    CertificateError,
    CertificateRejected,
    OptionsError,
    OutputError,
    PlannerError,
    SceneError,
    VerificationTimeoutError,
    load_scene,
    verify_certificate,
)

ERRORS = [
    SceneError("is wrong", "start[2]", "nan", "a.json"),
    OptionsError("timeout must be positive, not -1"),
    OutputError("cannot write a.json: is a directory"),
    CertificateError("segments[0]", "is missing"),
    CertificateRejected("scene", "is not the one certified"),
    VerificationTimeoutError("the time limit of the verification is reached"),
]


def test_the_tree_is_complete() -> None:
    public = [getattr(planar_planner, name) for name in planar_planner.__all__]
    errors = {e for e in public if isinstance(e, type) and issubclass(e, Exception)}
    assert errors == {type(error) for error in ERRORS} | {PlannerError}
    assert all(issubclass(error, PlannerError) for error in errors)
    values = (SceneError, OptionsError, CertificateError, CertificateRejected)
    assert all(issubclass(error, ValueError) for error in values)
    assert issubclass(CertificateRejected, CertificateError)


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_errors_survive_pickling(error: PlannerError) -> None:
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error)
    assert str(again) == str(error)
    assert vars(again) == vars(error)


def test_a_rejection_is_told_from_a_certificate_that_cannot_be_read() -> None:
    with pytest.raises(CertificateError) as unreadable:
        verify_certificate("corner", {"format": "planar-planner/certificate"})
    assert not isinstance(unreadable.value, CertificateRejected)
    answer = planar_planner.solve("corner", certificate=True)
    with pytest.raises(CertificateRejected) as rejected:
        verify_certificate(load_scene("gear"), answer.certificate)
    assert (rejected.value.place, rejected.value.problem) == ("scene", "is not the one certified")
