"""SVG drawings: the parts that every one of them needs."""

from __future__ import annotations

BOX = '<rect id="robot" x="-1" y="-1" width="2" height="2"/>'
ENDS = '<circle id="start" cx="10" cy="-5" r="1"/><path id="goal" d="M 30 -5 v -4"/>'


def svg(*elements: str, head: str = "") -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{"".join(elements)}</svg>'
