"""Every numeric tolerance of the Python side, with unit and derivation.

Limits of what is taken stand in ``limits.py``, those of the core in ``pdg/native/tolerances.hpp``.
u = 2**-53 is the unit roundoff. No proof rests on any of these.
"""

from __future__ import annotations

JOIN_REACH = 1e-6
"""A part of a drawing's larger extent: ends of its lines and arcs no farther apart are joined.

CAD programs write the ends of arcs as centres, radii and angles, often to six decimal places, so
ends that meet in the drawing differ in the file by a unit of the sixth place: half for each end."""

END_SLACK = 2.0**-30
"""How far a sampler's path may begin from the start and end from the goal, relative to the largest
coordinate and angle of both.

Samplers round: a start on the bounds into them, a yaw into half a turn, by a few u of the largest.
One that joins other ends (approximate goals, thresholds) misses by about the range of its edges,
percents of the space: what lies between tells the two apart, and 2**-30 is in the middle of it."""

SHORTEST_LIMIT = 1e-9
"""Seconds: one tick of the clock. A limit must be positive, but time may run out between a look at
the clock and the next; the core gives up at its first look then."""

TIMER_TICK = 1e-6
"""Seconds: the tick of interval timers. A timer of less is none."""

INTERRUPT_AGAIN = 5e-3
"""Seconds after which an interrupt that came within an import comes again. An import takes up to
some tenths of a second, and a user notices a twentieth; less would only use the processor."""

WRITTEN_SHARE = 1e-8
"""Share by which a gap in a drawing may exceed what the user joins: messages state gaps to nine
digits, and the ends' places are rounded themselves."""

LAST_STEP = 1e-5
"""The last step of a climb to a bottleneck, relative to the robot's reach. The place is an
estimate, printed to six digits: finer steps would show nothing."""

BOUNDS_SLACK = 1.0 + 2.0**-20
"""Factor on the robot's radius when the unbounded plane is given bounds; it covers the rounding of
the radius and of the bounds (some u), and anything above 1 keeps the proof in
``scene.plane.bounds_of_plane``."""

CHIPMUNK_ROUNDINGS = 32
"""Units of roundoff, of the largest coordinate, by which a depth of Chipmunk may be wrong.

Chipmunk computes in doubles (cpFloat), and shapes have no radius. A configuration between waypoints
rounds by 3; placing a vertex by 7 (cosine and sine, two products, two sums); of the robot and of
the obstacle that makes 13; their difference and its product with a unit normal that is itself
rounded by 3 add 8. The rest is for the angle, whose rounding counts by the reach. Measured on 4000
random pairs near contact: at most 3. It leaves out how ill-conditioned the normal of a very short
edge is, so it is an estimate of Chipmunk's accuracy and no bound."""

ASIDE = 2.0**-30
"""How far aside Chipmunk is asked again, in lengths of a space, where the robot's reach is 1/2 to
1: far above rounding, far below what matters to a drive."""
