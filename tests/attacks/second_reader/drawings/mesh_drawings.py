"""Generated Collada worlds, written as text; imported as the world of an OMPL.app problem."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ..model import Drawing

Corner = tuple[float, float, float]


@dataclass(frozen=True)
class World:
    """Parts of a Collada file.

    `truth` has the outlines in the plane where the second reader is known to be wrong: pycollada
    cuts concave faces into fans and does not know controllers nor offsets in accessors.
    """

    geometries: str
    nodes: str
    library: str = ""
    up: str = "<up_axis>Y_UP</up_axis>"
    unit: str = ""
    truth: tuple[list[Corner], ...] = ()


Maker = Callable[[random.Random], World]
MAKERS: dict[str, Maker] = {}


def feature(make: Maker) -> Maker:
    """Register a maker under its name."""
    MAKERS[make.__name__] = make
    return make


def drawings(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield worlds, each feature in turn, as problems or as bare meshes with a footprint."""
    names = [name for name in MAKERS if only in name]
    for k in range(count):
        name = names[k % len(names)]
        world = MAKERS[name](rng)
        data = document(world).encode()
        hints = {"truth": world.truth} if world.truth else {}
        if name.startswith("bare"):
            options = {"robot": "robot.dae"} if name == "bare_with_robot" else {}
            files = {"world.dae": data, "robot.dae": _ROBOT.encode()}
            yield Drawing(name, "world.dae", files, options, hints=hints)
            continue
        problem = (
            "[problem]\nrobot=robot.dae\nworld=world.dae\n"
            "start.x=0\nstart.y=0\nstart.theta=0\ngoal.x=1\ngoal.y=0\ngoal.theta=0\n"
        )
        files = {"p.cfg": problem.encode(), "world.dae": data, "robot.dae": _ROBOT.encode()}
        yield Drawing(
            name, "p.cfg", files, {"start": None, "goal": None, "footprint": None}, hints=hints
        )


def document(world: World) -> str:
    """Return the text of a Collada file."""
    return (
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" '
        f'version="1.4.1"><asset><created>2020-01-01T00:00:00</created>'
        f"<modified>2020-01-01T00:00:00</modified>{world.unit}{world.up}</asset>"
        f"<library_geometries>{world.geometries}</library_geometries>{world.library}"
        f'<library_visual_scenes><visual_scene id="vs">{world.nodes}</visual_scene>'
        '</library_visual_scenes><scene><instance_visual_scene url="#vs"/></scene></COLLADA>'
    )


def geometry(corners: list[Corner], body: str, name: str = "g") -> str:
    """Return a geometry with positions and one group of faces."""
    numbers = " ".join(f"{v:g}" for corner in corners for v in corner)
    return (
        f'<geometry id="{name}"><mesh><source id="{name}p"><float_array id="{name}a" '
        f'count="{3 * len(corners)}">{numbers}</float_array><technique_common><accessor '
        f'source="#{name}a" count="{len(corners)}" stride="3"><param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
        f'</technique_common></source><vertices id="{name}v"><input semantic="POSITION" '
        f'source="#{name}p"/></vertices>{body}</mesh></geometry>'
    )


def group(kind: str, *runs: str, more: str = "") -> str:
    """Return a group of faces of the geometry ``g``, each run in a ``p`` of its own."""
    vertices = '<input semantic="VERTEX" source="#gv" offset="0"/>'
    return (
        f'<{kind} count="1">{vertices}{more}' + "".join(f"<p>{r}</p>" for r in runs) + f"</{kind}>"
    )


def triangles(indices: list[int], name: str = "g") -> str:
    """Return a group of triangles."""
    return (
        f'<triangles count="{len(indices) // 3}"><input semantic="VERTEX" source="#{name}v" '
        f'offset="0"/><p>{" ".join(map(str, indices))}</p></triangles>'
    )


def node(inner: str = "", name: str = "g") -> str:
    """Return a node that shows a geometry."""
    return f'<node id="n_{name}">{inner}<instance_geometry url="#{name}"/></node>'


def plate(rng: random.Random, up: str = "Y") -> list[Corner]:
    """Return a quadrilateral across the upward axis's plane of projection."""
    x, y, w = rng.randint(2, 20), rng.randint(2, 20), rng.randint(5, 20)
    flat = [(x, y), (x + w, y), (x + w, y + w / 2), (x, y + w)]
    if up == "Z":
        return [(px, -1.0, py) for px, py in flat]
    return [(px, py, 0.0) for px, py in flat]


_QUAD = [0, 1, 2, 0, 2, 3]
_ROBOT = document(
    World(
        geometry([(-0.01, -0.01, 0), (0.01, -0.01, 0), (0, 0.01, 0)], triangles([0, 1, 2])), node()
    )
)


@feature
def triangles_plain(rng: random.Random) -> World:
    return World(geometry(plate(rng), triangles(_QUAD)), node())


