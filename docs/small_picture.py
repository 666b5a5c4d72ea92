"""Pictures small enough to commit."""

from pathlib import Path

from matplotlib.figure import Figure
from PIL import Image

from planar_planner.pictures import save_picture

COLOURS = 240  # of flat shapes and their soft edges; a palette is a third of the bytes


def save_small(figure: Figure, file: Path, dpi: float) -> None:
    """Write a figure as a PNG with a palette; the same picture is the same file."""
    save_picture(figure, file, dpi=dpi)
    with Image.open(file) as picture:
        reduced = picture.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    reduced.save(file, optimize=True)
