"""Piano family: a grand piano, seen from above, passes a door and turns into a corridor."""

from scenarios.model import Ring, Scene, box, polygon, scene

# The critical width of the door is the piano's: the planner finds no path at 1.499, one at 1.501.
PATH_DOOR = 1.62
JAMMED_DOOR = 1.35

WALL = 0.2
ROOM = 4.0  # width of the room, and of the door's wall
CORRIDOR = 2.0  # width of the corridor behind the wall


def piano_ring() -> Ring:
    """Outline of a grand piano 1.5 wide and 2.0 long (metres), its bent side on the right.

    The keyboard is at the bottom; the reference point lies near the middle.
    """
    return [
        (-0.75, -1.0),
        (0.75, -1.0),
        (0.75, -0.3),
        (0.7, -0.12),
        (0.58, 0.02),
        (0.4, 0.14),
        (0.24, 0.28),
        (0.13, 0.45),
        (0.07, 0.62),
        (0.0, 0.78),
        (-0.12, 0.91),
        (-0.28, 0.98),
        (-0.45, 1.0),
        (-0.6, 0.97),
        (-0.71, 0.88),
        (-0.75, 0.75),
    ]


def piano(door: float = PATH_DOOR, name: str = "piano") -> Scene:
    """Piano scene with a given width of the door."""
    if not 0.0 < door < ROOM:
        raise ValueError(f"piano: door is {door}, must be in (0, {ROOM})")
    left, right = 2.2 - 0.5 * door, 2.2 + 0.5 * door
    top = ROOM + WALL + CORRIDOR
    return scene(
        name,
        f"A grand piano 1.5 x 2.0 must leave a room, door {door} wide, and turn into a corridor.",
        workspace=(0.0, 0.0, 8.0, top),
        robot=polygon(piano_ring()),
        obstacles=[
            box(0.0, ROOM, left, ROOM + WALL),
            box(right, ROOM, 8.0, ROOM + WALL),
            box(5.0, 0.0, 5.0 + WALL, ROOM + WALL),  # the room's right wall
        ],
        start=(1.3, 1.4, 0.0),
        goal=(6.7, ROOM + WALL + 0.5 * CORRIDOR, 1.5),
    )


def piano_anywhere() -> Scene:
    """Piano scene with a goal region: upright, anywhere at the corridor's end."""
    made = piano(name="piano-anywhere")
    made["description"] = "The same piano, anywhere at the corridor's end, its keyboard to the end."
    low, high = ROOM + WALL, ROOM + WALL + CORRIDOR
    made["goal"] = {"region": box(5.5, low, 8.0, high), "theta": [1.5, 1.65]}
    return made
