"""Draw the pictures of docs/pictures.md: ``python docs/draw_views.py``. Needs the package."""

import math
from pathlib import Path

from planar_planner import Planner
from planar_planner.pictures import save_picture
from planar_planner.pictures.views import draw_view

PICTURES = Path(__file__).parent / "pictures"
DPI = 80  # enough for a screen, small files
VIEWS = {
    "filmstrip": ("gear", None),
    "slices": ("gear", [0.0, math.radians(20.0), math.radians(57.0)]),
    "space": ("gear", None),
    "wall": ("bug-trap-closed", None),
}


def main() -> None:
    """Draw one example of each view that the gallery does not show."""
    for view, (name, thetas) in VIEWS.items():
        planner = Planner(name)
        figure = draw_view(planner, planner.solve(), view, thetas)
        save_picture(figure, PICTURES / f"view-{view}.png", dpi=DPI)


if __name__ == "__main__":
    main()
