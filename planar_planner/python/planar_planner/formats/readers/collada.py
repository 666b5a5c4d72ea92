"""The reader of Collada meshes: the regions that their triangles cover in the plane.

The standard library parses the file, because a mesh needs only a few lines of code and the
libraries that read Collada (pycollada, trimesh) store single precision, which moves every vertex.
Node transforms and the file's unit are applied in doubles.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from planar_planner.errors import SceneError, cut, shown
from planar_planner.formats.outlines.merge import Merged, merged
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point, Ring, Shape
from planar_planner.formats.xml_tree import parse_xml

Matrix = NDArray[np.float64]
_MAX_DEPTH = 100  # depth of nodes; a node that instances itself would never end
_MAX_NODES = 10**5  # nodes placed in all; few nodes can instance each other very often
_UPRIGHT: Mapping[str, Matrix] = {  # transform to Y_UP, as in the importer behind OMPL.app
    "Y_UP": np.eye(4),
    "Z_UP": np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]]),
    "X_UP": np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]]),
}


@dataclass
class Mesh:
    """Faces and corners of a file, turned so that y points upwards and projected to the x–y plane.

    Attributes
    ----------
    faces : list of Ring
        Triangles, and polygons without any cut, since a cut could be wrong.
    nodes : list of str
        Id or name of each face's node, for messages; empty if it has neither.
    corners : list of Point
        One point for each vertex as OMPL.app's importer counts them: a position with each of its
        normals and texture coordinates, once in each group of triangles that uses it.
    units : str
        A note on the file's unit and upward axis, and how they are used.
    """

    faces: list[Ring] = field(default_factory=list)
    nodes: list[str] = field(default_factory=list)
    units: str = ""
    corners: list[Point] = field(default_factory=list)


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a mesh as obstacles in the file's own frame; it states nothing else."""
    del path, options
    parts = Parts()
    add_region(mesh_of(data), parts, notes)
    return parts


