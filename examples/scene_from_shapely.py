"""A scene from shapely objects: a table goes through a door, and a longer one does not.

Lengths are in metres, angles in radians. It prints::

    table of 1.8 m: path, 7.3 m long
    table of 2.8 m: no_path
"""

from shapely.geometry import MultiPolygon, box

from planar_planner import Scene, solve

WALLS = MultiPolygon(
    [
        box(3.0, 0.0, 3.15, 2.6),  # below the door
        box(3.0, 3.5, 3.15, 4.0),  # above it
        box(4.3, 1.6, 6.0, 1.9),  # a sideboard behind it
    ]
)

for length in (1.8, 2.8):
    scene = Scene(
        name=f"table of {length} m",
        robot=box(-length / 2, -0.4, length / 2, 0.4),  # about its own reference point (0, 0)
        obstacles=WALLS,
        workspace=(0.0, 0.0, 6.0, 4.0),  # the whole table stays inside
        start=(1.45, 0.6, 0.0),  # x, y and angle of the table
        goal=(4.58, 0.7, 0.0),
    )
    result = solve(scene)
    found = f", {result.path_length:.1f} m long" if result.verdict == "path" else ""
    print(f"{scene.name}: {result.verdict}{found}")
