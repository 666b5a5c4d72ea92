"""What a replay and a push find, as plain data; lengths in the scene's unit, angles in radians."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from planar_planner.scene.fields import Configuration

VERSION = 1

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Contact:
    """What the robot touched, over all configurations of a replay.

    Attributes
    ----------
    what : str
        ``obstacles[3]`` or ``workspace``.
    count : int
        Configurations with contact, touching included.
    depth : float
        Deepest penetration that Chipmunk reports; 0 if it only touches.
    configuration : (x, y, theta)
        Where that is.
    """

    what: str
    count: int
    depth: float
    configuration: Configuration


@dataclass(frozen=True, eq=False)
class Replay:
    """A path before Chipmunk.

    Attributes
    ----------
    scene : str
        Name of the scene.
    configurations : NDArray, shape (N, 3)
        Where Chipmunk looked: equally spaced in travel (`planar_planner.planning.path_samples`).
    depths : NDArray, shape (N,)
        Deepest penetration at each, as Chipmunk reports it.
    step : float
        Travel between two of them. A penetration deeper than half of it cannot hide between them.
    length : float
        Travel of the whole path.
    contacts : tuple of Contact
        Deepest first.
    deepest : float
        Deepest penetration that Chipmunk reports; 0 without contact.
    doubted : int
        Configurations where Chipmunk contradicted itself, and was asked again beside them
        (`planar_planner.physics.contacts`).
    accuracy : float
        What rounding in Chipmunk may add to a depth here: up to this it is contact, not collision.
    tolerance : float
        Depth that the user lets pass as contact.
    outside : float
        How far the reference point leaves ``reference_bounds``. Computed here, not by Chipmunk:
        these bound a point and no body.
    start_gap, goal_gap : float
        Travel from the scene's start to the path's, and from the path's goal to the scene's; whole
        turns count nothing.
    engine : str
        Chipmunk and pymunk with version.
    """

    scene: str
    configurations: Floats
    depths: Floats
    step: float
    length: float
    contacts: tuple[Contact, ...]
    deepest: float
    doubted: int
    accuracy: float
    tolerance: float
    outside: float
    start_gap: float
    goal_gap: float
    engine: str

    @property
    def allowed(self) -> float:
        """What depth counts as contact: Chipmunk's accuracy, or the user's tolerance if larger."""
        return max(self.accuracy, self.tolerance)

    @property
    def free(self) -> bool:
        """Whether nothing was found that is deeper than contact, or that far out of bounds."""
        return max(self.deepest, self.outside) <= self.allowed

    @property
    def joins(self) -> bool:
        """Whether the path runs from the scene's start to its goal."""
        return max(self.start_gap, self.goal_gap) <= self.allowed

    @property
    def witnessed(self) -> bool:
        """Whether the path is free as far as Chipmunk sees, and joins start and goal."""
        return self.free and self.joins

    def to_json(self) -> dict[str, Any]:
        """Return a JSON object; of the configurations only their number."""
        return {
            "format": "planar-planner/replay",
            "version": VERSION,
            "scene": self.scene,
            "witnessed": self.witnessed,
            "free": self.free,
            "joins": self.joins,
            "start_gap": self.start_gap,
            "goal_gap": self.goal_gap,
            "deepest": self.deepest,
            "outside": self.outside,
            "doubted": self.doubted,
            "accuracy": self.accuracy,
            "tolerance": self.tolerance,
            "configurations": len(self.configurations),
            "step": self.step,
            "length": self.length,
            "contacts": [asdict(contact) for contact in self.contacts],
            "engine": self.engine,
        }


@dataclass(frozen=True, eq=False)
class Try:
    """One robot that forces drove for a time.

    Attributes
    ----------
    seconds : float
        Simulated time; shorter than asked for only if it reached the goal.
    configurations : NDArray, shape (N, 3)
        Where it was, `Push.frame` seconds apart; the first is the start.
    length : float
        Travel in all.
    farthest : float
        Greatest distance of the reference point from where it started.
    nearest : float
        Least travel that was left to the goal on a straight line.
    reached : bool
        Whether it came near the goal, and Chipmunk finds the straight rest of the way no deeper
        in collision than it had been.
    deepest : float
        Deepest penetration that Chipmunk reports at any step.
    outside : float
        How far the reference point was out of ``reference_bounds`` in a recorded configuration.
    undone : int
        Steps taken back, because Chipmunk had thrown the robot farther than its speed allows.
    """

    seconds: float
    configurations: Floats
    length: float
    farthest: float
    nearest: float
    reached: bool
    deepest: float
    outside: float
    undone: int

    @property
    def worst(self) -> float:
        """Deepest penetration, or way out of bounds if that is more."""
        return max(self.deepest, self.outside)

    def to_json(self) -> dict[str, Any]:
        """Return a JSON object."""
        members = {k: v for k, v in vars(self).items() if k != "configurations"}
        return members | {"path": self.configurations.tolist()}


@dataclass(frozen=True, eq=False)
class Push:
    """Robots that forces drove.

    Attributes
    ----------
    scene : str
        Name of the scene.
    seed : int
        Of the pushes; each try mixes its number into it, counted from 0.
    tries : tuple of Try
    distance : float
        Travel from start to goal on a straight line.
    step : float
        Most that a point of the robot moves in one time step.
    time_step, frame : float
        Simulated seconds of a step, and between two recorded configurations.
    thinnest : float
        Least width of a piece of the robot plus least width of a piece it can meet: to pass a
        piece, the robot must get deeper into it than half of this. Infinite if it can meet none.
    accuracy : float
        What rounding in Chipmunk may add to a depth here.
    engine : str
        Chipmunk and pymunk with version.
    """

    scene: str
    seed: int
    tries: tuple[Try, ...]
    distance: float
    step: float
    time_step: float
    frame: float
    thinnest: float
    accuracy: float
    engine: str

    @property
    def reached(self) -> bool:
        """Whether a robot reached the goal, by whatever means."""
        return any(run.reached for run in self.tries)

    @property
    def reached_free(self) -> bool:
        """Whether a robot reached the goal without ever being deeper than rounding."""
        return any(run.reached and run.worst <= self.accuracy for run in self.tries)

    @property
    def deepest(self) -> float:
        """Deepest penetration of all tries."""
        return max(run.deepest for run in self.tries)

    @property
    def may_have_tunnelled(self) -> bool:
        """Whether a robot was so deep in a piece that it may have passed through it."""
        return self.deepest > self.thinnest / 2.0

    def to_json(self) -> dict[str, Any]:
        """Return a JSON object."""
        return {
            "format": "planar-planner/push",
            "version": VERSION,
            "scene": self.scene,
            "seed": self.seed,
            "reached": self.reached,
            "reached_free": self.reached_free,
            "may_have_tunnelled": self.may_have_tunnelled,
            "deepest": self.deepest,
            "accuracy": self.accuracy,
            "thinnest": self.thinnest if np.isfinite(self.thinnest) else None,
            "distance": self.distance,
            "step": self.step,
            "time_step": self.time_step,
            "frame": self.frame,
            "tries": [run.to_json() for run in self.tries],
            "engine": self.engine,
        }
