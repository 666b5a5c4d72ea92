"""Maps of our own making: rooms with doors, thresholds, turned origins, broken files."""

from __future__ import annotations

import json
import math
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from planar_planner import SceneError, load_scene, solve
from planar_planner.cli.main import main
from planar_planner.formats.parts import ImportOptions
from planar_planner.problem.make import make_problem
from support.format_help import read

FREE, UNKNOWN, WALL = 254, 205, 0
BODY = "[[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]]"


FAULTS = Path(__file__).parents[2] / "worlds" / "faults"
ALPHA_MAPS = [("al.yaml", 2), ("m7.yaml", 2)]


def rooms(door: int) -> np.ndarray:
    """Return two rooms, 40 by 24 cells, with a door of so many cells."""
    cells = np.full((24, 40), FREE, dtype=np.uint8)
    cells[[0, -1]] = cells[:, [0, -1]] = WALL
    cells[:, 19:21] = WALL
    cells[10 : 10 + door, 19:21] = FREE
    return cells


def corridor_maze() -> np.ndarray:
    cells = np.full((40, 40), FREE, dtype=np.uint8)
    cells[[0, -1]] = cells[:, [0, -1]] = WALL
    cells[12:14, :28] = WALL
    cells[26:28, 12:] = WALL
    return cells


def write_map(folder: Path, cells: np.ndarray, image: str = "map.pgm", **fields: object) -> Path:
    Image.fromarray(cells).save(folder / image)
    content = {"image": image, "resolution": 0.1, "origin": [-1.0, -2.0, 0.0], "negate": 0}
    content |= {"occupied_thresh": 0.65, "free_thresh": 0.196} | fields
    file = folder / "map.yaml"
    file.write_text("".join(f"{key}: {json.dumps(value)}\n" for key, value in content.items()))
    return file


@pytest.mark.parametrize(
    ("cells", "start", "goal", "verdict"),
    [
        (rooms(6), [-0.4, -0.8, 0.0], [2.2, -0.8, 0.0], "path"),
        (rooms(3), [-0.4, -0.8, 0.0], [2.2, -0.8, 0.0], "no_path"),
        (corridor_maze(), [-0.4, 1.4, 0.0], [2.4, -1.4, 0.0], "path"),
    ],
)
def test_maps_are_decided(
    cells: np.ndarray, start: list[float], goal: list[float], verdict: str, tmp_path: Path
) -> None:
    file = write_map(tmp_path, cells)
    scene = read(file, file.read_bytes(), start=start, goal=goal, footprint=BODY)
    assert solve(scene).verdict == verdict


