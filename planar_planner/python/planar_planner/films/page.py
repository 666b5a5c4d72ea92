"""A page of a result: one HTML file with a player, without other files and without network.

The page's policy allows only its own script and style, by their hashes, so the content of a scene
file can neither run nor load anything.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import string
from importlib.resources import files
from pathlib import Path

from planar_planner.films.material import Material
from planar_planner.films.pace import Pace
from planar_planner.films.page_material import encodable, page_material

PAGE_SUFFIX = ".html"

_SCRIPTS = (
    "geometry.js",
    "view.js",
    "bodies.js",
    "world_view.js",
    "slice_view.js",
    "gestures.js",
    "clock.js",
    "controls.js",
    "main.js",
)


def write_page(
    material: Material, file: Path, pace: Pace, size: tuple[int, int] | None = None
) -> None:
    """Write the page that `page_text` returns, as UTF-8."""
    file.write_text(page_text(material, pace, size), encoding="utf-8", newline="\n")


def page_text(material: Material, pace: Pace, size: tuple[int, int] | None = None) -> str:
    """Return a page with a player: the robot on its path, and the cells at its angle.

    Without a path only the angle changes, through one turn. The same input gives the same text.

    Parameters
    ----------
    material : Material
        The result of `planar_planner.films.material.gather`.
    pace : Pace
        Gives the speed or the seconds.
    size : (width, height), optional
        Largest width of the page and largest height of the views, in CSS pixels.
    """
    content = json.dumps(
        page_material(material, pace, size), allow_nan=False, separators=(",", ":")
    )
    script = '(() => {\n"use strict";\n' + "\n".join(map(_part, _SCRIPTS)) + "})();\n"
    style = _part("player.css")
    policy = (
        f"default-src 'none'; script-src {_hash(script)}; style-src {_hash(style)}; "
        "img-src data:; base-uri 'none'; form-action 'none'"
    )
    return string.Template(_part("player.html")).substitute(
        title=html.escape(encodable(material.problem.name)),
        policy=policy,
        style=style,
        script=script,
        material=_in_script(content),
    )


def _part(name: str) -> str:
    return (files("planar_planner.films") / "player" / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    """Return the source expression of Content Security Policy that allows only this inline text."""
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode('ascii')}'"


def _in_script(content: str) -> str:
    """Escape JSON so that no ``</script>`` or ``<!--`` in it ends or changes the element."""
    return content.replace("<", "\\u003c")
