"""Slot family: a T-shaped part leaves a T-slot whose neck is narrower than the part's head."""

from scenarios.model import Ring, Scene, polygon, scene

# The critical neck is BAR + STEM = 1.25, the part's width with its bar upright: the planner finds
# no path at 1.249, and one at 1.251.
PATH_NECK = 1.4
JAMMED_NECK = 1.1

HEAD = 2.0  # length of the T's bar: the part cannot come out straight
BAR = 0.35  # thickness of the bar and of the stem
STEM = 0.9  # from the bar to the stem's end


def part_ring() -> Ring:
    """Outline of the T, stem up; the reference point is the middle of the bar."""
    h, b = 0.5 * HEAD, 0.5 * BAR
    return [(-h, -b), (h, -b), (h, b), (b, b), (b, b + STEM), (-b, b + STEM), (-b, b), (-h, b)]


def block_ring(neck: float) -> Ring:
    """Outline of the block: a chamber 3.4 x 2.2 with the neck in its ceiling, 0.3 thick."""
    n = 0.5 * neck
    return [
        (-4.0, -3.0),
        (4.0, -3.0),
        (4.0, 0.0),
        (n, 0.0),
        (n, -0.3),
        (1.7, -0.3),
        (1.7, -2.5),
        (-1.7, -2.5),
        (-1.7, -0.3),
        (-n, -0.3),
        (-n, 0.0),
        (-4.0, 0.0),
    ]


def slot(neck: float = PATH_NECK, name: str = "slot") -> Scene:
    """Slot scene with a given width of the neck (the part's bar is 2 long)."""
    if not 0.0 < neck < HEAD:
        raise ValueError(f"slot: neck is {neck}, must be in (0, {HEAD})")
    return scene(
        name,
        f"A T-shaped part with a bar of {HEAD} must leave a T-slot through a neck {neck} wide.",
        workspace=(-4.0, -3.0, 4.0, 3.5),
        robot=polygon(part_ring()),
        obstacles=[polygon(block_ring(neck))],
        start=(0.0, -1.8, 0.0),
        goal=(1.5, 1.2, 0.0),
    )
