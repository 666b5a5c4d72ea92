"""Capabilities of a stream: only a terminal shows more than plain text. Light to import."""

from __future__ import annotations

import os
from typing import TextIO

VERDICT_STYLES = {"path": "bold cyan", "no_path": "bold magenta", "undecided": "bold yellow"}
"""Colour-blind readers can distinguish these on dark and light ground; words repeat the verdict."""


def is_terminal(stream: TextIO | None) -> bool:
    """Return whether the stream is a terminal that can move its cursor."""
    if stream is None or os.environ.get("TERM") in ("dumb", "unknown"):
        return False
    try:
        return stream.isatty()
    except ValueError:  # closed
        return False


def has_colours(stream: TextIO | None) -> bool:
    """Return whether to use colours: on a terminal without NO_COLOR (https://no-color.org)."""
    return is_terminal(stream) and os.environ.get("NO_COLOR", "") == ""


def styled(text: str, style: str, stream: TextIO | None) -> str:
    """Return the text for the stream, in a style of rich if the stream shows colours."""
    if not has_colours(stream):
        return text
    from rich.color import ColorSystem
    from rich.style import Style  # without rich.console, which takes three times as long to import

    return Style.parse(style).render(text, color_system=ColorSystem.STANDARD)