def read_robot(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read a mesh as a robot whose reference point is the mean of its vertices."""
    del options
    notes.say(f"the reference point of the mesh {path.name} is the mean of its vertices")
    return Parts(robot=centred(mesh_of(data), notes))


def centred(mesh: Mesh, notes: Notes) -> list[Shape]:
    """Return the region of a mesh in a frame with the mean of its vertices as origin."""
    notes.say(mesh.units)
    count = len(mesh.corners)
    x0 = math.fsum(x for x, _ in mesh.corners) / count
    y0 = math.fsum(y for _, y in mesh.corners) / count
    faces = [[(x - x0, y - y0) for x, y in face] for face in mesh.faces]
    return [shape for part in _united(faces, "robot", notes) for shape in part.shapes]


def add_region(mesh: Mesh, parts: Parts, notes: Notes) -> None:
    """Add the region of a mesh in the file's own frame, with the names of its nodes."""
    notes.say(mesh.units)
    for part in _united(mesh.faces, "world", notes):
        names = dict.fromkeys(mesh.nodes[k] for k in part.pieces)
        parts.add_obstacles(part.shapes, ", ".join(filter(None, names)))


def _united(faces: list[Ring], place: str, notes: Notes) -> list[Merged]:
    try:
        return merged(faces, place, notes)
    except SceneError as error:
        raise SceneError(
            f"a face, projected to the plane, is refused: {error.problem}; triangulate the mesh",
            place,
            error.value,
        ) from None


def mesh_of(data: bytes) -> Mesh:
    """Read all faces of a file's scene.

    Raises
    ------
    SceneError
        If the file is not Collada, or something in it is missing, wrong or not supported.
    """
    document = Document(parse_xml(data, "COLLADA"))
    mesh = Mesh(units=document.units())
    for node in document.roots():
        _add_node(document, node, document.base(), mesh, 0)
    if not mesh.faces:
        raise SceneError("has no faces in its scene")
    return mesh


class Document:
    """A parsed file, with its elements by id."""

    def __init__(self, root: ElementTree.Element) -> None:
        self.root = root
        self.placed = 0  # nodes so far
        self._by_id = {e.get("id"): e for e in root.iter() if e.get("id") is not None}

    def find(self, reference: str | None, place: str) -> ElementTree.Element:
        """Return the element that ``#id`` names."""
        if reference is None or not reference.startswith("#") or reference[1:] not in self._by_id:
            raise SceneError("names nothing in this file", place, shown(reference))
        return self._by_id[reference[1:]]

    def base(self) -> Matrix:
        """Return the transform of the file's unit and upward axis."""
        axis = (self.root.findtext("asset/up_axis") or "Y_UP").strip()
        if axis not in _UPRIGHT:
            raise SceneError("must be X_UP, Y_UP or Z_UP", "asset/up_axis", shown(axis))
        unit = self.root.find("asset/unit")
        scale = _number(unit.get("meter", "1"), "asset/unit") if unit is not None else 1.0
        return np.diag([scale, scale, scale, 1.0]) @ _UPRIGHT[axis]

    def units(self) -> str:
        """Return a note on how `base` uses what the file states, or what it takes for granted."""
        axis = (self.root.findtext("asset/up_axis") or "").strip()
        unit = self.root.find("asset/unit")
        metres = None if unit is None else unit.get("meter")
        length = (
            "the mesh states no unit, and lengths are taken for metres"
            if metres is None
            else f"the mesh's unit of {cut(metres)} metres is applied, so lengths are in metres"
        )
        upright = f"{cut(axis)} is turned to Y_UP" if axis not in ("", "Y_UP") else "y is upwards"
        return f"{length}; {upright}, and faces are projected to the x–y plane"

    def roots(self) -> Iterator[ElementTree.Element]:
        """Yield the nodes of the scene."""
        instance = self.root.find("scene/instance_visual_scene")
        if instance is not None:
            scene = self.find(instance.get("url"), "scene/instance_visual_scene")
        else:
            found = self.root.find("library_visual_scenes/visual_scene")
            if found is None:
                raise SceneError("is missing", "library_visual_scenes/visual_scene")
            scene = found
        yield from scene.findall("node")


def _add_node(
    document: Document, node: ElementTree.Element, above: Matrix, mesh: Mesh, depth: int
) -> None:
    name = node.get("id") or node.get("name") or ""
    place = f"node {cut(name)!r}"
    document.placed += 1
    if depth > _MAX_DEPTH or document.placed > _MAX_NODES:
        raise SceneError("is nested too deeply, or contains itself", place)
    matrix = above @ _transform(node, place)
    if node.find("instance_controller") is not None:
        raise SceneError("is a skinned or morphed mesh, which is not read; export the mesh", place)
    for instance in node.findall("instance_geometry"):
        geometry = document.find(instance.get("url"), f"{place}, instance_geometry")
        _add_geometry(document, geometry, matrix, mesh)
        mesh.nodes += [name and f"node {name!r}"] * (len(mesh.faces) - len(mesh.nodes))
    for instance in node.findall("instance_node"):
        other = document.find(instance.get("url"), f"{place}, instance_node")
        _add_node(document, other, matrix, mesh, depth + 1)
    for child in node.findall("node"):
        _add_node(document, child, matrix, mesh, depth + 1)


def _transform(node: ElementTree.Element, place: str) -> Matrix:
    """Return the product of a node's transforms, in the order of the file."""
    result = np.eye(4)
    for element in node:
        where = f"{place}, {element.tag}"
        if element.tag == "matrix":
            step = np.array(_numbers(element, 16, where)).reshape(4, 4)
        elif element.tag == "translate":
            step = np.eye(4)
            step[:3, 3] = _numbers(element, 3, where)
        elif element.tag == "scale":
            step = np.diag([*_numbers(element, 3, where), 1.0])
        elif element.tag == "rotate":
            step = _rotation(_numbers(element, 4, where), where)
        elif element.tag in ("skew", "lookat"):
            raise SceneError("is a transform that is not supported", where)
        else:
            continue
        result = result @ step
    return result


def _rotation(numbers: list[float], place: str) -> Matrix:
    """Return the rotation about an axis (x, y, z) by an angle in degrees (Rodrigues)."""
    axis = np.array(numbers[:3])
    length = float(np.linalg.norm(axis))
    if length == 0:
        raise SceneError("has no axis", place)
    x, y, z = axis / length
    turn = math.radians(numbers[3])
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    result = np.eye(4)
    result[:3, :3] += math.sin(turn) * cross + (1 - math.cos(turn)) * (cross @ cross)
    return result


def _add_geometry(
    document: Document, geometry: ElementTree.Element, matrix: Matrix, mesh: Mesh
) -> None:
    place = f"geometry {cut(geometry.get('id') or '')!r}"
    body = geometry.find("mesh")
    if body is None:
        raise SceneError("is not a mesh", place)
    for group in body:
        if group.tag in ("triangles", "polylist", "polygons", "tristrips", "trifans"):
            _add_group(document, group, matrix, mesh, f"{place}, {group.tag}")
        elif group.tag in ("lines", "linestrips"):
            continue  # no area


def _add_group(
    document: Document, group: ElementTree.Element, matrix: Matrix, mesh: Mesh, place: str
) -> None:
    inputs = _inputs(document, group, place)
    if not inputs or "POSITION" not in (semantic for semantic, _, _ in inputs):
        raise SceneError("has no POSITION", place)
    width = 1 + max(offset for _, offset, _ in inputs)
    positions: list[Point] = []
    corners: dict[tuple[tuple[float, ...], ...], None] = {}
    faces = _faces(group, width, place)
    indices = sorted({tuple(corner) for face in faces for corner in face})
    number: dict[tuple[int, ...], int] = {}
    for corner in indices:
        key = tuple(_entry(rows, corner[offset], place) for _, offset, rows in inputs)
        corners[key] = None
        at = next(k for k, (semantic, _, _) in enumerate(inputs) if semantic == "POSITION")
        number[corner] = len(positions)
        positions.append(_projected(matrix, key[at], place))
    for face in faces:
        points = [positions[number[tuple(corner)]] for corner in face]
        mesh.faces.append(points)
    at = next(k for k, (semantic, _, _) in enumerate(inputs) if semantic == "POSITION")
    mesh.corners += [_projected(matrix, key[at], place) for key in corners]


def _projected(matrix: Matrix, position: tuple[float, ...], place: str) -> Point:
    if len(position) != 3:
        raise SceneError("positions must have x, y and z", place)
    x, y, z = position
    image = [float(matrix[k] @ (x, y, z, 1.0)) for k in (0, 1)]
    if not all(map(math.isfinite, image)):
        raise SceneError("must be finite numbers", place, shown(position))
    return image[0], image[1]


def _inputs(
    document: Document, group: ElementTree.Element, place: str
) -> list[tuple[str, int, list[tuple[float, ...]]]]:
    """Return (semantic, offset, rows) of each input, those behind VERTEX included."""
    found = []
    for element in group.findall("input"):
        offset = _index(element.get("offset", "0"), f"{place}, input")
        source = document.find(element.get("source"), f"{place}, input")
        if element.get("semantic") == "VERTEX":
            for inner in source.findall("input"):
                rows = _rows(document.find(inner.get("source"), f"{place}, vertices"), document)
                found.append((inner.get("semantic", ""), offset, rows))
        else:
            found.append((element.get("semantic", ""), offset, _rows(source, document)))
    return found


def _rows(source: ElementTree.Element, document: Document) -> list[tuple[float, ...]]:
    """Return the tuples of a source, as its accessor counts them."""
    place = f"source {cut(source.get('id') or '')!r}"
    accessor = source.find("technique_common/accessor")
    if accessor is None:
        raise SceneError("has no accessor", place)
    array = document.find(accessor.get("source"), f"{place}, accessor")
    values = [_number(word, place) for word in (array.text or "").split()]
    stride = _index(accessor.get("stride", "1"), place)
    offset = _index(accessor.get("offset", "0"), place)
    count = _index(accessor.get("count", "0"), place)
    if stride < 1 or offset + stride * count > len(values):
        raise SceneError(f"is shorter than its accessor says: {len(values)} numbers", place)
    return [tuple(values[offset + stride * k :][:stride]) for k in range(count)]


def _entry(rows: list[tuple[float, ...]], index: int, place: str) -> tuple[float, ...]:
    if not 0 <= index < len(rows):
        raise SceneError(f"names one of {len(rows)} values", place, str(index))
    return rows[index]


def _faces(group: ElementTree.Element, width: int, place: str) -> list[list[list[int]]]:
    """Return the faces of a group, each a list of corners, each a list of indices."""
    runs = [_corners(element, width, place) for element in group.findall("p")]
    if group.findall("ph"):
        raise SceneError("polygons with holes are not supported; triangulate the mesh", place)
    if group.tag == "polygons":
        return runs
    if group.tag == "trifans":
        return [[run[0], b, c] for run in runs for b, c in itertools.pairwise(run[1:])]
    if group.tag == "tristrips":
        return [list(t) for run in runs for t in zip(run, run[1:], run[2:], strict=False)]
    corners = [corner for run in runs for corner in run]
    if group.tag == "triangles":
        sizes = [3] * (len(corners) // 3)
    else:
        sizes = [_index(word, place) for word in (group.findtext("vcount") or "").split()]
    if sum(sizes) != len(corners):
        raise SceneError(f"has {len(corners)} corners where {sum(sizes)} make whole faces", place)
    faces, at = [], 0
    for size in sizes:
        faces.append(corners[at : at + size])
        at += size
    return faces


def _corners(element: ElementTree.Element, width: int, place: str) -> list[list[int]]:
    numbers = [_index(word, place) for word in (element.text or "").split()]
    if len(numbers) % width:
        raise SceneError(f"must have a multiple of {width} indices", place, str(len(numbers)))
    return [numbers[i : i + width] for i in range(0, len(numbers), width)]


def _numbers(element: ElementTree.Element, count: int, place: str) -> list[float]:
    words = (element.text or "").split()
    if len(words) != count:
        raise SceneError(f"must have {count} numbers", place, str(len(words)))
    return [_number(word, place) for word in words]


def _number(text: str, place: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise SceneError("must be a finite number", place, shown(text))
    return value


def _index(text: str, place: str) -> int:
    if not text.strip().isdecimal() or len(text.strip()) > 9:
        raise SceneError("must be a count or an index", place, shown(text))
    return int(text)
