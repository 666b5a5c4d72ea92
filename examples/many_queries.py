"""Many queries on one map: a planner keeps its cells, so later queries have less to do.

It prints::

    to (12.6, 4.6, 0.0): path, 14770 cells labelled
    to (4.6, 16.6, 1.57): path, 784 cells labelled
    and back: path, 2 cells labelled
"""

from planar_planner import Planner

planner = Planner("maze")  # a built-in scene, a file, a dict or a Scene
FIRST, SECOND = (12.6, 4.6, 0.0), (4.6, 16.6, 1.57)  # x, y, theta

for goal in (FIRST, SECOND):  # from the scene's own start
    result = planner.solve(goal=goal)
    print(f"to {goal}: {result.verdict}, {result.stats.labelled_cells} cells labelled")

back = planner.solve(start=SECOND, goal=FIRST)
print(f"and back: {back.verdict}, {back.stats.labelled_cells} cells labelled")
