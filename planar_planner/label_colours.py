"""One colour a label, for every picture of cells.

From Okabe and Ito's set, which any common colour blindness tells apart; they also differ in
lightness: FULL is dark, STAR is middling, FREE is light, MIXED is lightest.
"""

from __future__ import annotations

LABEL_COLOURS = {
    "FREE": "#56B4E9",  # sky blue
    "STAR": "#009E73",  # bluish green
    "FULL": "#4D4D4D",  # dark grey
    "MIXED": "#F5EE9E",  # yellow, paled: it fills most of a picture
}
"""By the names in `planar_planner.cells.LABELS`."""
