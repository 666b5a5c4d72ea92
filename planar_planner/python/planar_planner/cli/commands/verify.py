"""`planar-planner verify`: check a certificate, and report what it proves or where it fails."""

from __future__ import annotations

import argparse
import dataclasses
import sys
import time
from typing import Any

from planar_planner.cli.arguments.importing import add_importing, scene_of
from planar_planner.cli.arguments.shared import add_command, add_json, add_scene, real_number
from planar_planner.cli.json_output import json_output
from planar_planner.cli.progress import Progress
from planar_planner.cli.terminal import VERDICT_STYLES, styled
from planar_planner.cli.time_limit import OutOfTimeError, time_limit
from planar_planner.errors import CertificateError, CertificateRejected, one_line
from planar_planner.output_files import complain, emit

TIMEOUT = 600.0
"""Seconds. The certificates of the shipped scenes take some seconds at most."""

_VERDICTS = {"path": "path", "no_path": "no path"}
_STYLES = {"valid": VERDICT_STYLES["path"], "rejected": VERDICT_STYLES["no_path"]}


def add(commands: Any) -> None:
    """Add the command."""
    verify = add_command(
        commands,
        "verify",
        "check a certificate in exact arithmetic, without the planner",
        examples=(
            "solve gear-jammed --certificate jammed.json.gz",
            "verify gear-jammed jammed.json.gz",
        ),
        status="0 valid, 1 rejected, 2 unreadable, or bad input or usage, 3 out of time",
    )
    add_scene(verify)
    verify.add_argument("certificate", metavar="CERT", help="a file that solve --certificate wrote")
    add_importing(verify)
    add_json(verify, "the finding")
    verify.add_argument(  # not that of the other commands, whose defaults are the planner's
        "--contact-tolerance",
        type=real_number,
        metavar="LENGTH",
        default=0.0,
        help="how far the ends of a path may have been moved off contact (default: %(default)g)",
    )
    verify.add_argument(
        "--timeout",
        type=real_number,
        metavar="SECONDS",
        default=TIMEOUT,
        help="time of the check, or inf (default: %(default)g)",
    )
    verify.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Verify, then report: 0 valid, 1 rejected, 2 unreadable, 3 out of time."""
    output = json_output(arguments.json)
    scene = scene_of(arguments, arguments.scene)
    with Progress(sys.stderr, "checking the certificate"):
        status, finding = _finding(scene, arguments)
    arguments.stated.status = status
    if status in (2, 3) and not output.to_stdout:
        complain(f"{arguments.certificate}: {finding['problem']}")
    elif not output.to_stdout:
        emit(_headline(finding))
    output.write(finding)
    return status


def _finding(scene: Any, arguments: argparse.Namespace) -> tuple[int, dict[str, Any]]:
    """Return the exit status, and the finding as JSON."""
    from planar_planner.checker.verify import verify_certificate  # takes numpy

    began = time.monotonic()
    common = {"format": "planar-planner/verification", "version": 1, "scene": scene.name}
    try:
        with time_limit(arguments.timeout):
            proven = dataclasses.asdict(
                verify_certificate(scene, arguments.certificate, arguments.contact_tolerance)
            )
    except CertificateRejected as found:
        status, content = 1, {"claim": one_line(found.place), "problem": one_line(found.problem)}
    except CertificateError as found:
        status, content = 2, {"claim": "", "problem": one_line(str(found))}
    except OutOfTimeError:
        status, content = 3, {"claim": "", "problem": "time limit reached; see --timeout"}
    except MemoryError:
        status, content = 2, {"claim": "", "problem": "is too large for the memory"}
    else:
        status, content = 0, proven
    content |= scene.imported.to_json()
    finding = ("valid", "rejected", "unreadable", "undecided")[status]
    seconds = round(time.monotonic() - began, 3)
    return status, common | {"finding": finding} | content | {"seconds": seconds}


def _headline(finding: dict[str, Any]) -> str:
    if finding["finding"] == "rejected":
        rejected = styled("rejected", _STYLES["rejected"], sys.stdout)
        return f"{rejected}: {finding['claim']}: {finding['problem']}"
    tolerance = finding["contact_tolerance"]
    moved = f", its ends within {tolerance:g} of start and goal" if tolerance else ""
    proof = "" if finding["proof"] == "path" else f" ({finding['proof']})"
    valid = styled("valid", _STYLES["valid"], sys.stdout)
    return (
        f"{valid}: {_VERDICTS[finding['verdict']]}{proof}{moved}\n"
        f"{finding['claims']} claims checked in {finding['seconds']:.2f} s"
    )
