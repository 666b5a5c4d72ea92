"""Shapely geometry of a scene given as the parsed JSON file."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry


@dataclass(frozen=True)
class Shapes:
    """Geometry of a scene; world frame but for the robot, which is in its own."""

    robot: BaseGeometry
    obstacles: list[BaseGeometry]  # includes the walls of a polygonal workspace
    box: tuple[float, float, float, float] | None  # the body stays inside
    reference_bounds: tuple[float, float, float, float] | None  # the reference point stays inside
    rotation: bool
    theta: float  # at the start; the only one if rotation is False
    radius: float  # greatest distance of a robot point from its reference point

    @property
    def size(self) -> float:
        """Length of the greater side of the domain."""
        xmin, ymin, xmax, ymax = self.reference_domain
        return max(xmax - xmin, ymax - ymin)

    @property
    def reference_domain(self) -> tuple[float, float, float, float]:
        """Box that holds the reference point of every legal configuration."""
        if self.box is None:
            assert self.reference_bounds is not None
            return self.reference_bounds
        r = self.radius
        xmin, ymin, xmax, ymax = self.box
        grown = (xmin - r, ymin - r, xmax + r, ymax + r)
        if self.reference_bounds is None:
            return grown
        lower, upper = self.reference_bounds[:2], self.reference_bounds[2:]
        return (
            max(grown[0], lower[0]),
            max(grown[1], lower[1]),
            min(grown[2], upper[0]),
            min(grown[3], upper[1]),
        )


def geometry(geojson: dict[str, Any]) -> BaseGeometry:
    """Shapely geometry of a GeoJSON object; raises when it is not valid."""
    made = shapely.geometry.shape(geojson)
    if not made.is_valid:
        raise ValueError(f"invalid geometry: {shapely.is_valid_reason(made)}")
    return made


def shapes(scene: dict[str, Any]) -> Shapes:
    """Read the geometry of a scene."""
    robot = geometry(scene["robot"])
    obstacles = [geometry(g) for g in scene["obstacles"]]
    box = None
    workspace = scene.get("workspace")
    if workspace is not None and "box" in workspace:
        box = tuple(workspace["box"])
    elif workspace is not None:
        room = geometry(workspace)
        box = room.bounds
        walls = shapely.box(*box).difference(room)
        obstacles += [part for part in shapely.get_parts(walls) if part.area > 0.0]
    bounds = scene.get("reference_bounds")
    vertices: NDArray[np.float64] = shapely.get_coordinates(robot)
    return Shapes(
        robot=robot,
        obstacles=obstacles,
        box=box,
        reference_bounds=None if bounds is None else tuple(bounds),
        rotation=scene.get("rotation", True),
        theta=float(scene["start"][2]),
        radius=float(np.hypot(vertices[:, 0], vertices[:, 1]).max()),
    )
