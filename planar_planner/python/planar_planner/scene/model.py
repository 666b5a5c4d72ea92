"""The raw scene: what is asked, in GeoJSON and plain numbers, with nothing of it judged.

`planar_planner.problem` turns it into a valid problem. As a file: ``scene.schema.json`` beside
this module, read by `planar_planner.scene.json_form`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from planar_planner.errors import SceneError, cut, shown
from planar_planner.scene import fields
from planar_planner.scene.geometry import Geometry, Numbers, body, geometries, workspace
from planar_planner.scene.goal_forms import GoalLike, goal_json
from planar_planner.scene.import_report import NOT_IMPORTED, ImportReport
from planar_planner.scene.plain import plain

FORMAT = "planar-planner/scene"
VERSION = 1
DECIMALS, DOUBLES = "decimals", "doubles"
"""What the lengths of a scene can mean."""


@dataclass(frozen=True, init=False, repr=False)
class Scene:
    """A robot among obstacles, and from where to where it is to go.

    Geometry is taken as shapely objects, as GeoJSON mappings, or as arrays of vertices, shape
    (n, 2), and kept as GeoJSON. Lengths are in any one unit, angles in radians, anticlockwise. Two
    scenes are equal if all but `source`, `imported` and `numbers` is.

    Attributes
    ----------
    robot : Any
        GeoJSON of the robot, in its own frame, whose origin is the reference point. A sequence of
        geometries is a robot of several parts.
    obstacles : Any
        List of GeoJSON geometries, world frame. A MultiPolygon or a collection that is given as
        the obstacles counts each of its parts as one.
    start : Any
        ``[x, y, theta]`` of the robot's frame in the world.
    goal : Any
        The same, or a set of configurations: a `GoalRegion`, an `Escape` or ``"escape"`` (from the
        box of all obstacles), kept in the form of scene files (docs/scene-file.md).
    workspace : Any
        The whole robot stays inside: ``(xmin, ymin, xmax, ymax)``, kept as ``{"box": […]}``, or one
        polygon. None if absent; then there are `bounds`.
    bounds : Any
        ``[xmin, ymin, xmax, ymax]`` for the reference point alone; None if absent. Scene files and
        messages call it ``reference_bounds``.
    rotation : Any
        False forbids turning; start and goal then have the same theta.
    name, description : str
        For people; the name also stands in results.
    source : str
        Where the scene came from, for messages; its name if it came from nowhere.
    bounds_are_chosen : Any
        Whether `bounds` stand for the unbounded plane (`planar_planner.scene.plane`): a file in
        another format states none, and a margin chooses them anew for each larger robot.
    imported : ImportReport
        What an importer did to the geometry of a file in another format.
    numbers : Any
        ``"decimals"`` if the lengths mean the decimals that they are written as, where these are
        short (docs/exact-fits.md), or ``"doubles"``. Files mean decimals; scenes made here mean
        doubles unless asked.

    Raises
    ------
    SceneError
        If a value is of the wrong form, with its field and place. Numbers and shapes are checked
        when the scene is planned on.
    """

    robot: Any
    obstacles: Any
    start: Any
    goal: Any
    workspace: Any
    bounds: Any
    rotation: Any
    name: str
    description: str
    source: str = field(compare=False)
    bounds_are_chosen: Any
    imported: ImportReport = field(compare=False)
    numbers: Any = field(compare=False)

    def __init__(
        self,
        *,
        robot: Geometry | Sequence[Geometry],
        obstacles: Geometry | Sequence[Geometry] = (),
        start: Numbers,
        goal: GoalLike,
        workspace: Geometry | Numbers | None = None,
        bounds: Numbers | None = None,
        rotation: bool = True,
        name: str = "scene",
        description: str = "",
        source: str = "",
        bounds_are_chosen: bool = False,
        imported: ImportReport | None = None,
        numbers: str = DOUBLES,
    ) -> None:
        given: dict[str, Any] = {"robot": robot, "obstacles": obstacles}
        given |= {"start": start, "goal": goal, "rotation": rotation}
        given |= {"workspace": workspace, "bounds": bounds}
        given |= {"bounds_are_chosen": bounds_are_chosen}
        try:
            values = {key: _FORMS[key](value) for key, value in given.items()}
            values["name"] = fields.text(name, "name")
            values["description"] = fields.text(description, "description")
        except SceneError as error:
            raise error.in_source(source or cut(str(name))) from None
        values["source"] = source or cut(name)
        _fill(self, values | {"imported": imported or NOT_IMPORTED, "numbers": numbers})

    def __hash__(self) -> int:
        return hash((self.name, self.description))

    def __repr__(self) -> str:
        number = len(self.obstacles) if isinstance(self.obstacles, list) else 0
        ends = f"start={shown(self.start)}, goal={shown(self.goal)}"
        return f"Scene(name={shown(self.name)}, {number} obstacle{'s'[number == 1 :]}, {ends})"

    @property
    def notes(self) -> tuple[str, ...]:
        """The notes of `imported`."""
        return self.imported.notes

    def to_dict(self) -> dict[str, Any]:
        """Return the scene as a JSON object that `load_scene` reads back."""
        content: dict[str, Any] = {"format": FORMAT, "version": VERSION, "name": self.name}
        if self.description:
            content["description"] = self.description
        if self.workspace is not None:
            content["workspace"] = self.workspace
        if self.bounds is not None:
            content["reference_bounds"] = self.bounds
        if self.bounds_are_chosen is not False:
            content["bounds_are_chosen"] = self.bounds_are_chosen
        content["robot"] = self.robot
        content["obstacles"] = self.obstacles
        content["start"] = self.start
        content["goal"] = self.goal
        if self.rotation is not True:
            content["rotation"] = self.rotation
        if self.numbers != DECIMALS:
            content["numbers"] = self.numbers
        return content


_FORMS: Mapping[str, Any] = {
    "robot": lambda value: body(value, "robot"),
    "obstacles": lambda value: geometries(value, "obstacles"),
    "start": lambda value: plain(value, "start"),
    "goal": goal_json,
    "workspace": lambda value: workspace(value, "workspace"),
    "bounds": lambda value: plain(value, "reference_bounds"),
    "bounds_are_chosen": lambda value: plain(value, "bounds_are_chosen"),
    "rotation": lambda value: plain(value, "rotation"),
}
"""How each field is brought to the form of scene files."""


def scene_of_values(values: Mapping[str, Any]) -> Scene:
    """Return a scene of all its fields, by name; they have the form of scene files and are kept."""
    scene = object.__new__(Scene)
    _fill(scene, values)
    return scene


def with_ends(scene: Scene, start: Any = None, goal: Any = None) -> Scene:
    """Return the scene with another start, goal or both, as scene files have them."""
    changed = {k: v for k, v in (("start", start), ("goal", goal)) if v is not None}
    return scene_of_values(vars(scene) | changed) if changed else scene


def _fill(scene: Scene, values: Mapping[str, Any]) -> None:
    for name, value in values.items():
        object.__setattr__(scene, name, value)
