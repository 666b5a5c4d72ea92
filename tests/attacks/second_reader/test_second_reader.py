"""The second readers are right where the truth is known by hand, and the judge notices faults.

Whether the importers agree is the runs' business (``run.py``): here the oracle itself is tested,
and that every feature without a known fault stays without one.
"""

from __future__ import annotations

import itertools
import json
import random
from collections.abc import Sequence

import numpy as np
import pytest
import shapely

from . import known_faults
from .formats import FORMATS, outcomes
from .importer import Import
from .judge import Reader, compared, difference
from .model import Drawing, Exact, Raster, Reading, Verdict
from .readers import svg_reader

NEEDED = {
    "svg": "resvg_py",
    "dxf": "ezdxf",
    "map": "yaml",
    "mesh": "trimesh",
    "wkt": "shapely",
    "geojson": "shapely",
    "yap": "shapely",
    "tpcap": "shapely",
    "discopygal": "shapely",
    "dynobench": "yaml",
    "octile": "shapely",
}
SEED = 1
EACH = 2  # drawings a feature


def exact(region: shapely.Geometry, must_say: str = "") -> list[Reading]:
    return [Reading("by hand", Exact(region, 1e-9), must_say)]


def verdict(
    region: shapely.Geometry, readings: Sequence[Reading], *notes: str, must_say: str = ""
) -> Verdict:
    drawing = Drawing("by hand", "d.wkt", {}, must_say=must_say)
    return compared(drawing, Import(region, notes), readings)[0]


def test_the_judge_tells_agreement_from_silence_and_from_what_is_said() -> None:
    one, two = shapely.box(0, 0, 10, 10), shapely.box(0, 0, 11, 10)
    assert verdict(one, exact(one)) is Verdict.AGREED
    assert verdict(two, exact(one)) is Verdict.SILENT
    assert verdict(two, exact(one), "elements without a role ignored: 1") is Verdict.SILENT
    assert verdict(two, exact(one), "hidden things left out: 1") is Verdict.TOLD
    assert verdict(one, exact(one), must_say="hidden") is Verdict.UNTOLD
    assert verdict(one, exact(one), "hidden things: 1", must_say="hidden") is Verdict.AGREED
    assert verdict(one, exact(one, "unit")) is Verdict.UNTOLD


def test_equal_areas_in_other_places_differ() -> None:
    truth = Exact(shapely.box(0, 0, 10, 10), 0.1)
    assert difference(shapely.box(5, 0, 15, 10), truth)
    assert not difference(shapely.box(0.05, 0, 10.05, 10), truth)


def test_a_thin_rim_all_round_is_a_difference_of_area() -> None:
    truth = Exact(shapely.box(0, 0, 10, 10), 0.1)
    assert not difference(shapely.box(0, 0, 10, 10).buffer(0.09, join_style="mitre"), truth)
    assert difference(shapely.box(0, 0, 10, 10).buffer(0.25, join_style="mitre"), truth)


def test_a_raster_is_compared_cell_by_cell() -> None:
    x, y = np.meshgrid(np.arange(10) + 0.5, np.arange(10) + 0.5)
    filled = (x < 5) & (y < 5)
    exactly = Raster(filled, x, y, 1.0, 0.0)
    assert not difference(shapely.box(0, 0, 5, 5), exactly)
    assert difference(shapely.box(0, 0, 6, 5), exactly)
    assert difference(shapely.box(0, 0, 5.4, 5), exactly)  # no centre differs, but the area does
    softly = Raster(filled, x, y, 1.0, 1.0)
    assert not difference(shapely.box(0, 0, 6, 5), softly)
    assert difference(shapely.box(0, 0, 5, 5).union(shapely.box(6, 6, 10, 10)), softly)


def test_the_dxf_reader_fills_outlines_holes_and_hatches() -> None:
    pytest.importorskip("ezdxf")
    from .readers.dxf_reader import _filled

    def square(x: float, w: float) -> list[tuple[float, float]]:
        return [(x, x), (x + w, x), (x + w, x + w), (x, x + w), (x, x)]

    assert _filled([square(0, 10)], []).area == pytest.approx(100)
    assert _filled([square(0, 10), square(2, 4)], []).area == pytest.approx(84)
    assert _filled([square(0, 10), square(2, 6), square(3, 2)], []).area == pytest.approx(68)
    sides = [list(side) for w in (square(0, 10), square(2, 4)) for side in itertools.pairwise(w)]
    assert _filled(sides, []).area == pytest.approx(84)
    assert _filled(sides[:3], []).area == 0
    assert _filled([], [shapely.box(0, 0, 2, 2)]).area == 4


