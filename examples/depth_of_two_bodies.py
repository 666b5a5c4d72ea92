"""How deep one body sits in another, by `pdg` alone, which knows nothing of planning.

A bar lies slanted in a corridor, with its corners in both walls. Without turning it is free only
beyond a wall; a small turn frees it at once. It prints::

    overlap: 2.60 without turning
    with turning between 0.098 and 0.101
    free at (0.00, 0.00, 0.05)
"""

from shapely.geometry import box

import pdg

bar = box(-2.0, -0.4, 2.0, 0.4)  # in its own frame
walls = [box(-9.0, 0.5, 9.0, 2.0), box(-9.0, -2.0, 9.0, -0.5)]
pose = (0.0, 0.0, 0.1)  # where the bar is: x, y, theta

pushed = pdg.translational_depth(bar, walls, pose)
print(f"{pushed.state}: {pushed.depth:.2f} without turning")

lower = pdg.generalized_depth_lower_bound(bar, walls, pose)
upper = pdg.generalized_depth_upper_bound(bar, walls, pose)
print(f"with turning between {lower.lower:.3f} and {upper.upper:.3f}")
print("free at ({:.2f}, {:.2f}, {:.2f})".format(*upper.placement.pose))
