"""Run time against error of d_Q(W): ``python bench/grasp_error_time.py``.

Ours, which bounds d_Q from both sides, beside the usual practice: friction cones with k edges, the
convex hull of their wrenches by Qhull (SciPy) and its nearest facet. Random force-closure grasps
of an ellipsoid with 3 to 6 point contacts, μ = 0.5, the L1 norm, six-dimensional wrenches, Q the
unit ball. The true value is our bracket at 1e-10, checked against a slow minimiser of h_A/h_Q.

Writes ``bench/results/grasp_error_time.csv`` and ``.png``. Exit status 1 if ours is not within
1e-5 of the true value in less time than the hull of cones with 8 edges takes, or a bracket is
wrong. ``--quick`` takes fewer grasps and no cones with 64 edges.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from functools import partial

from lib.provenance import print_provenance, use_one_core, write_csv
from parts.depth_accuracy.common import in_microseconds, timed
from parts.grasps import linearised, picture_error_time
from parts.grasps.grasps import random_grasps
from parts.grasps.minimiser import least_found
from parts.grasps.picture_error_time import OURS, Row
from pdg.grasp import Contact, force_efficiency, grasp_wrench_set

SEED = 11
CONTACTS = (3, 4, 5, 6)
EPS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
TRUTH = 1e-10
GOAL_ERROR, RIVAL_EDGES = 1e-5, 8
AGREEMENT = 1e-6  # of the minimiser with the bracket: it stops at kinks


def main() -> int:
    """Measure, print, write, draw."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer grasps, no 64 edges")
    quick = parser.parse_args().quick
    use_one_core()
    facts = print_provenance()
    facts["seed"] = str(SEED)
    edges = [k for k in linearised.EDGES if not quick or k < 64]
    rows: list[Row] = []
    failed: list[str] = []
    for contacts in CONTACTS:
        grasps = list(random_grasps(SEED, 3 if quick else 12, contacts))
        truths = [truth(grasp, failed) for grasp in grasps]
        for row in (
            *ours(contacts, grasps, truths, failed),
            *hulls(contacts, grasps, truths, edges),
        ):
            rows.append(row)
            print(
                f"{row.contacts} contacts {row.method:22} error {row.error:8.1e}, at most "
                f"{row.largest:8.1e}  {row.milliseconds:10.3f} ms",
                flush=True,
            )
    failed += slower(rows)
    suffix = "_quick" if quick else ""
    write_csv(f"grasp_error_time{suffix}.csv", facts, Row._fields, rows)
    picture_error_time.draw(rows, f"grasp_error_time{suffix}.png")
    for problem in failed:
        print(f"FAILED: {problem}")
    return int(bool(failed))


def truth(grasp: Sequence[Contact], failed: list[str]) -> float:
    """Return d_Q(W) to ten places."""
    found = force_efficiency(grasp_wrench_set(grasp, "l1"), None, TRUTH)
    least = least_found(grasp, found.direction)
    if not found.lower <= least * (1 + 1e-14) or least > found.upper * (1 + AGREEMENT):
        failed.append(f"bracket [{found.lower}, {found.upper}], but h_A/h_Q = {least}")
    return 0.5 * (found.lower + found.upper)


def ours(
    contacts: int, grasps: Sequence[list[Contact]], truths: Sequence[float], failed: list[str]
) -> Iterator[Row]:
    """Yield a row for each ε: errors of the lower bound, making the wrench set included."""
    for eps in EPS:
        errors, seconds = [], []
        for grasp, true in zip(grasps, truths, strict=True):
            found = force_efficiency(grasp_wrench_set(grasp, "l1"), None, eps)
            if not found.lower <= true + TRUTH or not true - TRUTH <= found.upper:
                failed.append(f"{true} is not in [{found.lower}, {found.upper}]")
            errors.append((true - found.lower) / true)
            seconds.append(timed(partial(solve, grasp, eps)))
        yield make_row(contacts, f"{OURS} {eps:.0e}", errors, seconds)


def solve(grasp: Sequence[Contact], eps: float) -> float:
    """Return the lower bound of d_Q(W), from contacts to answer."""
    return force_efficiency(grasp_wrench_set(grasp, "l1"), None, eps).lower


def hulls(
    contacts: int, grasps: Sequence[list[Contact]], truths: Sequence[float], edges: Sequence[int]
) -> Iterator[Row]:
    """Yield a row for each number of edges: errors of d_Q, making the edges included."""
    for k in edges:
        chosen = list(zip(grasps, truths, strict=True))[: 2 if k >= 64 else None]
        errors = [(true - linearised.efficiency(grasp, k)) / true for grasp, true in chosen]
        repetitions = 1 if k >= 64 else 3
        seconds = [timed(partial(linearised.efficiency, g, k), repetitions) for g, _ in chosen]
        yield make_row(contacts, f"Qhull, {k} edges", errors, seconds)


def make_row(contacts: int, method: str, errors: Sequence[float], seconds: Sequence[float]) -> Row:
    """Return medians and quartiles."""
    median, low, high = (us / 1e3 for us in in_microseconds(seconds))
    middle = sorted(errors)[len(errors) // 2]
    return Row(contacts, method, len(errors), middle, max(errors), median, low, high)


def slower(rows: Sequence[Row]) -> Iterator[str]:
    """Yield where ours is not within the goal sooner than the rival's hull is made."""
    for contacts in CONTACTS:
        here = [row for row in rows if row.contacts == contacts]
        (rival,) = (r for r in here if r.method == f"Qhull, {RIVAL_EDGES} edges")
        reached = [r for r in here if r.method.startswith(OURS) and r.largest <= GOAL_ERROR]
        time = min((r.milliseconds for r in reached), default=float("inf"))
        print(
            f"{contacts} contacts: {GOAL_ERROR:g} in {time:.2f} ms; {RIVAL_EDGES} edges in "
            f"{rival.milliseconds:.2f} ms, off by {rival.error:.1%}, at most {rival.largest:.1%}"
        )
        if time >= rival.milliseconds:
            yield f"{contacts} contacts: slower than {RIVAL_EDGES} edges"


if __name__ == "__main__":
    sys.exit(main())
