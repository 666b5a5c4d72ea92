"""How far the robot can grow before no path remains, and where it is narrowest.

Both numbers are proven. It prints::

    a path remains for the robot grown by 0.0750, none for 0.0757
    it is bound by the way, between obstacles [0]
    at x = 0.45, y = 0.15, theta = 1.57
"""

from planar_planner import margin

found = margin("slot", width=1e-3)  # in the scene's unit of length
print(f"a path remains for the robot grown by {found.lower:.4f}, none for {found.upper:.4f}")

place = found.narrow_place
assert place is not None  # there is one where the way binds
obstacles = sorted({contact.obstacle for contact in place.contacts})
print(f"it is bound by the {found.binding}, between obstacles {obstacles}")
print("at x = {:.2f}, y = {:.2f}, theta = {:.2f}".format(*place.configuration))
