"""The shipped scenes: the generator of each, and the verdict that the planner must give."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Literal

from scenarios import (
    bug_trap,
    comb,
    corner,
    escape,
    exact,
    field,
    gear,
    maze,
    piano,
    slot,
    small,
    snowflake,
)
from scenarios.model import Scene

LICENCE = "MIT"
OWN = "planar-planner"
PDG_FIGURE_14 = (
    "reconstruction of Zhang, Kim, Varadhan, Manocha 2006, Figure 14; coordinates are ours"
)


@dataclass(frozen=True)
class Entry:
    """One shipped scene."""

    name: str
    expected: Literal["path", "no_path"]
    generator: str  # as a call, for readers; ``make`` is that call
    make: Callable[[], Scene]
    origin: str = OWN


ENTRIES: tuple[Entry, ...] = (
    Entry("gear", "path", "gear.gear()", gear.gear, PDG_FIGURE_14),
    Entry(
        "gear-wide",
        "path",
        "gear.gear(WIDE_GAP)",
        partial(gear.gear, gear.WIDE_GAP, "gear-wide"),
        PDG_FIGURE_14,
    ),
    Entry(
        "gear-tight",
        "path",
        "gear.gear(TIGHT_GAP)",
        partial(gear.gear, gear.TIGHT_GAP, "gear-tight"),
        PDG_FIGURE_14,
    ),
    Entry(
        "gear-jammed",
        "no_path",
        "gear.gear(JAMMED_GAP)",
        partial(gear.gear, gear.JAMMED_GAP, "gear-jammed"),
        PDG_FIGURE_14,
    ),
    Entry("maze", "path", "maze.maze()", maze.maze),
    Entry(
        "maze-blocked",
        "no_path",
        "maze.maze(blocked=True)",
        partial(maze.maze, blocked=True, name="maze-blocked"),
    ),
    Entry("corner", "path", "corner.corner()", corner.corner),
    Entry(
        "corner-too-long",
        "no_path",
        "corner.corner(TOO_LONG)",
        partial(corner.corner, corner.TOO_LONG, name="corner-too-long"),
    ),
    Entry("bug-trap", "path", "bug_trap.bug_trap()", bug_trap.bug_trap),
    Entry(
        "bug-trap-closed",
        "no_path",
        "bug_trap.bug_trap(CLOSED_NECK)",
        partial(bug_trap.bug_trap, bug_trap.CLOSED_NECK, "bug-trap-closed"),
    ),
    Entry("slot", "path", "slot.slot()", slot.slot),
    Entry(
        "slot-jammed",
        "no_path",
        "slot.slot(JAMMED_NECK)",
        partial(slot.slot, slot.JAMMED_NECK, "slot-jammed"),
    ),
    Entry("piano", "path", "piano.piano()", piano.piano),
    Entry(
        "piano-jammed",
        "no_path",
        "piano.piano(JAMMED_DOOR)",
        partial(piano.piano, piano.JAMMED_DOOR, "piano-jammed"),
    ),
    Entry("snowflake", "path", "snowflake.snowflake()", snowflake.snowflake),
    Entry(
        "snowflake-jammed",
        "no_path",
        "snowflake.snowflake(JAMMED_GATE)",
        partial(snowflake.snowflake, snowflake.JAMMED_GATE, "snowflake-jammed"),
    ),
    Entry("comb", "path", "comb.comb()", comb.comb),
    Entry(
        "comb-jammed",
        "no_path",
        "comb.comb(post=True)",
        partial(comb.comb, post=True, name="comb-jammed"),
    ),
    Entry("field", "path", "field.field()", field.field),
    Entry("open", "path", "small.open_floor()", small.open_floor),
    Entry("window", "path", "small.window()", small.window),
    Entry(
        "window-fixed",
        "no_path",
        "small.window(rotation=False)",
        partial(small.window, rotation=False, name="window-fixed"),
    ),
    Entry("slide", "path", "small.slide()", small.slide),
    Entry(
        "slide-blocked",
        "no_path",
        "small.slide(blocked=True)",
        partial(small.slide, blocked=True, name="slide-blocked"),
    ),
    Entry("courtyard", "path", "small.courtyard()", small.courtyard),
    Entry("fence", "path", "small.fence()", small.fence),
    Entry("disc", "path", "small.disc()", small.disc),
    Entry("disc-jammed", "no_path", "small.disc(0.8)", partial(small.disc, 0.8, "disc-jammed")),
    Entry("cage", "no_path", "escape.cage()", escape.cage),
    Entry(
        "cage-open",
        "path",
        "escape.cage(OPEN_MOUTH)",
        partial(escape.cage, escape.OPEN_MOUTH, "cage-open"),
    ),
    Entry("disassembly", "path", "escape.disassembly()", escape.disassembly),
    Entry(
        "disassembly-jammed",
        "no_path",
        "escape.disassembly(JAMMED_SLIT)",
        partial(escape.disassembly, escape.JAMMED_SLIT, "disassembly-jammed"),
    ),
    Entry("piano-anywhere", "path", "piano.piano_anywhere()", piano.piano_anywhere),
    Entry("exact-maze", "path", "exact.exact_maze()", exact.exact_maze),
    Entry(
        "exact-maze-ulp",
        "no_path",
        "exact.exact_maze(blocked=True)",
        partial(exact.exact_maze, blocked=True, name="exact-maze-ulp"),
    ),
    Entry("peg", "path", "exact.peg()", exact.peg),
    Entry(
        "peg-jammed",
        "no_path",
        "exact.peg(NARROW_SLOT)",
        partial(exact.peg, exact.NARROW_SLOT, "peg-jammed"),
    ),
    Entry("sliding-block", "path", "exact.sliding_block()", exact.sliding_block),
    Entry(
        "sliding-block-ulp",
        "no_path",
        "exact.sliding_block(6.0 + ULP)",
        partial(exact.sliding_block, 6.0 + exact.ULP, "sliding-block-ulp"),
    ),
    Entry("locked", "no_path", "exact.locked()", exact.locked),
    Entry("unlocked", "path", "exact.locked(2.0)", partial(exact.locked, 2.0, "unlocked")),
)
