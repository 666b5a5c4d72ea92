"""Coverage-guided fuzzing of the readers: ``python tests/attacks/fuzz_readers.py scene``.

Or ``certificate``, the other reader. Needs atheris (``pip install atheris``), which nothing else
does: what the stress command runs without it are the same readers under the same changes,
unguided. Options of libFuzzer and folders with inputs follow, such as ``-max_total_time=600
corpus``; a crash leaves its input in ``crash-*``, an input that takes longer than a minute in
``timeout-*``.
"""

from __future__ import annotations

import json
import random
import sys
from pathlib import Path

import atheris

sys.path.extend(str(Path(__file__).resolve().parents[k]) for k in (1, 2))  # tests and scenarios

with atheris.instrument_imports(include=["planar_planner"]):
    from attacks.stress_parts.hostile_mutations import mutated, read_certificate, read_scene
    from planar_planner import Planner, SceneError, load_scene
    from planar_planner.scene.json_file import parse

LIBFUZZER = ["-timeout=60", "-rss_limit_mb=2048", "-max_len=100000"]  # before what is given
BYTES = 0.2  # of the changes are those of libFuzzer, which knows no JSON
NAME = "corner"  # has a path


def one_scene(data: bytes) -> None:
    """Read bytes as a scene file."""
    try:
        content = parse(data, "fuzz")
    except SceneError:
        return
    read_scene(content)


def one_certificate(data: bytes) -> None:
    """Read bytes as a certificate."""
    try:
        content = json.loads(data)
    except (ValueError, RecursionError):
        return
    read_certificate(load_scene(NAME), content, "path")


def changed(data: bytes, max_size: int, seed: int) -> bytes:
    """Change a value inside if the bytes are JSON, mostly; else any bytes."""
    rng = random.Random(seed)
    if rng.random() > BYTES:
        try:
            return json.dumps(mutated(rng, json.loads(data))).encode()[:max_size]
        except (ValueError, RecursionError):
            pass
    out: bytes = atheris.Mutate(data, max_size)
    return out


def first_input(kind: str) -> bytes:
    """Return something that is accepted, to begin with."""
    if kind == "scene":
        return json.dumps(load_scene(NAME).to_dict()).encode()
    return json.dumps(Planner(NAME).solve(certificate=True).certificate).encode()


def main() -> None:
    """Hand over to libFuzzer."""
    kind = sys.argv.pop(1)
    target = {"scene": one_scene, "certificate": one_certificate}[kind]
    start = first_input(kind)

    def mutator(data: bytes, max_size: int, seed: int) -> bytes:
        return changed(data if len(data) > 1 else start, max_size, seed)

    atheris.Setup([sys.argv[0], *LIBFUZZER, *sys.argv[1:]], target, custom_mutator=mutator)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
