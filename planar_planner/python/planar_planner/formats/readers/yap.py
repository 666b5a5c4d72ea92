r"""The reader of Yap-style text files: environments of directed polygons, and ``.rob`` robots.

An environment has N, N pairs x y, M, and M lines of 1-based vertex indices, each a closed polygon
whose interior (the obstacle's) is to the left of the directed edges. A robot has N and then N
vertices anticlockwise about the reference point at the origin. ``#`` begins a comment, and ``\`` at
the end of a line joins the next one.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from planar_planner.errors import SceneError, shown
from planar_planner.formats.outlines.exact import contains, is_anticlockwise
from planar_planner.formats.outlines.rings import MIN_RING, polygons_of, without_repeats
from planar_planner.formats.parts import ImportOptions, Notes, Parts, Point, Ring
from planar_planner.formats.reading import point, text_of, whole

_MOST = 10**7  # vertices or polygons of a file

Line = tuple[int, list[str]]


def read(data: bytes, path: Path, options: ImportOptions, notes: Notes) -> Parts:
    """Read an environment, or a robot if the name ends in ``.rob``."""
    del options
    lines = list(_logical_lines(text_of(data)))
    vertices, rest = _vertices(lines)
    if path.suffix.lower() == ".rob":
        if rest:
            raise SceneError("has more than the announced vertices", f"line {rest[0][0]}")
        robot = polygons_of([vertices], "robot", notes)
        if not robot:
            raise SceneError("has no area", "robot")
        return Parts(robot=robot)
    return _environment([_ring(line, vertices) for line in _polygon_lines(rest)], notes)


def _logical_lines(text: str) -> Iterator[Line]:
    """Yield (number, words) of each line with content."""
    pending: list[str] = []
    for number, line in enumerate(text.splitlines(), start=1):
        content = line.partition("#")[0].rstrip()
        pending += content.rstrip("\\").replace(",", " ").split()
        if content.endswith("\\"):
            continue
        if pending:
            yield number, pending
        pending = []
    if pending:
        yield number, pending


def _vertices(lines: list[Line]) -> tuple[list[Point], list[Line]]:
    """Return the vertices at the beginning, and the lines after them."""
    words = [(number, word) for number, line in lines for word in line]
    if not words:
        raise SceneError("is empty; a number of vertices was expected")
    count = whole(words[0][1], f"line {words[0][0]} (number of vertices)", 0, _MOST)
    if len(words) < 1 + 2 * count:
        raise SceneError(f"ends before the last of {count} vertices", f"line {words[-1][0]}")
    points = [
        point(words[i][1], words[i + 1][1], f"line {words[i][0]}, vertex {(i + 1) // 2}")
        for i in range(1, 1 + 2 * count, 2)
    ]
    left = 1 + 2 * count
    for k, (number, line) in enumerate(lines):
        if left < len(line):
            return points, [(number, line[left:]), *lines[k + 1 :]]
        left -= len(line)
    return points, []


def _polygon_lines(rest: list[Line]) -> list[Line]:
    if not rest:
        raise SceneError("ends before the number of polygons")
    (number, words), lines = rest[0], rest[1:]
    count = whole(words[0], f"line {number} (number of polygons)", 0, _MOST)
    if len(words) > 1:
        lines = [(number, words[1:]), *lines]
    if len(lines) != count:
        raise SceneError(f"has {len(lines)} lines of polygons where {count} were announced")
    return lines


def _ring(line: Line, vertices: list[Point]) -> tuple[str, Ring]:
    number, words = line
    place = f"line {number}"
    if len(words) == 0 or not vertices:
        raise SceneError("names a vertex where there is none", place, shown(" ".join(words)))
    return place, [vertices[whole(word, place, 1, len(vertices)) - 1] for word in words]


def _environment(rings: list[tuple[str, Ring]], notes: Notes) -> Parts:
    """Sort rings by their direction: obstacles, holes in these, and the outer boundary."""
    solid: list[tuple[str, list[Ring]]] = []
    hollow: list[tuple[str, Ring]] = []
    for place, ring in rings:
        polygons_of([ring], place, Notes())  # a ring that crosses itself has no direction
        clean = without_repeats(ring)
        if len(set(clean)) < MIN_RING:
            notes.pass_over("rings without area dropped")
        elif is_anticlockwise(clean):
            solid.append((place, [ring]))
        else:
            hollow.append((place, ring))
    boundary: list[tuple[str, Ring]] = []
    for place, ring in hollow:
        around = [own for _, own in solid if _surrounds(own[0], ring)]
        if around:
            min(around, key=lambda own: _extent(own[0])).append(ring)
        else:
            boundary.append((place, ring))
    if len(boundary) > 1:
        raise SceneError(
            "runs clockwise, so everything outside it is an obstacle, like that of "
            f"{boundary[0][0]}; one outer boundary is possible",
            boundary[1][0],
        )
    parts = Parts()
    for place, own in solid:
        parts.add_obstacles(polygons_of(own, place, notes), place)
    for place, ring in boundary:
        shapes = polygons_of([ring], place, notes)
        if len(shapes) != 1:
            raise SceneError("the outer boundary must be one polygon", place)
        parts.workspace = shapes[0]
    return parts


def _surrounds(outer: Ring, inner: Ring) -> bool:
    border = set(outer)
    return all(p in border or contains(outer, p) for p in inner)


def _extent(ring: Ring) -> float:
    xs, ys = zip(*ring, strict=True)
    return float((max(xs) - min(xs)) * (max(ys) - min(ys)))
