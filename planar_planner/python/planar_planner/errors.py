"""The errors that a caller can cause; all are `PlannerError`, and each prints as one line."""

from __future__ import annotations

import reprlib

_SHORT = reprlib.Repr()
_SHORT.maxlevel = 3  # nested lists are cut, so that no value can exhaust the stack
_SHORT.maxlist = _SHORT.maxdict = 6
_SHORT.maxstring = _SHORT.maxother = _SHORT.maxlong = 60


def shown(value: object) -> str:
    """Return `value` as it may appear in a message: on one line and cut to a readable length."""
    try:
        return _SHORT.repr(value)
    except ValueError:  # an integer of more digits than Python prints
        return "a value that is too long to print"


def cut(name: str) -> str:
    """Return a name from a file, shortened if it is absurdly long."""
    return name if len(name) <= 60 else f"{name[:57]}..."


def one_line(text: str) -> str:
    """Return `text` with every unprintable character escaped, line breaks included."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


class PlannerError(Exception):
    """What a scene, an option, a certificate or a file can cause: the root of all these errors."""


class SceneError(PlannerError, ValueError):
    """A scene that cannot be planned on, with the place and the value that are wrong.

    Attributes
    ----------
    problem : str
        What is wrong, and what is expected instead.
    field : str
        Where, from the top of the scene: ``obstacles[3].coordinates[0][2]``. Empty for the whole.
    value : str
        The offending value as text, shortened. Empty when there is none to show.
    source : str
        File, built-in name or ``<dict>`` that the scene came from. Empty until it is known.
    """

    def __init__(self, problem: str, field: str = "", value: str = "", source: str = "") -> None:
        super().__init__(problem, field, value, source)
        self.problem = problem
        self.field = field
        self.value = value
        self.source = source

    def in_source(self, source: str) -> SceneError:
        """Return the same error with the file it was found in."""
        return SceneError(self.problem, self.field, self.value, source)

    def __str__(self) -> str:
        place = ": ".join(part for part in (self.source, self.field) if part)
        got = f" (got {self.value})" if self.value else ""
        return one_line(f"{place}: {self.problem}{got}" if place else f"{self.problem}{got}")


class OptionsError(PlannerError, ValueError):
    """A limit or tolerance outside its legal range."""


class OutputError(PlannerError):
    """A file or stream that cannot be written."""


class VerificationTimeoutError(PlannerError):
    """A verification that has reached its time limit: it says nothing of the certificate."""


class CertificateError(PlannerError, ValueError):
    """A certificate that cannot be read, or that is rejected.

    Attributes
    ----------
    place : str
        Where, from the top of the certificate: ``segments[0][1].apart[3]``. Empty for the whole.
    problem : str
        What is wrong there, and what is expected instead.
    """

    def __init__(self, place: str, problem: str) -> None:
        super().__init__(place, problem)
        self.place = place
        self.problem = problem

    def __str__(self) -> str:
        return ": ".join(part for part in (self.place, self.problem) if part)


class CertificateRejected(CertificateError):  # noqa: N818  (the base says that it is an error)
    """A certificate with a claim that is false, or that proves less than it claims."""
