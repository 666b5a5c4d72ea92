"""Films of a replay and of pushed robots, drawn and written like the films of `animate`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from matplotlib.artist import Artist
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path as Outline
from matplotlib.transforms import Affine2D

from planar_planner.films.canvas import Backdrop, Frame
from planar_planner.films.film import DEFAULT_SIZE, check_film
from planar_planner.films.gif import write_gif
from planar_planner.films.mp4 import write_mp4
from planar_planner.films.pace import Pace
from planar_planner.films.stage import Stage, make_stage
from planar_planner.load import SceneLike
from planar_planner.physics.replay import problem_of
from planar_planner.physics.report import Push, Replay
from planar_planner.pictures.shapes import polygon_paths
from planar_planner.pictures.style import GOAL, INK, MIDWAY
from planar_planner.problem.make import Problem

PACE = Pace(fps=16.0, hold=1.0)
"""Pace of the films: half as many frames as `push` records, so that twenty seconds stay small."""

HIT = GOAL  # vermilion: a robot in collision
ROBOTS = ("#CC79A7", "#009E73", "#F0E442", "#56B4E9")  # Okabe and Ito; for the tries in turn


def save_replay(
    scene: SceneLike | Problem, found: Replay, file: Path, suffix: str, pace: Pace = PACE
) -> None:
    """Write a film of the robot on its path; a robot in collision has another colour.

    Parameters
    ----------
    scene : Scene, str, path, mapping or Problem
        The scene of the replay.
    found : Replay
        The result of `replay`.
    file : path
        File to write.
    suffix : str
        .gif or .mp4; it may differ from the file's own suffix.
    pace : Pace, optional
        Speed and number of frames.

    Raises
    ------
    OptionsError
        If the format is unknown, or ffmpeg is missing.
    OutputError
        If ffmpeg fails.
    """
    _write(_replay_frames(problem_of(scene), found, pace), file, suffix, pace)


def save_push(scene: SceneLike | Problem, found: Push, file: Path, suffix: str) -> None:
    """Write a film of all tries at once, in simulated time.

    Parameters, errors
        As for `save_replay`.
    """
    _write(_push_frames(problem_of(scene), found), file, suffix, PACE)


def check_save(suffix: str) -> None:
    """Check before the work that a film can be written; otherwise raise `OptionsError`."""
    check_film(suffix, PACE, DEFAULT_SIZE)


def _write(frames: Iterator[Frame], file: Path, suffix: str, pace: Pace) -> None:
    check_save(suffix)
    if suffix.lower() == ".gif":
        write_gif(frames, pace.fps, file)
    else:
        write_mp4(frames, DEFAULT_SIZE, pace.fps, file)


def _replay_frames(problem: Problem, found: Replay, pace: Pace) -> Iterator[Frame]:
    verdict = "confirmed" if found.confirmed else "not confirmed"
    stage = make_stage(
        problem, found.configurations, f"{found.scene} – replay: {verdict}", DEFAULT_SIZE
    )
    robot = _robot(stage, problem, MIDWAY)
    keys: list[Artist] = [
        Patch(facecolor=MIDWAY, edgecolor=INK, label="free"),
        Patch(facecolor=HIT, edgecolor=INK, label="in collision"),
    ]
    stage.legend(keys)
    backdrop = Backdrop(stage.figure, [robot, stage.status])
    last = len(found.configurations) - 1
    shown = np.linspace(0, last, pace.moving_frames(found.length)).round().astype(int)
    for begin, k in zip([0, *(shown[:-1] + 1)], shown, strict=True):
        depth = float(found.depths[min(begin, k) : k + 1].max())  # since the frame before
        _place(stage, robot, found.configurations[k])
        robot.set_facecolor(HIT if depth > found.allowed else MIDWAY)
        done = 100.0 * k / max(1, last)
        stage.status.set_text(f"{done:3.0f} % of travel,  Chipmunk's depth {depth:.2g}")
        yield from _held(backdrop.frame(), pace, ends=k in (0, last))


def _push_frames(problem: Problem, found: Push) -> Iterator[Frame]:
    traces = [run.configurations for run in found.tries]
    end = "goal reached" if found.reached else "goal not reached"
    stage = make_stage(
        problem, np.concatenate(traces), f"{found.scene} – push: {end}", DEFAULT_SIZE
    )
    colours = [ROBOTS[k % len(ROBOTS)] for k in range(len(traces))]
    robots = [_robot(stage, problem, colour) for colour in colours]
    trails = [Line2D([], [], color=colour, linewidth=1.2, zorder=3) for colour in colours]
    for trail in trails:
        stage.axes.add_line(trail)
    # the legend puts each colour into the first frame, from which a GIF takes its palette
    stage.legend(
        [
            Patch(facecolor=colour, edgecolor=INK, label=_label(k, len(traces)))
            for k, colour in enumerate(colours[: len(ROBOTS)])
        ]
    )
    backdrop = Backdrop(stage.figure, [*trails, *robots, stage.status])
    seconds = max(run.seconds for run in found.tries)
    count = max(2, round(seconds * PACE.fps) + 1)
    for n, time in enumerate(np.linspace(0.0, seconds, count).tolist()):
        for trace, robot, trail in zip(traces, robots, trails, strict=True):
            k = min(round(time / found.frame), len(trace) - 1)
            _place(stage, robot, trace[k])
            trail.set_data(trace[: k + 1, 0], trace[: k + 1, 1])
        stage.status.set_text(f"{time:.1f} s of {seconds:.1f} s")
        yield from _held(backdrop.frame(), PACE, ends=n in (0, count - 1))


def _label(number: int, tries: int) -> str:
    """Return the legend's text: the tries that have the colour of this one."""
    later = number + len(ROBOTS)
    return f"try {number}" if later >= tries else f"tries {number}, {later}, …"


def _robot(stage: Stage, problem: Problem, colour: str) -> PathPatch:
    outline = Outline.make_compound_path(*polygon_paths(problem.robot))
    patch = PathPatch(outline, facecolor=colour, edgecolor=INK, linewidth=1.2, alpha=0.9, zorder=8)
    stage.axes.add_patch(patch)
    return patch


def _place(stage: Stage, robot: PathPatch, q: np.ndarray) -> None:
    moved = Affine2D().rotate(q[2]).translate(q[0], q[1])
    robot.set_transform(moved + stage.axes.transData)


def _held(frame: Frame, pace: Pace, *, ends: bool) -> Iterator[Frame]:
    for _ in range(1 + (pace.held_frames() if ends else 0)):
        yield frame
