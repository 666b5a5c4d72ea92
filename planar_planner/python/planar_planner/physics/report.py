"""Results of a replay and of a push; lengths are in the scene's unit, angles in radians."""

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
        ``obstacle 'shelf'`` by its name, ``obstacles[3]`` without one, or ``workspace``.
    count : int
        Configurations with contact, touching included.
    depth : float
        Deepest penetration that Chipmunk reports; 0 if it only touches.
    configuration : (x, y, theta)
        Where the deepest penetration is.
    """

    what: str
    count: int
    depth: float
    configuration: Configuration


@dataclass(frozen=True, eq=False)
class Replay:
    """The result of a replay of a path in Chipmunk.

    Attributes
    ----------
    scene : str
        Name of the scene.
    configurations : NDArray, shape (N, 3)
        Configurations that Chipmunk checked, equally spaced in travel
        (`planar_planner.planning.path_samples`).
    depths : NDArray, shape (N,)
        Deepest penetration at each configuration, as Chipmunk reports it.
    step : float
        Travel between two configurations. A penetration deeper than half of it cannot be missed.
    length : float
        Travel of the whole path.
    contacts : tuple of Contact
        Deepest first.
    deepest : float
        Deepest penetration that Chipmunk reports; 0 without contact.
    doubted : int
        Configurations where two answers of Chipmunk disagreed, so that more were taken beside them
        (`planar_planner.physics.contacts`).
    accuracy : float
        Depth that rounding in Chipmunk may add here: a depth up to this is contact, not collision.
    tolerance : float
        Depth that the user accepts as contact.
    outside : float
        How far the reference point leaves ``reference_bounds``. It is computed here and not by
        Chipmunk, because these bound a point and not a body.
    start_gap, goal_gap : float
        Travel from the scene's start to the path's, and from the path's goal to the scene's; whole
        turns do not count.
    engine : str
        Names and versions of Chipmunk and pymunk.
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
        """Depth that counts as contact: Chipmunk's accuracy, or the user's tolerance if larger."""
        return max(self.accuracy, self.tolerance)

    @property
    def free(self) -> bool:
        """Whether neither the penetration nor the distance out of bounds exceeds `allowed`."""
        return max(self.deepest, self.outside) <= self.allowed

    @property
    def joins(self) -> bool:
        """Whether the path runs from the scene's start to its goal."""
        return max(self.start_gap, self.goal_gap) <= self.allowed

    @property
    def confirmed(self) -> bool:
        """Whether Chipmunk finds the path free, and the path joins start and goal."""
        return self.free and self.joins

    def to_json(self) -> dict[str, Any]:
        """Return a JSON object; of the configurations it holds only the number."""
        return {
            "format": "planar-planner/replay",
            "version": VERSION,
            "scene": self.scene,
            "confirmed": self.confirmed,
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
    """The result of one try: a robot that random forces drove for a time.

    Attributes
    ----------
    seconds : float
        Simulated time; it is shorter than requested only if the robot reached the goal.
    configurations : NDArray, shape (N, 3)
        Recorded configurations, `Push.frame` seconds apart; the first is the start.
    length : float
        Total travel.
    farthest : float
        Greatest distance of the reference point from its start.
    nearest : float
        Least travel that was left to the goal on a straight line.
    reached : bool
        Whether the robot came near the goal, and Chipmunk finds the straight motion to the goal no
        deeper in collision than the robot had been.
    deepest : float
        Deepest penetration that Chipmunk reports at any step.
    outside : float
        How far the reference point was out of ``reference_bounds`` in a recorded configuration.
    undone : int
        Steps that were undone because Chipmunk had moved the robot farther than its speed allows.
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
        """Deepest penetration, or the distance out of bounds if that is larger."""
        return max(self.deepest, self.outside)

    def to_json(self) -> dict[str, Any]:
        """Return a JSON object."""
        members = {k: v for k, v in vars(self).items() if k != "configurations"}
        return members | {"path": self.configurations.tolist()}


@dataclass(frozen=True, eq=False)
class Push:
    """The result of a push: several robots that random forces drove.

    Attributes
    ----------
    scene : str
        Name of the scene.
    seed : int
        Seed of the pushes; each try combines it with its own number, counted from 0.
    tries : tuple of Try
    distance : float
        Travel from start to goal on a straight line.
    step : float
        Longest motion of a point of the robot in one time step.
    time_step, frame : float
        Simulated seconds of a step, and between two recorded configurations.
    thinnest : float
        Least width of a piece of the robot plus least width of a piece that it can meet: to pass a
        piece, the robot must get deeper into it than half of this. It is infinite if the robot can
        meet no piece.
    accuracy : float
        Depth that rounding in Chipmunk may add here.
    engine : str
        Names and versions of Chipmunk and pymunk.
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
        """Whether a robot reached the goal, with or without penetration."""
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
