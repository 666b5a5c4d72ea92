"""Generated well-known text and GeoJSON; geometries without a role are obstacles."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator
from typing import Any

from ..model import Drawing

Ring = list[list[float]]
Geometry = dict[str, Any]
Maker = Callable[[random.Random], "tuple[str, dict[str, Any]]"]

GEOJSON: dict[str, Callable[[random.Random], tuple[Any, dict[str, Any]]]] = {}
WKT: dict[str, Callable[[random.Random], tuple[str, dict[str, Any]]]] = {}
TOLD = r"left out|ignored|skipped|not read|outside|null|Line|Point|empty|EMPTY|moved by"


def square(x: float, y: float, w: float) -> Ring:
    """Return a closed ring, anticlockwise."""
    return [[x, y], [x + w, y], [x + w, y + w], [x, y + w], [x, y]]


def place(rng: random.Random) -> tuple[float, float, float]:
    """Return a random lower left corner and width."""
    return rng.randint(0, 50), rng.randint(0, 50), rng.randint(10, 40)


def polygon(*rings: Ring) -> Geometry:
    """Return a Polygon."""
    return {"type": "Polygon", "coordinates": list(rings)}


def shapes(rng: random.Random) -> dict[str, tuple[list[Ring], dict[str, Any]]]:
    """Return rings that both formats can write, by feature, with hints."""
    x, y, w = place(rng)
    shell = square(x, y, w)
    quarter = w / 4
    hole = square(x + quarter, y + quarter, quarter)
    turned = hole[::-1]
    return {
        "plain": ([rng.choice([shell, shell[::-1]])], {}),
        "hole": ([shell, rng.choice([hole, turned])], {}),
        "two_holes": ([square(0, 0, 60), square(5, 5, 10), square(30, 30, 20)], {}),
        "hole_outside": ([shell, square(x + 2 * w, y, w / 2)], {"must_say": TOLD}),
        "hole_crosses": ([shell, square(x + w / 2, y + quarter, w)], {"must_say": TOLD}),
        "hole_is_shell": ([shell, shell[::-1]], {"must_say": TOLD}),
        "hole_around_shell": ([shell, square(x - 5, y - 5, w + 10)], {"must_say": TOLD}),
        "hole_touches_corner": ([shell, [[x, y], [x + 9, y + 3], [x + 3, y + 9], [x, y]]], {}),
        "hole_touches_edge": (
            [shell, [[x, y + 5], [x + 9, y + 3], [x + 9, y + 8], [x, y + 5]]],
            {},
        ),
        "hole_shares_edge": ([shell, square(x, y + quarter, quarter)], {}),
        "hole_touches_twice": (
            [square(0, 0, 60), [[0, 30], [30, 0], [60, 30], [30, 60], [0, 30]]],
            {},
        ),
        "holes_touch": ([square(0, 0, 60), square(10, 10, 15), square(25, 25, 15)], {}),
        "holes_share_edge": ([square(0, 0, 60), square(10, 10, 15), square(25, 10, 15)], {}),
        "holes_overlap": ([square(0, 0, 60), square(10, 10, 15), square(20, 20, 15)], {}),
        "hole_in_hole": ([square(0, 0, 60), square(10, 10, 40), square(20, 20, 10)], {}),
        "hole_twice": ([square(0, 0, 60), square(10, 10, 20), square(10, 10, 20)], {}),
        "bow_tie": ([[[0, 0], [40, 40], [40, 0], [0, 40], [0, 0]]], {}),
        "spike": ([[[0, 0], [40, 0], [60, 0], [40, 0], [40, 40], [0, 40], [0, 0]]], {}),
        "repeated_points": ([[p for p in shell for _ in (0, 1)]], {}),
        "bridge": (
            [
                [
                    [0, 0], [60, 0], [60, 60], [0, 60], [0, 0],
                    [20, 20], [20, 40], [40, 40], [40, 20], [20, 20], [0, 0],
                ]
            ],
            {},
        ),
        "figure_eight": (
            [[[0, 0], [20, 0], [20, 20], [40, 20], [40, 40], [20, 40], [20, 20], [0, 20], [0, 0]]],
            {},
        ),
        "shell_twice": ([shell[:-1] + shell], {}),
        "line_ring": ([[[0, 0], [10, 0], [20, 0], [0, 0]], ], {"extra": shell}),
        "not_closed": ([shell[:-1]], {}),
    }  # fmt: skip


SHARED = tuple(shapes(random.Random(0)))


def drawings_wkt(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield WKT files, each feature in turn."""
    names = [name for name in (*SHARED, *WKT) if only in name]
    for k in range(count):
        name = names[k % len(names)]
        if name in WKT:
            text, hints = WKT[name](rng)
        else:
            rings, hints = shapes(rng)[name]
            text = "\n".join(_wkt([r]) for r in [hints["extra"]]) if "extra" in hints else ""
            text = f"{_wkt(rings)}\n{text}\n"
        yield Drawing(
            name,
            "d.wkt",
            {"d.wkt": text.encode()},
            hints.get("ends", {}),
            hints.get("must_say", ""),
            TOLD,
            hints,
        )


