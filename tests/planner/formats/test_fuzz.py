"""Whatever a file holds, reading it ends in a scene or in one `SceneError`."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from planar_planner import SceneError
from planar_planner.errors import one_line
from planar_planner.formats.parts import ImportOptions
from planar_planner.load import load_scene
from planar_planner.problem.make import make_problem
from worlds.outside_files.dxf import box, dxf
from worlds.outside_files.ompl_app import WALLS, dae
from worlds.outside_files.svg import BOX, ENDS, svg
from worlds.outside_files.texts import FULL, ROB, WKT_SCENE, YAP
from worlds.outside_files.tpcap import BAY

SEEDS = {
    "f.wkt": WKT_SCENE,
    "f.geojson": FULL,
    "f.txt": YAP,
    "f.rob": ROB,
    "f.csv": BAY,
    "f.svg": svg(BOX, ENDS, '<path id="obstacle" transform="rotate(3)" d="M0 0a9 4 0 1 0 8 0z"/>'),
    "f.dxf": dxf(lambda m: box(m, "obstacle", 20, 3, 22, 12)),
    "f.dae": dae(WALLS),
    "f.yaml": "image: f.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"
    "footprint: '[[0,0],[1,0],[0,1]]'\n",
    "f.cfg": "[problem]\nrobot = f.dae\nworld = f.dae\nstart.x = 1\nstart.y = 2\ngoal.x = 1\n",
}
BITS = st.sampled_from(
    [
        *("", " ", "\n", "(", ")", "[", "{", "<", ">", "/", "#", "\\", ",", "-", "z", "Z"),
        *("9" * 30, "1e999", "nan", "0", "-1", "0.5", "POLYGON", "null", "true"),
        *("\0", "é", "&", "&amp;", ": ", "- "),
    ]
)


@st.composite
def broken(draw: st.DrawFn, seed: str) -> bytes:
    """Return a good file with parts cut out, doubled or replaced."""
    text = seed
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(text)))
        end = min(len(text), at + draw(st.integers(0, 12)))
        kind = draw(st.integers(0, 2))
        middle = {0: "", 1: 2 * text[at:end], 2: draw(BITS)}[kind]
        text = text[:at] + middle + text[end:]
    return text.encode()


@pytest.mark.parametrize("name", SEEDS)
def test_broken_files_end_in_one_line(name: str, tmp_path: Path) -> None:
    (tmp_path / "f.dae").write_text(SEEDS["f.dae"])
    (tmp_path / "f.pgm").write_bytes(b"P5\n3 2\n255\n\x00\xfe\xcd\x00\xfe\xfe")
    options = ImportOptions(start=[-5.0, 0.0, 0.0], goal=[5.0, 0.0, 0.0])

    @settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
    @given(broken(SEEDS[name]))
    def attack(data: bytes) -> None:
        file = tmp_path / name
        file.write_bytes(data)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                make_problem(load_scene(file, options))
        except SceneError as error:
            text = str(error)
            assert text == one_line(text)
            assert text.startswith(str(tmp_path))

    attack()


@pytest.mark.parametrize("name", SEEDS)
@pytest.mark.parametrize("data", [b"", b"\xff\xfe\x00", b"\x00" * 100, b"[" * 5000, b"(" * 5000])
def test_nonsense_ends_in_one_line(name: str, data: bytes, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises(SceneError, match=r".*"):
        load_scene(tmp_path / name)
