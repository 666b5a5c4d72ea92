"""`planar-planner verify`: exit status, text, JSON, overrides."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest

from planar_planner.cli.main import main
from worlds.hand_made_certificates import HAND_MADE, Json, hand_made, signed


def written(folder: Path, name: str) -> list[str]:
    """Write a hand-made scene and its certificate; return their paths."""
    scene, certificate = hand_made(name)
    return write(folder, scene, certificate)


def write(folder: Path, scene: Json, certificate: Json) -> list[str]:
    files = [folder / "scene.json", folder / "certificate.json"]
    for file, content in zip(files, (scene, certificate), strict=True):
        file.write_text(json.dumps(content), encoding="utf-8")
    return [str(file) for file in files]


@pytest.mark.parametrize("name", HAND_MADE)
def test_valid(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", *written(tmp_path, name)]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    kind = "path" if hand_made(name)[1]["verdict"] == "path" else "no path"
    assert out.startswith(f"valid: {kind}")
    assert "claims checked in" in out


def test_rejected(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, certificate = hand_made("gap")
    certificate["full_faces"].pop()
    assert main(["verify", *write(tmp_path, scene, certificate)]) == 1
    out, err = capsys.readouterr()
    assert (out.count("\n"), err) == (1, "")
    assert out.startswith("rejected: start_side, x = 0.5: has a face")


def test_unreadable(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, certificate = hand_made("gap")
    certificate["full_faces"][0]["box"][1][0] = -1
    assert main(["verify", *write(tmp_path, scene, certificate)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert "certificate.json: full_faces[0].box[1][0]: must be an integer" in err
    assert err.count("\n") == 1
    assert main(["verify", str(tmp_path / "scene.json"), str(tmp_path / "none.json")]) == 2
    assert "none.json: cannot be read: No such file" in capsys.readouterr().err


def test_a_bad_scene_is_no_verdict_on_the_certificate(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scene, certificate = hand_made("gap")
    scene["robot"]["coordinates"] = [[[0, 0], [1, 1]]]
    assert main(["verify", *write(tmp_path, scene, certificate)]) == 2
    assert "robot" in capsys.readouterr().err
    assert main(["verify", "geer", "x.json"]) == 2
    assert "did you mean 'gear'" in capsys.readouterr().err


def test_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = written(tmp_path, "disc")
    assert main(["verify", *files, "--json", "-"]) == 0
    finding = json.loads(capsys.readouterr().out)
    assert finding.pop("seconds") >= 0
    assert finding == {
        "format": "planar-planner/verification",
        "version": 1,
        "scene": "scene",
        "finding": "valid",
        "verdict": "no_path",
        "decimal_places": None,
        "proof": "disc",
        "contact_tolerance": 0.0,
        "claims": 2,
        "notes": [],
        "holds_for": "",
    }
    out = tmp_path / "finding.json"
    assert main(["verify", *files, "--goal", "1,2,3", "--json", str(out)]) == 1
    finding = json.loads(out.read_text())
    assert (finding["finding"], finding["claim"]) == ("rejected", "scene")
    (tmp_path / "certificate.json").write_text("{")
    assert main(["verify", *files, "--json", str(out)]) == 2
    assert json.loads(out.read_text())["finding"] == "unreadable"
    assert main(["verify", *files, "--json", str(tmp_path / "none" / "x.json")]) == 2
    assert "no directory" in capsys.readouterr().err


def test_start_and_goal_of_the_command_line(tmp_path: Path) -> None:
    scene, certificate = hand_made("turning_wall")
    other = {**scene, "start": [2.5, 2, -1], "goal": [8, 1, 3]}
    files = write(tmp_path, scene, signed(other, certificate))
    assert main(["verify", *files]) == 1
    assert main(["verify", *files, "--start", "2.5,2,-1", "--goal", "8,1,3"]) == 0
    assert main(["verify", *files, "--start", "2.5,2,-1"]) == 1


def test_contact_tolerance(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, certificate = hand_made("over_block")
    certificate["waypoints"][0][0] -= 2.0**-10
    certificate["contact_tolerance"] = 2.0**-10
    files = write(tmp_path, scene, certificate)
    assert main(["verify", *files]) == 1
    assert main(["verify", *files, "--contact-tolerance", "0.001"]) == 0
    assert "within 0.000976562 of start and goal" in capsys.readouterr().out
    assert main(["verify", *files, "--contact-tolerance", "nan"]) == 2


def test_compressed(tmp_path: Path) -> None:
    scene_file, certificate_file = written(tmp_path, "gap")
    zipped = tmp_path / "certificate.json.gz"
    zipped.write_bytes(gzip.compress(Path(certificate_file).read_bytes()))
    assert main(["verify", scene_file, str(zipped)]) == 0
