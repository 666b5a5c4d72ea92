"""Every constant of the gate: what a scene may hold at most, and why.

Lengths are in the scene's own unit, angles in radians.
"""

from __future__ import annotations

MAX_COORDINATE = 1e12
"""Largest magnitude of a coordinate. The core's error bounds are relative to the largest coordinate
(one unit in the last place of 1e12 is 1.2e-4), so anything beyond is a slip or has no use; and
products of up to 25 such factors stay finite in double precision."""

MIN_COORDINATE = 1e-50
"""Smallest magnitude of a coordinate other than zero. Two such doubles differ by more than 1e-66
or not at all, so a product of two differences stays above 1e-132 and its exact two-part form above
1e-164: orientation predicates and error bounds never meet an underflow or a subnormal number."""

MAX_ANGLE = 1e6
"""Largest magnitude of an angle in radians (160,000 turns). One unit in the last place is then
1.2e-10, still far below any angle a user may care about; past it the fraction of a turn fades."""

MAX_FILE_BYTES = 128 * 2**20
"""Largest scene file in bytes, some three million vertices. Reading takes about ten times as much
memory; the limit also ends the reading of an endless file such as a device."""

MAX_ROBOT_VERTICES = 65535
"""Largest number of robot vertices. The core counts the vertices of the robot's convex hull, which
the workspace's walls meet, in 16 bits; obstacles may be larger, they are cut into pieces."""
