"""The speed of an animation and its number of frames."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planar_planner.errors import OptionsError

DEFAULT_SECONDS = 10.0
MAX_FRAMES = 20_000
"""A quarter of an hour at 25 frames per second; without it a wrong --speed would fill the disk."""


@dataclass(frozen=True)
class Pace:
    """Speed of an animation.

    Attributes
    ----------
    speed : float or None
        Travel in scene units per second (`planar_planner.planning.path_samples.travel`), > 0; for
        a sweep through theta it is in radians per second.
    seconds : float or None
        Time from start to goal instead of a speed, > 0; 10 s if neither is given.
    fps : float
        Frames per second, in (0, 240].
    hold : float
        Seconds for which the first and the last frame stand still, >= 0.
    """

    speed: float | None = None
    seconds: float | None = None
    fps: float = 25.0
    hold: float = 1.0

    def __post_init__(self) -> None:
        if self.speed is not None and self.seconds is not None:
            raise OptionsError("speed and seconds exclude each other: give only one of them")
        for name in ("speed", "seconds"):
            value = getattr(self, name)
            if value is not None and not (value > 0.0 and math.isfinite(value)):
                raise OptionsError(f"{name} must be positive and finite, not {value!r}")
        if not 0.0 < self.fps <= 240.0:
            raise OptionsError(f"fps must be in (0, 240], not {self.fps!r}")
        if not (self.hold >= 0.0 and math.isfinite(self.hold)):
            raise OptionsError(f"hold must be at least 0 and finite, not {self.hold!r}")

    def duration(self, length: float) -> float:
        """Return the seconds that a path of this travel takes, without the holds."""
        if self.speed is not None:
            return length / self.speed
        return DEFAULT_SECONDS if self.seconds is None else self.seconds

    def moving_frames(self, length: float) -> int:
        """Return the number of frames from start to goal, both included: at least 2.

        Raises
        ------
        OptionsError
            If there would be more than 20,000 frames, held ones included.
        """
        count = max(2.0, self.duration(length) * self.fps + 1.0)
        held = 2.0 * self.hold * self.fps
        if not count + held <= MAX_FRAMES:
            raise OptionsError(
                f"{count + held:.3g} frames are more than {MAX_FRAMES:,}: raise speed, "
                "or lower seconds, hold or fps"
            )
        return round(count)

    def held_frames(self) -> int:
        """Return the number of further frames for which the first and the last frame are held."""
        return round(self.hold * self.fps)
