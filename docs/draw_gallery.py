"""Solve every shipped scene and draw it: ``python docs/draw_gallery.py [name ...]``.

Needs the installed package. Rewrites ``docs/pictures/``; stops at a verdict that is not expected.
"""

import sys
from pathlib import Path

from small_picture import save_small

from planar_planner import load_scene, solve
from planar_planner.pictures import draw_scene
from planar_planner.scene.builtin import manifest

PICTURES = Path(__file__).parent / "pictures"
DPI = 90  # enough for a screen, small files


def main() -> None:
    """Draw the named scenes, or all."""
    PICTURES.mkdir(exist_ok=True)
    for name in sys.argv[1:] or list(manifest()):
        scene = load_scene(name)
        result = solve(scene)
        expected = manifest()[name]["expected"]
        if result.verdict != expected:
            raise SystemExit(f"{name}: {result.verdict}, expected {expected}")
        figure = draw_scene(scene, result)
        save_small(figure, PICTURES / f"{name}.png", DPI)


if __name__ == "__main__":
    main()