def drawings_geojson(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield GeoJSON files, each feature in turn."""
    names = [name for name in (*SHARED, *GEOJSON) if only in name]
    for k in range(count):
        name = names[k % len(names)]
        if name in GEOJSON:
            content, hints = GEOJSON[name](rng)
        else:
            rings, hints = shapes(rng)[name]
            content = _wrapped(
                [polygon(*rings)] + ([polygon(hints["extra"])] if "extra" in hints else []), rng
            )
        data = json.dumps(content).encode()
        yield Drawing(
            name,
            "d.geojson",
            {"d.geojson": data},
            hints.get("ends", {}),
            hints.get("must_say", ""),
            TOLD,
            hints,
        )


def _wkt(rings: list[Ring], kind: str = "POLYGON") -> str:
    body = ", ".join("(" + ", ".join(f"{x} {y}" for x, y in ring) + ")" for ring in rings)
    return f"{kind} ({body})"


def _wrapped(geometries: list[Geometry], rng: random.Random) -> Any:
    features = [{"type": "Feature", "properties": {}, "geometry": g} for g in geometries]
    if len(geometries) == 1:
        return rng.choice(
            [geometries[0], features[0], {"type": "FeatureCollection", "features": features}]
        )
    return {"type": "FeatureCollection", "features": features}


def wkt(make: Callable[[random.Random], str | tuple[str, dict[str, Any]]]) -> Any:
    """Register a maker of WKT."""

    def full(rng: random.Random) -> tuple[str, dict[str, Any]]:
        made = make(rng)
        return made if isinstance(made, tuple) else (made, {})

    WKT[make.__name__.removeprefix("wkt_")] = full
    return make


def geojson(make: Callable[[random.Random], Any]) -> Any:
    """Register a maker of GeoJSON."""

    def full(rng: random.Random) -> tuple[Any, dict[str, Any]]:
        made = make(rng)
        return made if isinstance(made, tuple) else (made, {})

    GEOJSON[make.__name__.removeprefix("json_")] = full
    return make


# ---- well-known text --------------------------------------------------------------------------


@wkt
def wkt_letters(rng: random.Random) -> str:
    text = _wkt([square(*place(rng))])
    return rng.choice([text.lower(), text.capitalize(), text.replace("POLYGON", "PolyGon")])


@wkt
def wkt_spaces(rng: random.Random) -> str:
    text = _wkt([square(*place(rng)), square(200, 200, 3)][:1])
    return rng.choice(
        [
            text.replace(" (", "("),
            text.replace("(", " ( ").replace(")", " ) ").replace(",", " , "),
            text.replace(", ", ",\n  "),
            text.replace(", ", ",\t"),
            text + ";",
            "\n\n" + text + "\r\n",
            "\ufeff" + text,
        ]
    )


@wkt
def wkt_dimensions(rng: random.Random) -> str:
    kind, extra = rng.choice(
        [
            ("POLYGON Z", " 5"),
            ("POLYGONZ", " 5"),
            ("POLYGON M", " 5"),
            ("POLYGONM", " 5"),
            ("POLYGON ZM", " 5 6"),
            ("POLYGONZM", " 5 6"),
            ("POLYGON", " 5"),
            ("polygon z", " -1"),
        ]
    )
    points = ", ".join(f"{x:g} {y:g}{extra}" for x, y in square(*place(rng)))
    return f"{kind} (({points}))"


@wkt
def wkt_empty(rng: random.Random) -> str:
    empty = rng.choice(
        [
            "POLYGON EMPTY",
            "MULTIPOLYGON EMPTY",
            "POLYGON Z EMPTY",
            "GEOMETRYCOLLECTION EMPTY",
            "polygon empty",
        ]
    )
    return f"{empty}\n{_wkt([square(*place(rng))])}"


@wkt
def wkt_multi(rng: random.Random) -> str:
    a, b = [_wkt([square(*place(rng))]).removeprefix("POLYGON ") for _ in (0, 1)]
    hole = _wkt([square(60, 60, 30), square(70, 70, 5)]).removeprefix("POLYGON ")
    kind = rng.choice(["MULTIPOLYGON", "MultiPolygon", "MULTIPOLYGON Z"])
    if kind.endswith("Z"):
        a, b, hole = (
            t.replace(",", " 1,")
            .replace("))", " 1))")
            .replace("), (", " 1), (")
            .replace(") 1,", " 1),")
            for t in (a, b, hole)
        )
        return f"MULTIPOLYGON ({a}, {b}, {hole})".replace(" 1", "")
    return f"{kind} ({a}, {b}, {hole})"


@wkt
def wkt_multi_with_empty(rng: random.Random) -> str:
    a = _wkt([square(*place(rng))]).removeprefix("POLYGON ")
    return f"MULTIPOLYGON ({a}, EMPTY)"


@wkt
def wkt_collection(rng: random.Random) -> tuple[str, dict[str, Any]]:
    a, b = (_wkt([square(*place(rng))]) for _ in (0, 1))
    inner = rng.choice(
        [
            b,
            f"GEOMETRYCOLLECTION ({b})",
            f"LINESTRING (0 0, 1 1), {b}",
            f"POINT (1 2), {b}",
            "POLYGON EMPTY, " + b,
        ]
    )
    said = TOLD if "LINE" in inner or "POINT" in inner else ""
    return f"GEOMETRYCOLLECTION ({a}, {inner})", {"must_say": said}


@wkt
def wkt_others(rng: random.Random) -> tuple[str, dict[str, Any]]:
    other = rng.choice(
        [
            "LINESTRING (0 0, 50 50)",
            "POINT (3 4)",
            "MULTIPOINT ((3 4))",
            "MULTILINESTRING ((0 0, 9 9))",
            "LINEARRING (0 0, 9 0, 9 9, 0 0)",
        ]
    )
    return f"{_wkt([square(*place(rng))])}\n{other}", {"must_say": TOLD}


@wkt
def wkt_curves(rng: random.Random) -> tuple[str, dict[str, Any]]:
    """Kinds with area that shapely does not know: read or refused, never dropped."""
    other = rng.choice(
        [
            "TRIANGLE ((60 60, 90 60, 60 90, 60 60))",
            "CURVEPOLYGON ((60 60, 90 60, 60 90, 60 60))",
            "TIN (((60 60, 90 60, 60 90, 60 60)))",
            "POLYHEDRALSURFACE (((60 60, 90 60, 60 90, 60 60)))",
        ]
    )
    return f"{_wkt([square(*place(rng))])}\n{other}", {"triangle": True}


@wkt
def wkt_srid(rng: random.Random) -> str:
    return f"SRID=4326;{_wkt([square(*place(rng))])}"


@wkt
def wkt_numbers(rng: random.Random) -> str:
    return rng.choice(
        [
            "POLYGON ((1e1 0, 3E+1 0, 30. 20, 10 .2e2, 1e1 0))",
            "POLYGON ((+1 0, 30 -0.0, 30 20, 10 20, +1 0))",
            "POLYGON ((1d1 0, 30 0, 30 20, 1d1 0))",
        ]
    )


@wkt
def wkt_several_a_line(rng: random.Random) -> str:
    return f"{_wkt([square(0, 0, 20)])}; {_wkt([square(40, 40, 20)])}"


@wkt
def wkt_far(rng: random.Random) -> tuple[str, dict[str, Any]]:
    return _far(rng, _wkt)


# ---- GeoJSON ----------------------------------------------------------------------------------


def _far(rng: random.Random, make: Callable[[list[Ring]], Any]) -> Any:
    x, y = rng.choice([(500000.25, 4649776.5), (-1e7, 3.0), (5e5 + 0.1, 4649776.3)])
    ends = {"start": [x - 1, y, 0.0], "goal": [x - 1, y + 3, 0.0]}
    return make([square(x, y, 3), square(x + 1, y + 1, 0.5)]), {"ends": ends}


@geojson
def json_multi(rng: random.Random) -> Any:
    coordinates = [[square(*place(rng))], [square(60, 60, 30), square(70, 70, 5)]]
    return {"type": "MultiPolygon", "coordinates": coordinates}


@geojson
def json_multi_overlapping(rng: random.Random) -> Any:
    return {"type": "MultiPolygon", "coordinates": [[square(0, 0, 30)], [square(15, 15, 30)]]}


@geojson
def json_multi_nested(rng: random.Random) -> Any:
    """An island in the hole of another polygon."""
    ring = [square(0, 0, 60), square(10, 10, 40)]
    return {"type": "MultiPolygon", "coordinates": [ring, [square(20, 20, 10)]]}


@geojson
def json_collection(rng: random.Random) -> Any:
    inner = rng.choice(
        [
            [polygon(square(60, 60, 20))],
            [{"type": "GeometryCollection", "geometries": [polygon(square(60, 60, 20))]}],
            [{"type": "MultiPolygon", "coordinates": [[square(60, 60, 20)]]}],
            [{"type": "Point", "coordinates": [1, 2]}],
            [{"type": "LineString", "coordinates": [[1, 2], [3, 4]]}],
            [],
        ]
    )
    said = TOLD if inner and inner[0]["type"] in ("Point", "LineString") else ""
    content = {"type": "GeometryCollection", "geometries": [polygon(square(0, 0, 20)), *inner]}
    return content, {"must_say": said}


@geojson
def json_null(rng: random.Random) -> Any:
    features = [
        {"type": "Feature", "properties": rng.choice([None, {}]), "geometry": None},
        {"type": "Feature", "properties": {}, "geometry": polygon(square(*place(rng)))},
    ]
    return {"type": "FeatureCollection", "features": features}, {"must_say": TOLD}


@geojson
def json_others(rng: random.Random) -> Any:
    other = rng.choice(
        [
            {"type": "LineString", "coordinates": [[0, 0], [9, 9]]},
            {"type": "MultiLineString", "coordinates": [[[0, 0], [9, 9]]]},
            {"type": "Point", "coordinates": [4, 4]},
            {"type": "MultiPoint", "coordinates": [[4, 4]]},
        ]
    )
    features = [
        {"type": "Feature", "properties": {}, "geometry": g}
        for g in (polygon(square(*place(rng))), other)
    ]
    return {"type": "FeatureCollection", "features": features}, {"must_say": TOLD}


@geojson
def json_empty(rng: random.Random) -> Any:
    empty = rng.choice(
        [
            polygon(),
            {"type": "MultiPolygon", "coordinates": []},
            {"type": "GeometryCollection", "geometries": []},
        ]
    )
    features = [
        {"type": "Feature", "properties": {}, "geometry": g}
        for g in (empty, polygon(square(*place(rng))))
    ]
    return {"type": "FeatureCollection", "features": features}


@geojson
def json_altitude(rng: random.Random) -> Any:
    ring = [[*p, *rng.choice([[7], [7, 8]])] for p in square(*place(rng))]
    return polygon(ring)


@geojson
def json_members(rng: random.Random) -> Any:
    """Members that other programs write."""
    return {
        "type": "FeatureCollection",
        "name": "n",
        "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}},
        "bbox": [0, 0, 90, 90],
        "features": [
            {
                "type": "Feature",
                "id": 7,
                "bbox": [0, 0, 9, 9],
                "properties": {"name": "wall", "height": 3},
                "geometry": {**polygon(square(*place(rng))), "bbox": [0, 0, 9, 9]},
            }
        ],
    }


@geojson
def json_role_null(rng: random.Random) -> Any:
    role = rng.choice([None, "building", 3, "Obstacle", "obstacles"])
    return {
        "type": "Feature",
        "properties": {"role": role},
        "geometry": polygon(square(*place(rng))),
    }


@geojson
def json_far(rng: random.Random) -> Any:
    return _far(rng, lambda rings: polygon(*rings))


@geojson
def json_big_integers(rng: random.Random) -> Any:
    return polygon([[int(x), int(y)] for x, y in square(*place(rng))])


@geojson
def json_newlines(rng: random.Random) -> Any:
    """Kept plain: lines of features (GeoJSONSeq) are refused by name elsewhere."""
    return {"type": "Feature", "geometry": polygon(square(*place(rng)))}


@geojson
def json_degrees(rng: random.Random) -> Any:
    """Longitude and latitude: lengths are degrees, which a note should say."""
    lon, lat = 13.4, 52.5
    return polygon(square(lon, lat, 0.001))