def test_the_map_reader_averages_opacity_as_the_older_server_does() -> None:
    pytest.importorskip("PIL")
    from .readers.map_reader import _occupied

    hints = {"mode": "trinary", "occupied": 0.65, "free": 0.25, "negate": False}
    colours = np.array([[[0.0], [0.0], [1.0], [1.0]]])
    opacity = np.array([[1.0, 0.0, 1.0, 0.0]])
    drawing = Drawing("by hand", "map.yaml", {}, {"unknown": False}, hints=hints)
    older = _occupied(drawing, colours, opacity, newer=False)
    assert older.tolist() == [[True, True, False, False]]
    newer = _occupied(drawing, colours, opacity, newer=True)
    assert newer.tolist() == [[True, False, False, False]]
    also = Drawing("by hand", "map.yaml", {}, {"unknown": True}, hints=hints)
    assert _occupied(also, colours, opacity, newer=False).tolist() == [[True, True, False, True]]


def test_the_mesh_reader_turns_the_upward_axis_and_takes_the_unit() -> None:
    pytest.importorskip("trimesh")
    pytest.importorskip("collada")
    from .drawings.mesh_drawings import World, document, geometry, node, triangles
    from .readers.mesh_reader import projected

    flat = geometry([(0, -5, 0), (4, -5, 0), (0, -5, 2)], triangles([0, 1, 2]))
    world = World(flat, node(), up="<up_axis>Z_UP</up_axis>", unit='<unit meter="0.5"/>')
    region = projected(document(world).encode())
    assert region.bounds == pytest.approx((0, 0, 2, 1))
    assert region.area == pytest.approx(1)


def test_the_readers_of_the_fields_formats_see_what_is_written() -> None:
    from .readers import field_reader

    def region(read: Reader, text: str, **options: object) -> shapely.Geometry:
        (reading,) = read(Drawing("by hand", "f", {"f": text.encode()}, options))
        assert isinstance(reading.truth, Exact)
        return reading.truth.region

    frame = "0 0\n4 0\n4 4\n0 4\n1 1\n1 2\n2 2\n2 1\n"
    yap = region(field_reader.read_yap, f"8\n{frame}2\n5 6 7 8\n1 2 \\\n3 4 # outer\n")
    assert yap.equals(shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2))
    tpcap = region(field_reader.read_tpcap, "0,0,0,1,1,0,2,3,4,0,0,2,0,0,2,5,5,5,6,6,6,6,5")
    assert tpcap.area == 3
    discs = {"location": [1, 2], "radius": 2}, {"poly": [[9, 9], [10, 9], [10, 10]]}
    scene = json.dumps({"obstacles": discs})
    disco = region(field_reader.read_discopygal, scene, tolerance=0.1)
    assert disco.area == pytest.approx(4 * np.pi + 0.5)
    assert disco.bounds == (-1, 0, 10, 10)
    (cells,) = field_reader.read_octile(
        Drawing("by hand", "f", {"f": b"type octile\nheight 2\nwidth 3\nmap\n.@G\nS.W\n"})
    )
    assert isinstance(cells.truth, Raster)
    blocked = cells.truth.filled
    assert sorted(zip(cells.truth.x[blocked], cells.truth.y[blocked], strict=True)) == [
        (1.5, 1.5),
        (2.5, 0.5),
    ]
    pytest.importorskip("yaml")
    boxes = "environment:\n  obstacles:\n  - {type: box, size: [2, 1], center: [3, 4]}\n"
    assert region(field_reader.read_dynobench, boxes).equals(shapely.box(2, 3.5, 4, 4.5))


@pytest.mark.parametrize("name", FORMATS)
def test_features_without_a_known_fault_have_none(name: str) -> None:
    """A mended feature leaves its line in `known_faults`; the line has to go."""
    pytest.importorskip(NEEDED[name])
    if name == "svg":
        pytest.importorskip("selenium")
        if svg_reader.browser() is None:
            pytest.skip("resvg alone does not know all of CSS: no Chromium here")
    known = known_faults.OF[name]
    wrong: dict[str, str] = {}
    features = FORMATS[name].features()
    for outcome in outcomes(name, random.Random(SEED), EACH * len(features)):
        if outcome.verdict in (Verdict.SILENT, Verdict.CRASHED):
            wrong.setdefault(outcome.drawing.feature, outcome.detail)
    assert {k: v for k, v in wrong.items() if k not in known} == {}
    assert known - wrong.keys() == set(), "mended: take these lines out of known_faults"