def test_the_first_row_is_the_top(tmp_path: Path) -> None:
    cells = np.full((3, 4), FREE, dtype=np.uint8)
    cells[0, 0] = WALL
    file = write_map(tmp_path, cells)
    scene = read(file, file.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    (ring,) = scene.obstacles[0]["coordinates"]
    top, below = -2.0 + 3 * 0.1, -2.0 + 2 * 0.1
    assert {tuple(p) for p in ring} == {(-1.0, below), (-0.9, below), (-0.9, top), (-1.0, top)}
    problem = make_problem(scene)
    assert problem.workspace_box == (-1.0, -2.0, -1.0 + 4 * 0.1, top)


def test_the_origin_may_be_turned(tmp_path: Path) -> None:
    cells = np.full((2, 2), FREE, dtype=np.uint8)
    cells[1, 1] = WALL
    file = write_map(tmp_path, cells, origin=[3.0, 4.0, math.pi / 2])
    scene = read(file, file.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    (ring,) = scene.obstacles[0]["coordinates"]
    expected = [(2.9, 4.1), (2.9, 4.2), (3.0, 4.1), (3.0, 4.2)]
    assert sorted(map(tuple, ring[:-1])) == [pytest.approx(p) for p in expected]


def test_unknown_cells_by_option(tmp_path: Path) -> None:
    cells = np.full((4, 6), FREE, dtype=np.uint8)
    cells[1, 1], cells[2, 3] = WALL, UNKNOWN
    file = write_map(tmp_path, cells)
    common = {"start": [0, 0, 0], "goal": [0, 0, 0], "footprint": BODY}
    assert len(read(file, file.read_bytes(), **common).obstacles) == 1
    assert len(read(file, file.read_bytes(), unknown=True, **common).obstacles) == 2


@pytest.mark.parametrize("image", ["map.png", "map.pgm", "map.bmp"])
@pytest.mark.parametrize("negate", [0, 1])
def test_kinds_of_images(image: str, negate: int, tmp_path: Path) -> None:
    cells = rooms(6)
    file = write_map(tmp_path, 255 - cells if negate else cells, image, negate=negate)
    scene = read(file, file.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    assert scene.notes[0].startswith(f"{int((cells == WALL).sum())} occupied cells of 40 × 24")


def test_colours_and_palettes_read_like_grey(tmp_path: Path) -> None:
    cells = rooms(6)
    grey = write_map(tmp_path, cells)
    plain = read(grey, grey.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    for mode in ("RGB", "P", "RGBA", "LA"):
        Image.fromarray(cells).convert(mode).save(tmp_path / "colour.png")
        text = grey.read_text().replace("map.pgm", "colour.png")
        other = read(tmp_path / "o.yaml", text, start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
        assert other.obstacles == plain.obstacles, mode


def test_a_mode_of_its_own(tmp_path: Path) -> None:
    cells = np.array([[0, 100, 255, 50]], dtype=np.uint8)
    file = write_map(tmp_path, cells, mode="raw")
    common = {"start": [0, 0, 0], "goal": [0, 0, 0], "footprint": BODY}
    said = read(file, file.read_bytes(), **common).notes
    assert said[0] == "2 unknown cells are taken for free; --unknown makes them obstacles"
    assert said[1].startswith("1 occupied")
    both = read(file, file.read_bytes(), unknown=True, **common)
    assert both.notes[0].startswith("3 occupied and unknown")


def test_footprint_of_a_parameter_file_is_padded(tmp_path: Path) -> None:
    parameters = tmp_path / "nav2.yaml"
    parameters.write_text(
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
        f'      footprint: "{BODY}"\n      footprint_padding: 0.05\n'
    )
    file = write_map(tmp_path, rooms(6))
    common = {"start": [-0.4, -0.8, 0.0], "goal": [2.2, -0.8, 0.0]}
    scene = read(file, file.read_bytes(), robot=parameters, **common)
    xs, ys = zip(*scene.robot["coordinates"][0], strict=True)
    assert (min(xs), max(xs), min(ys), max(ys)) == (-0.35, 0.35, -0.25, 0.25)
    wider = read(file, file.read_bytes(), footprint=BODY, padding=0.1, **common)
    xs, _ = zip(*wider.robot["coordinates"][0], strict=True)
    assert max(xs) == 0.4


def test_what_is_missing_is_named_at_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = write_map(tmp_path, rooms(6))
    assert main(["solve", str(file)]) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    for option in ("--robot FILE", "--footprint", "--start X,Y,THETA", "--goal X,Y,THETA"):
        assert option in error


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"resolution": -0.1}, "resolution: must be positive"),
        ({"resolution": "wide"}, "resolution: must be a number"),
        ({"origin": [0, 0]}, "origin: must be [x, y, yaw]"),
        ({"negate": 7}, "negate: must be 0 or 1"),
        ({"mode": "vague"}, "mode: must be one of"),
        ({"free_thresh": 0.9}, "free_thresh"),
        ({"occupied_thresh": None}, "occupied_thresh: must be a number"),
        ({"image": 3}, "image: must be a string"),
        ({"image": "none.pgm"}, "none.pgm: cannot read"),
    ],
)
def test_wrong_fields_say_which(change: dict[str, object], place: str, tmp_path: Path) -> None:
    file = write_map(tmp_path, rooms(6))
    lines = dict(line.split(": ", 1) for line in file.read_text().splitlines())
    lines |= {key: json.dumps(value) for key, value in change.items()}
    text = "".join(f"{key}: {value}\n" for key, value in lines.items())
    with pytest.raises(SceneError, match=r".*") as raised:
        read(file, text, start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    assert place in str(raised.value)


def cyan_image() -> bytes:
    """Return a JPEG of four inks, which is not read."""
    out = BytesIO()
    Image.new("CMYK", (3, 3)).save(out, "JPEG")
    return out.getvalue()


@pytest.mark.parametrize(
    "data", [b"", b"P5\n10 10\n255\nshort", b"P5\n99999 99999\n255\n", b"nonsense", cyan_image()]
)
def test_broken_images_are_named(data: bytes, tmp_path: Path) -> None:
    file = write_map(tmp_path, rooms(6))
    (tmp_path / "map.pgm").write_bytes(data)
    with pytest.raises(SceneError) as raised:
        read(file, file.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    assert str(raised.value).startswith(str(tmp_path / "map.pgm"))


@pytest.mark.parametrize(
    "text",
    ["", "[1, 2]", "image: [", "a: &x 1\nb: *x\n", "image: !!python/object:os.system {}", "\0"],
)
def test_broken_yaml_is_named(text: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as raised:
        read(tmp_path / "map.yaml", text)
    assert str(raised.value).startswith(str(tmp_path / "map.yaml"))


@pytest.mark.parametrize("text", ["", "3", "[[0, 0]", "[[0, 0], [1]]", "[[0,0],[1,1],[2,2]]"])
def test_broken_footprints_are_named(text: str, tmp_path: Path) -> None:
    file = write_map(tmp_path, rooms(6))
    with pytest.raises(SceneError, match="footprint"):
        read(file, file.read_bytes(), start=[0, 0, 0], goal=[0, 0, 0], footprint=text)


def one_row(folder: Path, image: Image.Image, **fields: object) -> Path:
    """Write a map of an image."""
    file = write_map(folder, np.zeros((1, 1), dtype=np.uint8), **fields)
    image.save(folder / "own.png")
    file.write_text(file.read_text().replace("map.pgm", "own.png"))
    return file


def cells_of(file: Path, **options: object) -> list[tuple[float, float]]:
    """Return the cells of a one-row map that are obstacles, as (from, to) along the row."""
    common = {"start": [0, 0, 0], "goal": [0, 0, 0], "footprint": BODY, "allow_empty": True}
    scene = read(file, file.read_bytes(), **common, **options)
    ends = [[p[0] for p in o["coordinates"][0]] for o in scene.obstacles]
    return sorted((round((min(x) + 1) * 10), round((max(x) + 1) * 10)) for x in ends)


def test_opacity_is_averaged_in_as_in_nav2(tmp_path: Path) -> None:
    """Black opaque: 0.75 occupied; black clear: 1; white clear: 0.25, unknown; white opaque: 0."""
    row = np.array([[[0, 255], [0, 0], [255, 0], [255, 255], [90, 255]]], dtype=np.uint8)
    file = one_row(tmp_path, Image.fromarray(row, "LA"))
    assert cells_of(file) == [(0, 2)]
    assert cells_of(file, unknown=True) == [(0, 3), (4, 5)]
    scene = read(file, file.read_bytes(), start=[0] * 3, goal=[0] * 3, footprint=BODY)
    assert any("opacity is averaged in" in note for note in scene.notes)
    file = one_row(tmp_path, Image.fromarray(row, "LA"), mode="scale")
    assert cells_of(file) == [(0, 1)]
    assert cells_of(file, unknown=True) == [(0, 3), (4, 5)]


def test_sixteen_bits_and_wide_pgm(tmp_path: Path) -> None:
    row = np.array([[0, 65535, 40000, 10000]], dtype=np.uint16)
    assert cells_of(one_row(tmp_path, Image.fromarray(row))) == [(0, 1), (3, 4)]
    (tmp_path / "own.png").write_bytes(b"P2 4 1 1023\n0 1023 624 156\n")
    assert cells_of(tmp_path / "map.yaml") == [(0, 1), (3, 4)]


@pytest.mark.parametrize("number", ["1e-05", "8e-17", "1E-5", "-1e-9"])
def test_numbers_with_exponents_are_numbers(number: str, tmp_path: Path) -> None:
    file = write_map(tmp_path, rooms(6))
    text = file.read_text().replace("[-1.0, -2.0, 0.0]", f"[0, 0, {number}]")
    scene = read(file, text, start=[0, 0, 0], goal=[0, 0, 0], footprint=BODY)
    assert scene.obstacles


def test_pictures_that_are_none_or_alone(tmp_path: Path) -> None:
    file = write_map(tmp_path, rooms(6))
    (tmp_path / "map.pgm").write_bytes(b"no image")
    with pytest.raises(SceneError, match="is no image in PGM") as raised:
        read(file, file.read_bytes())
    assert " object at 0x" not in str(raised.value)
    Image.fromarray(rooms(6)).save(tmp_path / "alone.png")
    with pytest.raises(SceneError, match="picture without scale"):
        load_scene(tmp_path / "alone.png")
    with pytest.raises(SceneError, match="is a disc"):
        read(tmp_path / "nav2.yaml", "local_costmap:\n  robot_radius: 0.2\n")


@pytest.mark.parametrize(("name", "walls"), ALPHA_MAPS)
def test_maps_with_alpha_of_the_issue(name: str, walls: int) -> None:
    given = {"footprint": BODY, "start": [0.0] * 3, "goal": [0.0] * 3, "unknown": True}
    scene = load_scene(FAULTS / name, ImportOptions(**given))
    assert len(scene.obstacles) == walls
