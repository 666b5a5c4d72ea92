"""Help in colours, by rich; imported only if a terminal shows colours."""

from __future__ import annotations

from rich.console import Console
from rich.text import Text

_STYLES = {
    r"(?m)^(usage|[a-z][a-z ]*):": "bold",  # headings
    r"(?<![\w-])--?[A-Za-z][\w-]*": "cyan",  # options, everywhere in the text
    r"(?m)^    [a-z]+(?=  )": "cyan",  # commands in their list
}


def styled_help(text: str) -> str:
    """Return the help with styles for its headings, commands and options."""
    help_text = Text(text)
    for pattern, style in _STYLES.items():
        help_text.highlight_regex(pattern, style)
    console = Console(force_terminal=True)
    with console.capture() as captured:
        console.print(help_text, soft_wrap=True, end="")
    return captured.get()
