"""A robot that random forces drive among the obstacles, simulated by Chipmunk.

Simulated contact gives way: a robot pressed against a wall is some fraction of a step inside it.
The step is so small that it cannot jump through a piece unseen, and the deepest penetration of all
steps is on record, so that whoever got somewhere by squeezing is told from whoever went freely.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from planar_planner.errors import OptionsError
from planar_planner.physics.contacts import find_contacts, touched
from planar_planner.physics.driver import SPEED, Driver
from planar_planner.physics.goals import nearest_goal, travel_between, travel_to_goal
from planar_planner.physics.replay import outside, problem_of
from planar_planner.physics.report import Push, Try
from planar_planner.physics.world import World, engine_name, make_world, rounding
from planar_planner.planning.path_samples import equal_steps, reach
from planar_planner.problem.make import Problem
from planar_planner.scene.fields import Configuration

if TYPE_CHECKING:
    from planar_planner.load import SceneLike

STEPS_PER_REACH = 256
STEPS_PER_WIDTH = 8
"""A point moves in a step by at most this part of the reach, and of what `Push.thinnest` says. To
come out on another side than it went in, a piece of the robot must cross at least that width, so
Chipmunk sees it inside at eight steps, and from the first of them on pushes it back."""

FRAME = 1.0 / 32.0
"""Seconds between recorded configurations, about."""

NEAR = 0.25
"""Of the reach: when so near to the goal in travel, the straight rest of the way is looked at."""

MOST_STEPS = 100_000_000
"""Steps of all tries: hours of simulation."""

Listener = Callable[[int, float], None]
"""Called with the number of the try and the simulated seconds so far."""


@dataclass(frozen=True)
class _Pace:
    """How time is cut; the step in the scene's unit, times in simulated seconds."""

    step: float
    time_step: float
    steps: int
    every: int  # steps from one recorded configuration to the next


def push(
    scene: SceneLike | Problem,
    *,
    seconds: float = 20.0,
    tries: int = 4,
    seed: int = 0,
    listener: Listener | None = None,
) -> Push:
    """Let a robot with mass, driven by random pushes, try to get from start to goal.

    Parameters
    ----------
    scene : Scene, str, path, mapping or Problem
        A valid problem, a loaded scene, or anything that `load_scene` takes.
    seconds : float
        Simulated time of a try; top speed is two reaches of the robot a second.
    tries : int
        Robots, one after the other, each from the start.
    seed : int
        Of the pushes. The same seed gives the same tries, bit for bit, on one machine.
    listener : callable, optional
        Called now and then with the number of the try and the simulated seconds so far.

    Returns
    -------
    Push
        What each try came to.

    Raises
    ------
    SceneError
        If the scene is not valid.
    OptionsError
        If a number is out of range, or pymunk is missing.
    """
    problem = problem_of(scene)
    if not 0.0 < seconds < math.inf:
        raise OptionsError(f"seconds must be positive (got {seconds:g})")
    if tries < 1:
        raise OptionsError(f"tries must be at least 1 (got {tries})")
    probe = make_world(problem, dynamic=False)
    pace = _pace(problem, probe, seconds, tries)
    runs = []
    for number in range(tries):
        driver = Driver(
            problem, make_world(problem, dynamic=True), random.Random(f"{seed}/{number}")
        )
        run = _try(problem, probe, pace, driver, partial(listener or _ignore, number))
        runs.append(run)
    return Push(
        scene=problem.name,
        seed=seed,
        tries=tuple(runs),
        distance=travel_to_goal(problem, problem.start),
        step=pace.step,
        time_step=pace.time_step,
        frame=pace.every * pace.time_step,
        thinnest=probe.thinnest,
        accuracy=rounding(problem, np.concatenate([run.configurations for run in runs])),
        engine=engine_name(),
    )


def _pace(problem: Problem, world: World, seconds: float, tries: int) -> _Pace:
    radius = reach(problem.robot)
    step = min(radius / STEPS_PER_REACH, world.thinnest / STEPS_PER_WIDTH)
    time_step = step / (2.0 * SPEED * radius)  # translation and rotation both at top speed
    count = seconds / time_step
    if count * tries > MOST_STEPS:
        raise OptionsError(
            f"{tries} tries of {seconds:g} s are {count * tries:.2g} steps, since the thinnest "
            f"piece demands steps of {time_step:.2g} s; at most {MOST_STEPS:.0e} are done"
        )
    return _Pace(step, time_step, math.ceil(count), max(1, round(FRAME / time_step)))


def _ignore(_number: int, _seconds: float) -> None:
    """Listen to nothing."""


def _try(
    problem: Problem, probe: World, pace: _Pace, driver: Driver, listener: Callable[[float], None]
) -> Try:
    """Simulate one robot until time is up or it has reached the goal."""
    where = [problem.start]
    deepest, nearest, reached, done = 0.0, travel_to_goal(problem, problem.start), False, 0
    while done < pace.steps and not reached:
        for _ in range(min(pace.every, pace.steps - done)):
            driver.advance(pace.time_step)
            deepest = max(deepest, _depth(probe, driver, pace.step))
            done += 1
        where.append(driver.configuration())
        left = travel_to_goal(problem, where[-1])
        nearest = min(nearest, left)
        if left <= NEAR * reach(problem.robot):
            reached = _may_finish(problem, probe, where[-1], pace.step, deepest)
        listener(done * pace.time_step)
    trace = np.array(where)
    return Try(
        seconds=done * pace.time_step,
        configurations=trace,
        length=sum(travel_between(problem, a, b) for a, b in itertools.pairwise(where)),
        farthest=float(np.hypot(*(trace[:, :2] - trace[0, :2]).T).max()),
        nearest=nearest,
        reached=reached,
        deepest=deepest,
        outside=outside(problem.reference_bounds, trace),
        undone=driver.undone,
    )


def _depth(probe: World, driver: Driver, step: float) -> float:
    """Return the deepest penetration now; one that takes more than a step is asked for again."""
    depth = driver.depth()
    if depth <= step:
        return depth
    return max(touched(probe, driver.configuration())[0].values(), default=0.0)


def _may_finish(
    problem: Problem, probe: World, q: Configuration, step: float, deepest: float
) -> bool:
    """Whether the straight way on to the goal is no deeper in collision than the robot was."""
    rest = equal_steps([q, nearest_goal(problem, q)], reach(problem.robot), step)
    return find_contacts(probe, rest).deepest <= max(deepest, rounding(problem, rest))
