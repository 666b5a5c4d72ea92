"""Coverage-guided fuzzing of the readers: ``python bench/fuzz_readers.py scene|certificate``.

Needs atheris (``pip install atheris``, Python 3.11 or 3.12), which nothing else does; what the
stress command runs without it are the same readers under random changes. Options of libFuzzer
follow, such as ``-max_total_time=600``; a crash leaves its input in ``crash-*``.
"""

from __future__ import annotations

import json
import sys

import atheris

with atheris.instrument_imports(include=["planar_planner", "json"]):
    from planar_planner import SceneError, load_scene
    from planar_planner.certificate_form import CertificateError
    from planar_planner.scene import _checked, _parse
from stress_parts.hostile_mutations import read_certificate, read_scene

SCENE = load_scene("corner")


def one_scene(data: bytes) -> None:
    """Read bytes as a scene file."""
    try:
        content = _parse(data, "fuzz")
        _checked(content, "fuzz", "fuzz")
    except SceneError:
        return
    read_scene(content)


def one_certificate(data: bytes) -> None:
    """Read bytes as a certificate."""
    try:
        content = json.loads(data)
    except (ValueError, RecursionError):
        return
    try:
        read_certificate(SCENE, content)
    except CertificateError:
        return


def main() -> None:
    """Hand over to libFuzzer."""
    target = {"scene": one_scene, "certificate": one_certificate}[sys.argv.pop(1)]
    atheris.Setup(sys.argv, target)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
