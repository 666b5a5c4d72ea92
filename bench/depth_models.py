"""What the models after the 2006 paper consist of: ``python bench/depth_models.py``."""

from __future__ import annotations

import shapely

import lib  # noqa: F401  (makes worlds importable)
from worlds.bodies.paper_models import models


def main() -> None:
    """Print vertices, holes and hull vertices of each body."""
    for model in models():
        for role, body in (("moving", model.moving), ("fixed", model.fixed)):
            vertices = len(shapely.get_coordinates(body)) - 1 - len(body.interiors)
            hull = len(shapely.get_coordinates(body.convex_hull)) - 1
            print(
                f"{model.name:24} {role:7} {vertices:3} vertices, {len(body.interiors)} holes, "
                f"{hull:2} on the hull, valid: {body.is_valid}"
            )


if __name__ == "__main__":
    main()
