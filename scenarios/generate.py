"""Rewrite every shipped scene file and the manifest: ``python -m scenarios.generate``."""

import json
from pathlib import Path
from typing import Any

from scenarios.catalogue import ENTRIES, LICENCE
from scenarios.model import Scene

FOLDER = Path(__file__).parent


def _lines(items: list[Any]) -> str:
    """Return a JSON array with one element on each line."""
    if not items:
        return "[]"
    return "[\n" + ",\n".join(f"    {json.dumps(item)}" for item in items) + "\n  ]"


def scene_text(made: Scene) -> str:
    """Return the file of a scene: one key or obstacle per line, numbers in shortest exact form."""
    obstacles = _lines(made["obstacles"])
    fields = [
        f"  {json.dumps(key)}: {obstacles if key == 'obstacles' else json.dumps(value)}"
        for key, value in made.items()
    ]
    return "{\n" + ",\n".join(fields) + "\n}\n"


def manifest() -> dict[str, Any]:
    """Return the manifest: one entry per scene, with the expected verdict."""
    return {
        "format": "planar-planner/manifest",
        "version": 1,
        "scenes": [
            {
                "name": entry.name,
                "file": f"{entry.name}.json",
                "expected": entry.expected,
                "origin": entry.origin,
                "licence": LICENCE,
                "generator": f"scenarios.{entry.generator}",
            }
            for entry in ENTRIES
        ],
    }


def files() -> dict[str, str]:
    """Return every generated file: name relative to this folder, and text."""
    texts = {f"{entry.name}.json": scene_text(entry.make()) for entry in ENTRIES}
    texts["manifest.json"] = json.dumps(manifest(), indent=2) + "\n"
    return texts


def main() -> None:
    """Write all files."""
    for name, text in files().items():
        (FOLDER / name).write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
