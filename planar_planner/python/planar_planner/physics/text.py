"""The results of a replay and of a push, as text for people."""

from __future__ import annotations

from planar_planner.errors import one_line
from planar_planner.physics.report import Push, Replay, Try

MOST_CONTACTS = 5  # the text lists this many; the JSON has all


def replay_text(found: Replay) -> str:
    """Return the finding and its numbers, the finding on the first line."""
    lines = [
        replay_headline(found),
        f"  {len(found.configurations):,} configurations, {found.step:.3g} of travel apart: "
        f"no penetration deeper than {found.step / 2:.3g} can be missed between them",
        f"  deepest penetration {found.deepest:.3g}; up to {found.allowed:.2g} is contact "
        f"({'your tolerance' if found.tolerance > found.accuracy else 'rounding in Chipmunk'})",
    ]
    for contact in found.contacts[:MOST_CONTACTS]:
        x, y, theta = contact.configuration
        lines.append(
            f"  {contact.what}: contact in {contact.count:,} configurations, deepest "
            f"{contact.depth:.3g} at ({x:.6g}, {y:.6g}, {theta:.6g})"
        )
    if len(found.contacts) > MOST_CONTACTS:
        lines.append(f"  and {len(found.contacts) - MOST_CONTACTS:,} more in contact")
    if found.doubted:
        lines.append(
            f"  in {found.doubted:,} configurations Chipmunk's answers differed a billionth of the "
            "reach away, and the median of nine answers counts"
        )
    lines.append(f"  {found.engine}")
    return "\n".join(lines)


def replay_headline(found: Replay) -> str:
    """Return the finding in one line."""
    faults = []
    if found.deepest > found.allowed:
        faults.append(f"{found.contacts[0].what} is penetrated by {found.deepest:.3g}")
    if found.outside > found.allowed:
        faults.append(f"the reference point leaves its bounds by {found.outside:.3g}")
    if not found.joins:
        faults.append(
            f"the path is off start and goal by {found.start_gap:.3g} and {found.goal_gap:.3g}"
        )
    if faults:
        return one_line(f"{found.scene}: not confirmed: {'; '.join(faults)}")
    touching = ", touching" if found.contacts else ""
    return one_line(f"{found.scene}: confirmed: from start to goal without collision{touching}")


def push_text(found: Push) -> str:
    """Return the finding and its numbers, the finding on the first line."""
    lines = [push_headline(found)]
    lines += [f"  {_try_line(found, number, run)}" for number, run in enumerate(found.tries)]
    lines.append(
        f"  in a step of {found.time_step:.3g} s a point moves at most {found.step:.3g}; "
        f"passing the thinnest piece requires {found.thinnest:.3g}"
    )
    lines.append(f"  {found.engine}")
    return "\n".join(lines)


def push_headline(found: Push) -> str:
    """Return the finding in one line."""
    name, count = found.scene, len(found.tries)
    if found.may_have_tunnelled:
        return one_line(
            f"{name}: says nothing: a robot was {found.deepest:.3g} deep in an obstacle, and may "
            "have passed through it"
        )
    if found.reached_free:
        return one_line(f"{name}: a robot reached the goal without collision")
    if found.reached:
        return one_line(
            f"{name}: says nothing: a robot reached the goal, but was {found.deepest:.3g} deep in "
            "obstacles, since simulated contact is soft"
        )
    robots = "the robot" if count == 1 else f"none of {count} robots"
    return one_line(f"{name}: {robots} {'did not reach' if count == 1 else 'reached'} the goal")


def _try_line(found: Push, number: int, run: Try) -> str:
    end = "reached the goal" if run.reached else f"{run.nearest:.3g} of {found.distance:.3g} left"
    bounds = f", out of bounds by {run.outside:.3g}" if run.outside else ""
    undone = f", {run.undone:,} steps undone" if run.undone else ""
    return (
        f"try {number}: {run.seconds:.3g} s, {run.length:.3g} of travel, {run.farthest:.3g} "
        f"from the start; {end}; deepest penetration {run.deepest:.3g}{bounds}{undone}"
    )