@feature
def polylist(rng: random.Random) -> World:
    body = group("polylist", "0 1 2 3", more="<vcount>4</vcount>")
    return World(geometry(plate(rng), body), node())


@feature
def polylist_concave(rng: random.Random) -> World:
    corners: list[Corner] = [
        (0, 0, 0),
        (30, 0, 0),
        (30, 30, 0),
        (15, rng.choice([5, 10]), 0),
        (0, 30, 0),
    ]
    body = group("polylist", "0 1 2 3 4", more="<vcount>5</vcount>")
    return World(geometry(corners, body), node(), truth=(corners,))


@feature
def polygons(rng: random.Random) -> World:
    body = group("polygons", "0 1 2", "0 2 3")
    return World(geometry(plate(rng), body), node())


@feature
def polygons_with_hole(rng: random.Random) -> World:
    outer: list[Corner] = [(0, 0, 0), (30, 0, 0), (30, 30, 0), (0, 30, 0)]
    inner: list[Corner] = [(10, 10, 0), (20, 10, 0), (20, 20, 0)]
    body = group("polygons", more="<ph><p>0 1 2 3</p><h>4 5 6</h></ph>")
    return World(geometry(outer + inner, body), node())


@feature
def tristrips(rng: random.Random) -> World:
    body = group("tristrips", "0 1 3 2")
    return World(geometry(plate(rng), body), node())


@feature
def trifans(rng: random.Random) -> World:
    body = group("trifans", "0 1 2 3")
    return World(geometry(plate(rng), body), node())


@feature
def lines_too(rng: random.Random) -> World:
    body = triangles(_QUAD) + group("lines", "0 2")
    return World(geometry(plate(rng), body), node())


@feature
def z_up(rng: random.Random) -> World:
    return World(geometry(plate(rng, "Z"), triangles(_QUAD)), node(), up="<up_axis>Z_UP</up_axis>")


@feature
def x_up(rng: random.Random) -> World:
    return World(geometry(plate(rng), triangles(_QUAD)), node(), up="<up_axis>X_UP</up_axis>")


@feature
def no_axis(rng: random.Random) -> World:
    return World(geometry(plate(rng), triangles(_QUAD)), node(), up="")


