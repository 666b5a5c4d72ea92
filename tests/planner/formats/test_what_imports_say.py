"""What every importer says: what became of the file's things, its units, and what it guessed."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_planner import ImportOptions, SceneError, load_scene
from planar_planner.formats.registry import FORMATS
from support.format_help import read
from worlds.outside_files.dxf import box as dxf_box
from worlds.outside_files.dxf import dxf

FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
ENDS = {"start": [40.0, 40.0, 0.0], "goal": [60.0, 60.0, 0.0]}
BODY = "[[0, 0], [1, 0], [0, 1]]"
SQUARE = "0 0, 9 0, 9 9, 0 9, 0 0"
FLAT = "0 0, 1 0, 2 0, 0 0"


def svg(inside: str, head: str = "") -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{inside}</svg>'


def geojson(*features: str, more: str = "") -> str:
    return '{"type": "FeatureCollection", ' + more + '"features": [' + ", ".join(features) + "]}"


def feature(kind: str, coordinates: str, role: str = "") -> str:
    geometry = f'{{"type": "{kind}", "coordinates": {coordinates}}}' if kind else "null"
    properties = f'{{"role": "{role}"}}' if role else "{}"
    return f'{{"type": "Feature", "properties": {properties}, "geometry": {geometry}}}'


RECT = '<rect id="obstacle" width="9" height="9"/>'
AREA = "[[[0, 0], [9, 0], [9, 9], [0, 9]]]"

FEW: dict[str, tuple[str, str, int, str]] = {
    # name: file's ending, content, things that become nothing, something else that is said
    "wkt": ("wkt", f"POLYGON (({SQUARE}))\nLINESTRING (0 0, 1 1)", 1, "without a role taken"),
    "wkt point": ("wkt", f"POLYGON (({SQUARE}))\nobstacle POINT (1 1)", 1, "POINT geometries"),
    "wkt flat": ("wkt", f"POLYGON (({SQUARE}))\nPOLYGON (({FLAT}))", 1, "rings without area"),
    "wkt srid": ("wkt", f"SRID=4326;POLYGON (({SQUARE}))", 0, "SRID=4326 is not used"),
    "wkt z": ("wkt", "POLYGON Z ((0 0 5, 9 0 5, 9 9 5, 0 0 5))", 0, "only x and y are read: 4"),
    "geojson": ("geojson", geojson(feature("Polygon", AREA), feature("", "")), 1, "(null)"),
    "geojson role": ("geojson", geojson(feature("Polygon", AREA)), 0, "without a role taken as"),
    "geojson crs": (
        "geojson",
        geojson(feature("Polygon", AREA), more='"crs": {"properties": {"name": "EPSG:3857"}}, '),
        0,
        "EPSG:3857",
    ),
    "geojson z": (
        "geojson",
        geojson(feature("Polygon", "[[[0, 0, 1], [9, 0, 1], [9, 9, 1]]]")),
        0,
        "only x and y are read: 3",
    ),
    "txt": ("txt", "4\n0 0\n9 0\n9 9\n0 9\n2\n1 2 3 4\n1 2\n", 1, "rings without area"),
    "csv": ("csv", "1,1,0,60,60,0,2,3,3,20,20,29,20,20,29,30,30,31,30,32,30", 1, "car"),
    "svg hidden": ("svg", svg(RECT + RECT.replace("id", 'display="none" id')), 1, "does not show"),
    "svg flat": ("svg", svg(RECT + '<line id="obstacle" x2="9"/>'), 1, "does not show"),
    "svg text": ("svg", svg(RECT + '<text x="1">words</text>'), 1, "texts, images"),
    "svg ignored": (
        "svg",
        svg(RECT + '<rect id="ignore" width="1" height="1"/>'),
        1,
        "role ignore",
    ),
    "svg nameless": ("svg", svg(RECT + '<rect width="1" height="1"/>'), 1, "without a role"),
    "svg lost use": ("svg", svg(RECT + '<use class="obstacle" href="#x"/>'), 1, "without a target"),
    "svg size": ("svg", svg(RECT, 'width="10mm" height="10mm"'), 0, "not mm"),
    "svg box": ("svg", svg(RECT, 'width="10mm" height="9mm" viewBox="0 0 1 1"'), 0, "viewBox"),
}


def dxf_of(*draws: tuple[str, str], units: int = 0) -> str:
    def draw(space: object) -> None:
        dxf_box(space, "obstacle", 0, 0, 9, 9)
        for layer, kind in draws:
            own = {"layer": layer} | ({"invisible": 1} if kind == "hidden" else {})
            if kind == "point":
                space.add_point((1, 1), dxfattribs=own)
            elif kind == "text":
                space.add_text("words", dxfattribs=own)
            else:
                space.add_line((0, 20), (5, 20), dxfattribs=own)
        space.doc.header["$INSUNITS"] = units

    return dxf(draw, ends=False)


DRAWINGS = {
    "dxf hidden": ((("obstacle", "hidden"),), 1, "not shown"),
    "dxf point": ((("obstacle", "point"),), 1, "points ignored"),
    "dxf text": ((("obstacle", "text"),), 1, "texts and dimensions"),
    "dxf layer": ((("steel", "line"),), 1, "layers without a role: 'steel'"),
    "dxf ignored": ((("ignore", "line"),), 1, "role ignore"),
}


@pytest.mark.parametrize("name", [*FEW, *DRAWINGS])
def test_what_became_of_the_things_of_a_file(name: str, tmp_path: Path) -> None:
    if name in FEW:
        ending, content, nothing, more = FEW[name]
    else:
        draws, nothing, more = DRAWINGS[name]
        ending, content = "dxf", dxf_of(*draws)
    missing = {} if ending == "csv" else ENDS | {"footprint": BODY}
    said = read(tmp_path / f"f.{ending}", content, **missing).notes
    count = f"1 obstacle, robot of 1 polygon, {nothing} of the file's things became nothing"
    assert count in said
    assert any(more in line for line in said), said


@pytest.mark.parametrize(("unit", "name"), [(4, "millimetres"), (1, "inches"), (0, "")])
def test_units_of_a_dxf_drawing(unit: int, name: str, tmp_path: Path) -> None:
    said = read(tmp_path / "f.dxf", dxf_of(units=unit), footprint=BODY, **ENDS).notes
    assert any("$INSUNITS" in line and name in line for line in said) == (unit != 0)


def test_meshes_say_unit_axis_and_projection(tmp_path: Path) -> None:
    world = (FAULTS / "world.dae").read_text()
    options = ImportOptions(**ENDS, footprint=BODY)
    notes = load_scene(FAULTS / "world.dae", options).notes
    assert any("projected to the x–y plane" in line for line in notes)
    bare = re.sub(r"<asset>.*?</asset>", "<asset/>", world, flags=re.DOTALL)
    inches = bare.replace(
        "<asset/>", '<asset><unit meter="0.0254"/><up_axis>X_UP</up_axis></asset>'
    )
    for text, unit, axis in ((bare, "states no unit", "y is"), (inches, "0.0254 metres", "X_UP")):
        said = " ".join(read(tmp_path / "w.dae", text, footprint=BODY, **ENDS).notes)
        assert unit in said and axis in said, said


def test_problems_of_ompl_app_say_what_they_leave_out(tmp_path: Path) -> None:
    for mesh in ("world.dae", "robot.dae"):
        (tmp_path / mesh).write_bytes((FAULTS / mesh).read_bytes())
    text = (FAULTS / "both.cfg").read_text() + "\n[benchmark]\ntime_limit=10\n[planner]\nrrt=\n"
    said = read(tmp_path / "p.cfg", text).notes
    assert "sections without a part in the problem ignored: 'benchmark', 'planner'" in said


def test_maps_say_cells_units_and_what_is_unknown(tmp_path: Path) -> None:
    cells = np.array([[0, 254, 205, 254]], dtype=np.uint8)
    Image.fromarray(cells).save(tmp_path / "map.pgm")
    file = tmp_path / "map.yaml"
    file.write_text("image: map.pgm\nresolution: 0.1\norigin: [-1, -1, 0]\nfree_thresh: 0.196\n")
    options = ImportOptions(start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    said = load_scene(file, options).notes
    assert "1 unknown cells are taken for free; --unknown makes them obstacles" in said
    assert any(re.match(r"1 occupied cells of 4 × 1, \S+ metres wide", line) for line in said)


def test_an_empty_map_names_the_option_that_fills_it() -> None:
    options = ImportOptions(start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    with pytest.raises(SceneError, match=r"no obstacles.*unknown cells .* --unknown makes them"):
        load_scene(FAULTS / "al.yaml", options)


ELSEWHERE = ("discopygal scene", "dynobench problem", "Moving AI map", "Moving AI scenario")
"""In test_field_formats."""


def test_every_format_is_tried_here() -> None:
    tried = {name.split(maxsplit=1)[0] for name in (*FEW, *DRAWINGS)} | {"cfg", "dae", "yaml"}
    for kind in FORMATS:
        if kind.suffixes != (".rob",) and kind.title not in ELSEWHERE:
            assert tried & {suffix.lstrip(".") for suffix in kind.suffixes}, kind.title


def test_the_counts_stand_in_the_written_scene(tmp_path: Path) -> None:
    scene = read(tmp_path / "f.svg", FEW["svg hidden"][1], footprint=BODY, **ENDS)
    assert "1 of the file's things became nothing" in json.dumps(scene.to_dict())
