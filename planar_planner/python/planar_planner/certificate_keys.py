"""The keys and words of a certificate (docs/certificate.md): the one list of both its sides.

`planar_planner.planning.certificate` writes them, `planar_planner.checker.form` reads them and says
which keys an object has and what may stand under each. There is no logic here.
"""

from __future__ import annotations

FORMAT_NAME = "planar-planner/certificate"
FORMAT_VERSION = 1

# Every certificate.
FORMAT, VERSION, MADE_BY, SCENE = "format", "version", "made_by", "scene"
VERDICT = "verdict"
DECIMAL_PLACES = "decimal_places"
ROBOT_PIECES, OBSTACLE_PIECES, OUTSIDE = "robot_pieces", "obstacle_pieces", "outside"

# A path.
CONTACT_TOLERANCE, WAYPOINTS, SEGMENTS = "contact_tolerance", "waypoints", "segments"
FROM, TO, APART, ALONG = "from", "to", "apart", "along"

# No path: a separation, of the robot or of a disc inside it; a closed chain of open sums; an end
# that is not free.
CLAIM = "claim"
DOMAIN, LOW, SIZE = "domain", "low", "size"
START_SIDE, FULL, FULL_FACES = "start_side", "full", "full_faces"
REFERENCE = "reference"
DISC, INSIDE = "disc", "inside"
CHAIN, SIDE = "chain", "side"
END, REFERENCE_BOUNDS = "end", "reference_bounds"

# A claim that the robot collides.
BOX, AXIS = "box", "axis"
PAIR, WALL, JOINT = "pair", "wall", "joint"
AXES, EDGES, SUMS = "axes", "edges", "sums"
OWNER, EDGE, VERTEX, WEIGHT = "owner", "edge", "vertex", "weight"

# Words under `verdict`, `claim`, `end`, `owner`, `wall` and `side`, and of `along`.
PATH, NO_PATH = "path", "no_path"
SEPARATION_CLAIM, DISC_CLAIM = "separation", "disc"
CHAIN_CLAIM, END_CLAIM = "odd_chain", "end"
START, GOAL = "start", "goal"
ROBOT, OBSTACLE = "robot", "obstacle"
LEFT, RIGHT = "left", "right"
X_MIN, X_MAX, Y_MIN, Y_MAX = WALLS = ("x_min", "x_max", "y_min", "y_max")