@feature
def solid_box(rng: random.Random) -> World:
    x, y, w = rng.randint(0, 20), rng.randint(0, 20), rng.randint(5, 20)
    corners = [(x + w * i, y + w * j, 3.0 * k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    faces = [0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6]
    turn = f"<rotate>{rng.choice(['0 0 1 30', '1 0 0 20', '0.6 0.8 0 10'])}</rotate>"
    return World(geometry(corners, triangles(faces)), node(turn))


@feature
def matrix(rng: random.Random) -> World:
    c, s = math.cos(0.4), math.sin(0.4)
    rows = rng.choice(
        [
            f"{c} {-s} 0 5 {s} {c} 0 7 0 0 1 0 0 0 0 1",
            "-1 0 0 40 0 1 0 0 0 0 1 0 0 0 0 1",
            "2 0 0 1 0 .5 0 2 0 0 1 3 0 0 0 1",
        ]
    )
    return World(geometry(plate(rng), triangles(_QUAD)), node(f"<matrix>{rows}</matrix>"))


@feature
def steps(rng: random.Random) -> World:
    parts = [
        "<translate>5 6 0</translate>",
        "<rotate>0 0 1 30</rotate>",
        "<scale>1.5 0.7 1</scale>",
    ]
    rng.shuffle(parts)
    return World(geometry(plate(rng), triangles(_QUAD)), node("".join(parts)))


@feature
def skew(rng: random.Random) -> World:
    return World(geometry(plate(rng), triangles(_QUAD)), node("<skew>30 1 0 0 0 1 0</skew>"))


@feature
def nested_nodes(rng: random.Random) -> World:
    inner = f"<node><rotate>0 0 1 45</rotate>{node('<scale>.5 .5 1</scale>')}</node>"
    move = f"<translate>{rng.randint(10, 30)} 5 0</translate>"
    shown = f'<node>{move}{inner}<instance_geometry url="#g"/></node>'
    return World(geometry(plate(rng), triangles(_QUAD)), shown)


@feature
def instance_twice(rng: random.Random) -> World:
    shown = node() + node("<translate>30 0 0</translate>").replace("n_g", "m_g")
    return World(geometry(plate(rng), triangles(_QUAD)), shown)


@feature
def instance_node(rng: random.Random) -> World:
    library = f"<library_nodes>{node('<rotate>0 0 1 20</rotate>')}</library_nodes>"
    move, again = "<translate>20 10 0</translate>", '<instance_node url="#n_g"/>'
    shown = f"<node>{move}{again}</node><node>{again}</node>"
    return World(geometry(plate(rng), triangles(_QUAD)), shown, library)


@feature
def unit_scale(rng: random.Random) -> World:
    unit = rng.choice(
        [
            '<unit meter="0.0254" name="inch"/>',
            '<unit meter="0.01"/>',
            "<unit/>",
            '<unit name="meter" meter="1"/>',
        ]
    )
    return World(geometry(plate(rng), triangles(_QUAD)), node(), unit=unit)


@feature
def two_geometries(rng: random.Random) -> World:
    both = geometry(plate(rng), triangles(_QUAD)) + geometry(plate(rng), triangles(_QUAD, "h"), "h")
    return World(both, node() + node("", "h"))


@feature
def not_shown(rng: random.Random) -> World:
    """A geometry that no node shows."""
    both = geometry(plate(rng), triangles(_QUAD)) + geometry(plate(rng), triangles(_QUAD, "h"), "h")
    return World(both, node())


@feature
def two_groups(rng: random.Random) -> World:
    corners = [*plate(rng), (60.0, 60.0, 0.0), (80.0, 60.0, 0.0), (60.0, 80.0, 0.0)]
    return World(geometry(corners, triangles(_QUAD) + triangles([4, 5, 6])), node())


@feature
def more_inputs(rng: random.Random) -> World:
    body = (
        '<source id="gn"><float_array id="gna" count="3">0 0 1</float_array><technique_common>'
        '<accessor source="#gna" count="1" stride="3"><param name="X" type="float"/>'
        '<param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
        "</technique_common></source>"
    )
    faces = " ".join(f"{i} 0" for i in _QUAD)
    faces_and_normals = (
        '<triangles count="2"><input semantic="VERTEX" source="#gv" offset="0"/>'
        f'<input semantic="NORMAL" source="#gn" offset="1"/><p>{faces}</p></triangles>'
    )
    text = geometry(plate(rng), faces_and_normals).replace("<vertices", body + "<vertices")
    return World(text, node())


@feature
def overlapping(rng: random.Random) -> World:
    corners: list[Corner] = [
        (0, 0, 0),
        (30, 0, 0),
        (0, 30, 0),
        (10, -5, 2),
        (40, 10, 2),
        (10, 40, 2),
    ]
    return World(geometry(corners, triangles([0, 1, 2, 3, 4, 5])), node())


@feature
def hole_in_mesh(rng: random.Random) -> World:
    """A ring of triangles round a square that no triangle covers."""
    outer: list[Corner] = [(0, 0, 0), (30, 0, 0), (30, 30, 0), (0, 30, 0)]
    inner: list[Corner] = [(10, 10, 0), (20, 10, 0), (20, 20, 0), (10, 20, 0)]
    faces = []
    for k in range(4):
        n = (k + 1) % 4
        faces += [k, n, 4 + n, k, 4 + n, 4 + k]
    return World(geometry(outer + inner, triangles(faces)), node())


@feature
def controller(rng: random.Random) -> World:
    """A skinned mesh is shown by a controller."""
    library = '<controller id="c"><skin source="#g"><joints/></skin></controller>'
    library = f"<library_controllers>{library}</library_controllers>"
    one, two = plate(rng), plate(rng)
    both = geometry(one, triangles(_QUAD)) + geometry(two, triangles(_QUAD, "h"), "h")
    return World(
        both,
        node("", "h") + '<node><instance_controller url="#c"/></node>',
        library,
        truth=(one, two),
    )


@feature
def accessor_offset(rng: random.Random) -> World:
    corners = plate(rng)
    text = geometry([(99.0, 99.0, 0.0), *corners], triangles(_QUAD))
    text = text.replace('count="5" stride="3"', 'count="4" offset="3" stride="3"')
    return World(text, node(), truth=(corners,))


@feature
def accessor_gap(rng: random.Random) -> World:
    """Params without a name are skipped."""
    corners = plate(rng)
    text = geometry(corners, triangles(_QUAD))
    flat = text.replace(
        '<param name="X" type="float"/>', '<param type="float"/><param name="X" type="float"/>'
    )
    flat = flat.replace('stride="3"', 'stride="4"').replace('count="12"', 'count="16"')
    begin, end = flat.index('count="16">') + len('count="16">'), flat.index("</float_array>")
    words = flat[begin:end].split()
    wide = " ".join(f"9 {' '.join(words[i : i + 3])}" for i in range(0, len(words), 3))
    return World(flat[:begin] + wide + flat[end:], node(), truth=(corners,))


@feature
def second_scene(rng: random.Random) -> World:
    """The scene that is instanced is not the first."""
    world = World(geometry(plate(rng), triangles(_QUAD)), "")
    shown = f'</visual_scene><visual_scene id="vt">{node("<translate>30 0 0</translate>")}'
    return World(world.geometries, node() + shown)


@feature
def bare_with_robot(rng: random.Random) -> World:
    return triangles_plain(rng)


@feature
def bare_with_footprint(rng: random.Random) -> World:
    return triangles_plain(rng)
