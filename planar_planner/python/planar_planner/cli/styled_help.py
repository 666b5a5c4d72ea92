"""Help in colours, by rich; imported only where a terminal is to show them."""

from __future__ import annotations

from rich.console import Console
from rich.text import Text

_STYLES = {
    r"(?m)^(usage|[a-z][a-z ]*):": "bold",  # headings
    r"(?<![\w-])--?[A-Za-z][\w-]*": "cyan",  # options, wherever they are named
    r"(?m)^    [a-z]+(?=  )": "cyan",  # commands in their list
}


def styled_help(text: str) -> str:
    """Return the help with its headings, commands and options told apart."""
    help_text = Text(text)
    for pattern, style in _STYLES.items():
        help_text.highlight_regex(pattern, style)
    console = Console(force_terminal=True)
    with console.capture() as captured:
        console.print(help_text, soft_wrap=True, end="")
    return captured.get()
