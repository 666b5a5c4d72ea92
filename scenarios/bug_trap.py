"""Bug-trap family: a robot leaves a chamber whose only opening is a funnel that narrows inwards."""

from scenarios.model import Ring, Scene, box, mirrored_in_x_axis, polygon, scene

PATH_NECK = 0.8  # the robot is 0.5 wide: it leaves lengthways
CLOSED_NECK = 0.36

ROBOT_LENGTH = 1.2
ROBOT_WIDTH = 0.5


def trap_ring(neck: float) -> Ring:
    """Outline of the trap, symmetric about the x axis; the neck lies at x = 0.6."""
    half = 0.5 * neck
    upper = [
        (-3.9, 0.9),
        (-3.2, 2.2),
        (-1.7, 3.0),
        (1.9, 3.0),
        (3.2, 2.3),
        (3.8, 1.3),  # rim of the mouth
        (2.2, 0.75 + 0.5 * half),
        (0.6, half),  # neck, outer side
        (0.6, half + 0.25),  # neck, inner side
        (2.1, 1.05 + 0.5 * half),
        (3.2, 1.5),
        (2.8, 2.05),
        (1.75, 2.6),
        (-1.6, 2.6),
        (-2.9, 1.9),
        (-3.45, 0.8),
    ]
    outer, inner = upper[:8], upper[8:]
    # Along the upper outside to the neck, back along the inside, and the mirror image below.
    return [*outer, *inner, *mirrored_in_x_axis(inner), *mirrored_in_x_axis(outer)]


def bug_trap(neck: float = PATH_NECK, name: str = "bug-trap") -> Scene:
    """Bug-trap scene with a given width of the neck; the robot passes when the neck exceeds 0.5."""
    if not 0.0 < neck <= 1.2:
        raise ValueError(f"bug_trap: neck is {neck}, must be in (0, 1.2]")
    return scene(
        name,
        f"A {ROBOT_LENGTH} x {ROBOT_WIDTH} rectangle must leave a bug trap by a neck {neck} wide.",
        workspace=(-6.0, -5.0, 7.0, 5.0),
        robot=box(-0.5 * ROBOT_LENGTH, -0.5 * ROBOT_WIDTH, 0.5 * ROBOT_LENGTH, 0.5 * ROBOT_WIDTH),
        obstacles=[polygon(trap_ring(neck))],
        start=(-1.8, -1.0, 1.0),
        goal=(5.5, 2.5, 1.5),
    )
