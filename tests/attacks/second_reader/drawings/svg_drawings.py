"""Generated SVG drawings, one feature each; all that a viewer paints is an obstacle.

The canvas is 100 × 100 user units. Where a viewer's paint is not the area that is meant (outlines
without fill), the fragment says so in its hints.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from ..model import Drawing
from .svg_paths import Pen, joined, number, star

SEEN = r"hidden|not shown|invisible|not drawn|not painted|display|ignored|left out|skipped"
NS = (
    'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
    'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'
)


@dataclass(frozen=True)
class Fragment:
    """Part of a drawing.

    Attributes
    ----------
    body : str
        Elements under the role; everything painted there is an obstacle.
    outside : str
        Elements beside it, without a role: definitions and style.
    css : str
        Content of a style element.
    must_say : str
        Regular expression of the note that is due.
    hints : mapping
        ``paint``: ``outline`` if shapes without fill mean their inside all the same; ``browser`` if
        resvg does not know the feature; ``told`` if no reading of the area is right without a note.
    head : str
        Attributes of the root; the default is width and height 100.
    """

    body: str
    outside: str = ""
    css: str = ""
    must_say: str = ""
    hints: dict[str, Any] = field(default_factory=dict)
    head: str = 'width="100" height="100"'


_S = ' id="s"'
_OBSTACLE7 = ' id="obstacle7"'
_DE = ' systemLanguage="de"'
_EN = ' systemLanguage="en"'
_VISIBLE = ' visibility="visible"'
_H = ' class="h"'

Maker = Callable[[random.Random], Fragment]
MAKERS: dict[str, Maker] = {}


def feature(make: Maker) -> Maker:
    """Register a maker under its name."""
    MAKERS[make.__name__.strip("_")] = make
    return make


def drawings(rng: random.Random, count: int, only: str = "") -> Iterator[Drawing]:
    """Yield drawings, each feature in turn."""
    names = [name for name in MAKERS if only in name]
    for k in range(count):
        name = names[k % len(names)]
        yield drawing(name, MAKERS[name](rng), rng)


def drawing(name: str, part: Fragment, rng: random.Random) -> Drawing:
    """Return a document around a fragment."""
    style = f"<style>{part.css}</style>" if part.css else ""
    role = rng.choice(
        ['id="obstacle"', 'class="obstacle"', 'inkscape:label="obstacles"', 'id="Obstacle_1"']
    )
    body = part.body if part.hints.get("own_role") else f"<g {role}>{part.body}</g>"
    text = f"<svg {NS} {part.head}>{style}{part.outside}{body}</svg>"
    hints = {"canvas": 100.0, **part.hints}
    options = {
        "tolerance": 0.05 * hints.get("unit", 1.0),
        "flatten": rng.choice(["outwards", "outwards", "outwards", "inwards"]),
    }
    return Drawing(name, "d.svg", {"d.svg": text.encode()}, options, part.must_say, "", hints)


def box(rng: random.Random, more: str = "", low: float = 10, high: float = 60) -> str:
    """Return a rectangle's element."""
    x, y = rng.randint(int(low), int(high)), rng.randint(int(low), int(high))
    w, h = rng.randint(12, 30), rng.randint(12, 30)
    return f'<rect x="{x}" y="{y}" width="{w}" height="{h}"{more}/>'


def _path(rng: random.Random, commands: str, more: str = "", **pen: float) -> Fragment:
    writer = Pen(rng, commands, **pen)
    writer.outline(star(rng))
    return Fragment(f'<path d="{writer.text}"{more}/>')


# ---- path data --------------------------------------------------------------------------------


@feature
def path_lines(rng: random.Random) -> Fragment:
    return _path(rng, "L")


@feature
def path_hv(rng: random.Random) -> Fragment:
    x, y, w, h = rng.randint(5, 40), rng.randint(5, 40), rng.randint(10, 50), rng.randint(10, 50)
    return Fragment(
        rng.choice(
            [
                f'<path d="M{x} {y}H{x + w}V{y + h}H{x}z"/>',
                f'<path d="m{x},{y}h{w}v{h}h-{w}z"/>',
                f'<path d="m{x} {y}h{w / 2} {w / 2}v{h}H{x}Z"/>',
            ]
        )
    )


@feature
def path_cubic(rng: random.Random) -> Fragment:
    return _path(rng, "CS")


@feature
def path_quadratic(rng: random.Random) -> Fragment:
    return _path(rng, "QQQT")


@feature
def path_smooth_first(rng: random.Random) -> Fragment:
    """S and T that follow no curve of their kind: the control point is the current point."""
    return _path(rng, "LSLT")


@feature
def path_arc(rng: random.Random) -> Fragment:
    return _path(rng, "A")


@feature
def path_all_commands(rng: random.Random) -> Fragment:
    return _path(rng, "LHCSQTA")


@feature
def arc_too_small(rng: random.Random) -> Fragment:
    x, y, w = rng.randint(20, 40), rng.randint(40, 60), rng.randint(20, 40)
    r1, r2 = rng.choice([(1, 1), (w / 4, w / 8), (w / 3, w / 3)])
    sweep = rng.randint(0, 1)
    up = 25 if sweep == 0 else -25
    return Fragment(f'<path d="M{x} {y} A{r1} {r2} 0 0 {sweep} {x + w} {y} l0 {up} h{-w} z"/>')


@feature
def arc_zero_radius(rng: random.Random) -> Fragment:
    x, y = rng.randint(10, 40), rng.randint(10, 40)
    r1, r2 = rng.choice([(0, 0), (0, 7), (7, 0)])
    return Fragment(f'<path d="M{x} {y} A{r1} {r2} 0 0 1 {x + 40} {y} v30 h-40 z"/>')


@feature
def arc_negative_radius(rng: random.Random) -> Fragment:
    x, y = rng.randint(10, 40), rng.randint(30, 40)
    return Fragment(f'<path d="M{x} {y} A-20 20 0 0 1 {x + 40} {y} v30 h-40 z"/>')


@feature
def arc_same_ends(rng: random.Random) -> Fragment:
    x, y = rng.randint(10, 40), rng.randint(10, 40)
    return Fragment(f'<path d="M{x} {y} h40 a9 9 0 1 1 0 0 v30 h-40 z"/>')


@feature
def arc_large(rng: random.Random) -> Fragment:
    x, y, r = rng.randint(35, 60), rng.randint(35, 60), rng.randint(12, 20)
    flags = rng.choice(["1 1 ", "10", "11", "1,0,"])
    return Fragment(f'<path d="M{x} {y}a{r} {r} {rng.choice([0, 45])} {flags}{r // 2} {r // 3}z"/>')


@feature
def arc_circle_of_two(rng: random.Random) -> Fragment:
    x, y, r = rng.randint(35, 60), rng.randint(35, 60), rng.randint(12, 20)
    return Fragment(f'<path d="M{x},{y}m-{r},0a{r},{r} 0 1,0 {2 * r},0a{r},{r} 0 1,0 -{2 * r},0"/>')


@feature
def path_compact(rng: random.Random) -> Fragment:
    x, y = rng.randint(10, 40), rng.randint(10, 40)
    return Fragment(
        rng.choice(
            [
                f'<path d="M{x}.5.5l30.5-.25.25 40.5-30-3.5z" transform="translate(0,10)"/>',
                f'<path d="m{x} {y}30-5 5 30-30 2z"/>',
                f'<path d="M{x} {y}h3e1v2.5e+1h-300e-1z"/>',
                f'<path d="M{x}-5l40 0 0+40-40 0z"/>',
                f'<path d="M{x},{y}a20,20,0,0120-20l.5.5.5 40z"/>',
            ]
        )
    )


@feature
def path_relative_after_close(rng: random.Random) -> Fragment:
    x, y = rng.randint(5, 20), rng.randint(5, 20)
    return Fragment(
        rng.choice(
            [
                f'<path d="m{x} {y}h20v20h-20z m35 0h20v20h-20z m-35 35h20v20h-20z"/>',
                f'<path d="M{x} {y}h20v20h-20z l0 -5 h60 v70 z"/>',
                f'<path d="M{x} {y}h20v20h-20zm35,5l20,0l0,20z"/>',
            ]
        )
    )


@feature
def path_open_filled(rng: random.Random) -> Fragment:
    writer = Pen(rng, "LLCQ")
    writer.outline(star(rng), close=False)
    if rng.random() < 0.5:
        return Fragment(f'<path d="{writer.text}"/>')
    x, y = rng.randint(5, 20), rng.randint(5, 20)
    return Fragment(
        f'<path d="M{x} {y}h20v20h-20 M{x + 40} {y}h20v20h-20M{x} {y + 50}l20 0l9 20"/>'
    )


@feature
def path_small_gap(rng: random.Random) -> Fragment:
    gap = rng.choice([1e-9, 1e-5, 1e-3, 0.1])
    return Fragment(f'<path d="M20 20h40v40h-40V{20 + gap!r}"/>')


@feature
def path_evenodd(rng: random.Random) -> Fragment:
    return _two_rings(rng, rng.choice([' fill-rule="evenodd"', ' style="fill-rule:evenodd"']))


@feature
def path_nonzero(rng: random.Random) -> Fragment:
    return _two_rings(rng, rng.choice(["", ' fill-rule="nonzero"', ' style="fill-rule: nonzero;"']))


def _two_rings(rng: random.Random, more: str) -> Fragment:
    inner = rng.choice(["m10 10h20v20h-20z", "m10 10v20h20v-20z", "M70 70h20v20h-20z"])
    return Fragment(f'<path d="M20 20h45v45h-45z{inner}"{more}/>')


@feature
def path_three_rings(rng: random.Random) -> Fragment:
    rule = rng.choice(["evenodd", "nonzero"])
    second = rng.choice(["M20 20h60v60h-60z", "M20 20v60h60v-60z"])
    third = rng.choice(["M35 35h30v30h-30z", "M35 35v30h30v-30z"])
    return Fragment(f'<path fill-rule="{rule}" d="M5 5h90v90h-90z{second}{third}"/>')


@feature
def path_curved_rings(rng: random.Random) -> Fragment:
    rule = rng.choice(["evenodd", "nonzero"])
    sweep = rng.randint(0, 1)
    other = rng.randint(0, 1)
    return Fragment(
        f'<path fill-rule="{rule}" d="M10 50a40 40 0 0 {sweep} 80 0a40 40 0 0 {sweep} -80 0z'
        f'M30 50a20 20 0 0 {other} 40 0a20 20 0 0 {other} -40 0z"/>'
    )


@feature
def path_self_crossing(rng: random.Random) -> Fragment:
    rule = rng.choice(["evenodd", "nonzero"])
    d = rng.choice(
        [
            "M50 5L79 95L3 39h94L21 95z",
            "M10 10h60v60h-40v-40h60v60h-80z",
            "M10 10L80 80V10L10 80z",
            "M10 50C10 -20 90 120 90 50V90H10z",
        ]
    )
    return Fragment(f'<path fill-rule="{rule}" d="{d}"/>')


@feature
def path_error_tail(rng: random.Random) -> Fragment:
    """What comes before the error is painted."""
    tail = rng.choice([" L 5", " q 1", " ,,", " foo", " M"])
    return Fragment(f'<path d="M20 20h40v30h-40z{tail}"/>')


@feature
def path_move_only(rng: random.Random) -> Fragment:
    return Fragment(f'<path d="M1 1 M{rng.randint(10, 40)} 20h40v30h-40z m5 5"/>')


@feature
def path_empty(rng: random.Random) -> Fragment:
    return Fragment(rng.choice(['<path d=""/>', '<path d="none"/>', "<path/>"]) + box(rng))


# ---- basic shapes -----------------------------------------------------------------------------


@feature
def rect_plain(rng: random.Random) -> Fragment:
    return Fragment(box(rng) + box(rng))


@feature
def rect_rounded(rng: random.Random) -> Fragment:
    radii = rng.choice(
        [
            'rx="8"',
            'ry="8"',
            'rx="8" ry="15"',
            'rx="400" ry="4"',
            'rx="auto" ry="9"',
            'rx="0" ry="9"',
            'rx="20%"',
            'rx="-20" ry="9"',
            'rx="9" ry="-20"',
            'rx="2mm"',
        ]
    )
    return Fragment(f'<rect x="{rng.randint(5, 20)}" y="15" width="60" height="50" {radii}/>')


@feature
def rect_zero(rng: random.Random) -> Fragment:
    zero = rng.choice(['width="0" height="10"', 'height="10"', 'width="-5" height="10"'])
    return Fragment(f'<rect x="5" y="5" {zero}/>' + box(rng))


@feature
def rect_css_size(rng: random.Random) -> Fragment:
    return Fragment(
        f'<rect style="x:{rng.randint(5, 30)}px;y:10px;width:50px;height:40px"/>',
    )


@feature
def circle(rng: random.Random) -> Fragment:
    return Fragment(f'<circle cx="{rng.randint(30, 60)}" cy="50" r="{rng.randint(9, 30)}"/>')


@feature
def circle_zero(rng: random.Random) -> Fragment:
    return Fragment(
        rng.choice(['<circle r="0"/>', '<circle cx="5"/>', '<circle r="-4"/>']) + box(rng)
    )


@feature
def circle_css(rng: random.Random) -> Fragment:
    return Fragment(f'<circle cx="50" cy="50" r="5" style="r:{rng.randint(15, 40)}px"/>')


@feature
def ellipse(rng: random.Random) -> Fragment:
    return Fragment(
        f'<ellipse cx="{rng.randint(40, 60)}" cy="50" rx="{rng.randint(9, 35)}" '
        f'ry="{rng.randint(9, 45)}"/>'
    )


@feature
def ellipse_auto(rng: random.Random) -> Fragment:
    return Fragment(
        f'<ellipse cx="50" cy="50" {rng.choice(["rx", "ry"])}="{rng.randint(15, 45)}"/>'
    )


@feature
def polygon(rng: random.Random) -> Fragment:
    points = [v for p in star(rng) for v in p]
    return Fragment(f'<polygon points="{" ".join(map(str, points))}"/>')


@feature
def polygon_compact(rng: random.Random) -> Fragment:
    points = [(30, -15), (30, 20), (-10.5, 20.5), (-20, -20)]
    words = [number(v, rng) for p in points for v in p]
    return Fragment(f'<polygon transform="translate(50 50)" points="{joined(words, rng)}"/>')


@feature
def polygon_odd(rng: random.Random) -> Fragment:
    return Fragment(f'<polygon points="20,20 {rng.randint(50, 80)},20 60,60 30"/>')


@feature
def polygon_evenodd(rng: random.Random) -> Fragment:
    rule = rng.choice(["evenodd", "nonzero"])
    return Fragment(f'<polygon fill-rule="{rule}" points="50,5 79,95 3,39 97,39 21,95"/>')


@feature
def polyline_open(rng: random.Random) -> Fragment:
    points = " ".join(f"{x},{y}" for x, y in star(rng))
    return Fragment(f'<polyline points="{points}"/>')


@feature
def line_without_area(rng: random.Random) -> Fragment:
    return Fragment(f'<line x1="5" y1="5" x2="{rng.randint(20, 90)}" y2="80"/>' + box(rng))


@feature
def line_stroked(rng: random.Random) -> Fragment:
    """A wall as a wide line, the usual maze."""
    width = rng.choice([4, 8])
    element = rng.choice(
        [
            '<line x1="10" y1="10" x2="90" y2="60"',
            '<polyline fill="none" points="10,10 80,10 80,80"',
            '<path fill="none" d="M10 10h70v70"',
        ]
    )
    return Fragment(f'{element} stroke="black" stroke-width="{width}"/>', must_say="")


# ---- transforms -------------------------------------------------------------------------------

_TRANSFORMS = (
    "translate(12)",
    "translate(10,-5)",
    "scale(1.3)",
    "scale(.5 1.5)",
    "rotate(30)",
    "rotate(30 50 50)",
    "rotate(-45,50,50)",
    "skewX(15)",
    "skewY(-10)",
    "matrix(1 .2 -.1 .9 5 3)",
    "scale(-1,1) translate(-100,0)",
    "translate(10 10)scale(.5)",
    "translate(10,10),rotate(5)",
    " translate( 10 , 10 ) , scale( 0.8 ) ",
    "matrix(1,0,0,1,5,6) rotate(10)",
)


@feature
def transform_list(rng: random.Random) -> Fragment:
    return Fragment(box(rng, f' transform="{rng.choice(_TRANSFORMS)}"', 20, 40))


@feature
def transform_nested(rng: random.Random) -> Fragment:
    a, b, c = rng.choices(_TRANSFORMS, k=3)
    inside = box(rng, f' transform="{c}"', 20, 40) + '<circle cx="50" cy="50" r="12"/>'
    return Fragment(f'<g transform="{a}"><g transform="{b}">{inside}</g></g>')


@feature
def transform_compact(rng: random.Random) -> Fragment:
    text = rng.choice(
        [
            "matrix(1-.2.1 1 30-10)",
            "translate(10-5)",
            "matrix(1 0 0 1 30-10)",
            "scale(.5.7)",
            "rotate(10 50 50)translate(5-5)",
            "translate(1e1-5)",
        ]
    )
    return Fragment(box(rng, f' transform="{text}"', 20, 40))


@feature
def transform_broken(rng: random.Random) -> Fragment:
    text = rng.choice(["translate(10", "foo(3)", "scale(a)", "rotate(1 2)", "translate(10px,5px)"])
    return Fragment(box(rng, f' transform="{text}"', 20, 40))


@feature
def transform_none(rng: random.Random) -> Fragment:
    return Fragment(box(rng, f' transform="{rng.choice(["none", "", " "])}"', 20, 40))


@feature
def transform_zero(rng: random.Random) -> Fragment:
    return Fragment(box(rng, ' transform="scale(0)"') + box(rng))


@feature
def css_transform_style(rng: random.Random) -> Fragment:
    text = rng.choice(_CSS_TRANSFORMS)
    return Fragment(box(rng, f' style="transform:{text}"', 20, 40), hints={"browser": True})


_CSS_TRANSFORMS = (
    "translate(15px,5px)",
    "translateX(15px)",
    "scale(1.4)",
    "rotate(20deg)",
    "matrix(1,0.2,0,1,4,4)",
    "rotate(0.1turn) translate(3px, 4px)",
    "skewX(10deg)",
    "translate(10%, 0)",
)


@feature
def css_transform_class(rng: random.Random) -> Fragment:
    text = rng.choice(_CSS_TRANSFORMS)
    selector, more = rng.choice(
        [
            (".m", ' class="m"'),
            ("rect", ""),
            ("#q", ' id="q"'),
            ("g rect", ""),
            ("g > .m", ' class="z m"'),
            ("rect:first-child", ""),
            ("[data-k]", ' data-k="1"'),
            ("*", ' class="k"'),
        ]
    )
    if selector == "*":
        selector = "rect,*.k"
    css = f"{selector}{{transform:{text}}}"
    return Fragment(box(rng, more, 20, 40), css=css, hints={"browser": True})


@feature
def css_transform_over_attribute(rng: random.Random) -> Fragment:
    more = ' transform="translate(30 0)" style="transform:translate(0,20px)"'
    return Fragment(box(rng, more, 10, 30), hints={"browser": True})


@feature
def transform_origin(rng: random.Random) -> Fragment:
    turn = f' transform="{rng.choice(["rotate(30)", "scale(.5)"])}"'
    origin = rng.choice(
        [
            ' transform-origin="50 50"',
            ' transform-origin="center"',
            ' style="transform-origin:50px 50px"',
            ' transform-origin="100% 0"',
            ' transform-origin="center" style="transform-box:fill-box"',
        ]
    )
    return Fragment(box(rng, turn + origin, 30, 50), hints={"browser": True})


@feature
def transform_origin_group(rng: random.Random) -> Fragment:
    body = f'<g transform="rotate(40)" transform-origin="50 50">{box(rng)}</g>'
    return Fragment(body, hints={"browser": True})


@feature
def css_individual_transform(rng: random.Random) -> Fragment:
    text = rng.choice(["rotate:30deg", "scale:0.5", "translate:20px 10px"])
    return Fragment(box(rng, f' style="{text}"', 20, 40), hints={"browser": True})


@feature
def transform_of_role_group(rng: random.Random) -> Fragment:
    return Fragment(
        f'<g id="obstacle" transform="{rng.choice(_TRANSFORMS)}">{box(rng, "", 20, 40)}</g>',
        hints={"own_role": True},
    )


@feature
def transform_of_root(rng: random.Random) -> Fragment:
    return Fragment(
        box(rng, "", 20, 40),
        head=f'width="100" height="100" transform="{rng.choice(_TRANSFORMS[:6])}"',
        hints={"browser": True},
    )


# ---- use, symbol, nested svg ------------------------------------------------------------------


def _link(rng: random.Random) -> str:
    return rng.choice(["href", "xlink:href"])


@feature
def use_shape(rng: random.Random) -> Fragment:
    defined = f"<defs>{box(rng, _S, 5, 20)}</defs>"
    move = rng.choice(['x="20" y="10"', 'y="30"', "", 'transform="rotate(20)"', 'x="5mm"'])
    return Fragment(f'<use {_link(rng)}="#s" {move}/>', outside=defined)


@feature
def use_of_visible(rng: random.Random) -> Fragment:
    return Fragment(
        f'{box(rng, _OBSTACLE7, 5, 20)}<use {_link(rng)}="#obstacle7" x="30" y="20"/>',
        hints={"own_role": True},
    )


@feature
def use_group(rng: random.Random) -> Fragment:
    inner = box(rng, "", 5, 20) + '<circle cx="50" cy="20" r="9"/>'
    group = f'<g id="s" transform="translate(5 5)">{inner}</g>'
    return Fragment(
        f'<use {_link(rng)}="#s" x="10" y="5" transform="scale(.9)"/>',
        outside=f"<defs>{group}</defs>",
    )


@feature
def use_nested(rng: random.Random) -> Fragment:
    defs = (
        f'<defs>{box(rng, _S, 5, 10)}<g id="t"><use {_link(rng)}="#s"/>'
        f'<use {_link(rng)}="#s" x="35"/></g></defs>'
    )
    return Fragment(f'<use {_link(rng)}="#t"/><use {_link(rng)}="#t" y="45"/>', outside=defs)


@feature
def use_symbol(rng: random.Random) -> Fragment:
    symbol = f'<symbol id="s" overflow="visible">{box(rng, "", 5, 20)}</symbol>'
    return Fragment(f'<use {_link(rng)}="#s" x="20" y="10"/>', outside=symbol)


@feature
def use_symbol_viewbox(rng: random.Random) -> Fragment:
    aspect = rng.choice(
        ["", ' preserveAspectRatio="none"', ' preserveAspectRatio="xMinYMax slice"']
    )
    inner = '<rect x="1" y="2" width="8" height="12"/>'
    symbol = f'<symbol id="s" viewBox="0 0 10 20"{aspect}>{inner}</symbol>'
    size = rng.choice(
        ['width="60" height="60"', 'width="40" height="60"', 'width="50%" height="50%"']
    )
    return Fragment(f'<use {_link(rng)}="#s" x="20" y="10" {size}/>', outside=symbol)


@feature
def use_symbol_clipped(rng: random.Random) -> Fragment:
    symbol = '<symbol id="s" viewBox="0 0 10 10"><rect x="5" y="2" width="20" height="5"/></symbol>'
    return Fragment('<use href="#s" x="10" y="10" width="40" height="40"/>', outside=symbol)


@feature
def use_svg(rng: random.Random) -> Fragment:
    small = 'id="s" viewBox="0 0 50 50" width="30" height="30"'
    inner = f"<defs><svg {small}>{box(rng, '', 3, 12)}</svg></defs>"
    size = rng.choice(["", 'width="60" height="60"'])
    return Fragment(f'<use {_link(rng)}="#s" x="20" y="10" {size}/>', outside=inner)


@feature
def use_broken(rng: random.Random) -> Fragment:
    link = rng.choice(["#nothing", "other.svg#a", "", "#u1"])
    return Fragment(f'<use id="u1" href="{link}"/>' + box(rng))


@feature
def use_hidden(rng: random.Random) -> Fragment:
    defined = f"<defs>{box(rng, _S, 5, 20)}</defs>"
    return Fragment(
        f'<use href="#s" display="none" x="30"/>{box(rng)}', outside=defined, must_say=SEEN
    )


@feature
def use_inherits(rng: random.Random) -> Fragment:
    defined = '<defs><path id="s" d="M10 10h60v60h-60zM25 25h30v30h-30z"/></defs>'
    return Fragment('<use href="#s" fill-rule="evenodd"/>', outside=defined)


@feature
def symbol_not_used(rng: random.Random) -> Fragment:
    kind = rng.choice(["symbol", "defs", "clipPath", "mask", "marker", "pattern", "linearGradient"])
    inner = "" if kind == "linearGradient" else box(rng)
    return Fragment(f'<{kind} id="s">{inner}</{kind}>{box(rng)}')


@feature
def nested_svg(rng: random.Random) -> Fragment:
    x, y = rng.randint(5, 30), rng.randint(5, 30)
    return Fragment(f'<svg x="{x}" y="{y}" overflow="visible">{box(rng)}</svg>')


@feature
def nested_svg_viewbox(rng: random.Random) -> Fragment:
    aspect = rng.choice(
        [
            "",
            ' preserveAspectRatio="none"',
            ' preserveAspectRatio="xMaxYMin meet"',
            ' preserveAspectRatio="xMidYMid slice"',
            ' preserveAspectRatio="xMinYMid"',
        ]
    )
    return Fragment(
        f'<svg x="10" y="20" width="{rng.randint(40, 80)}" height="60" viewBox="0 0 20 20"{aspect}>'
        '<rect x="4" y="3" width="11" height="14"/></svg>'
    )


@feature
def nested_svg_percent(rng: random.Random) -> Fragment:
    return Fragment(
        '<svg x="10%" y="10%" width="50%" height="80%" viewBox="0 0 10 10">'
        '<rect x="20%" y="2" width="50%" height="6"/></svg>'
    )


@feature
def nested_svg_clipped(rng: random.Random) -> Fragment:
    return Fragment(
        f'<svg x="10" y="10" width="40" height="40"><rect x="{rng.randint(5, 20)}" y="5" '
        'width="60" height="20"/></svg>'
    )


@feature
def nested_svg_zero(rng: random.Random) -> Fragment:
    return Fragment(f'<svg width="0" height="0">{box(rng)}</svg>{box(rng)}')


# ---- units ------------------------------------------------------------------------------------


@feature
def length_units(rng: random.Random) -> Fragment:
    unit = rng.choice(["mm", "cm", "in", "pt", "pc", "px", "%", "Q", "em"])
    size = {"mm": 12, "cm": 1.2, "in": 0.5, "pt": 30, "pc": 2, "px": 40, "%": 40, "Q": 50, "em": 2}
    s = size[unit]
    kind = rng.choice(
        [
            f'<rect x="5" y="5" width="{s}{unit}" height="{s}{unit}"/>',
            f'<circle cx="50" cy="50" r="{s / 2}{unit}"/>',
            f'<rect x="{s / 2}{unit}" y="{s / 4}{unit}" width="30" height="20"/>',
        ]
    )
    return Fragment(kind)


UNITS = r"unit|viewBox|width|mm|px"


@feature
def root_viewbox(rng: random.Random) -> Fragment:
    size = rng.choice([50, 200])
    low = rng.choice([0, -size // 4])
    s = size / 100
    body = f'<rect x="{20 * s + low}" y="{15 * s + low}" width="{30 * s}" height="{55 * s}"/>'
    return Fragment(
        body,
        head=f'width="100" height="100" viewBox="{low} {low} {size} {size}"',
        hints={"viewbox": (low, low, size, size), "unit": s},
    )


@feature
def root_millimetres(rng: random.Random) -> Fragment:
    unit, px = rng.choice([("mm", 96 / 25.4), ("cm", 960 / 25.4), ("in", 96.0)])
    width = {"mm": 30, "cm": 3, "in": 1}[unit]
    size = rng.choice([30, 100, 377.95])
    s = size / 100
    body = f'<rect x="{20 * s}" y="{15 * s}" width="{30 * s}" height="{55 * s}"/>'
    return Fragment(
        body,
        head=f'width="{width}{unit}" height="{width}{unit}" viewBox="0 0 {size} {size}"',
        must_say=UNITS,
        hints={"viewbox": (0, 0, size, size), "canvas": width * px, "mm": True, "unit": s},
    )


@feature
def root_millimetres_no_viewbox(rng: random.Random) -> Fragment:
    return Fragment(
        box(rng),
        head='width="30mm" height="30mm"',
        must_say=UNITS,
        hints={"canvas": 30 * 96 / 25.4, "mm": True},
    )


@feature
def root_viewbox_stretched(rng: random.Random) -> Fragment:
    """Not the same scale along x and y: user units and what is seen differ in shape."""
    body = '<rect x="10" y="10" width="20" height="20"/>'
    return Fragment(
        body,
        head='width="100" height="100" viewBox="0 0 100 50" preserveAspectRatio="none"',
        hints={"stretched": (0, 0, 100, 50)},
    )


# ---- style: what is seen ----------------------------------------------------------------------


@feature
def display_none(rng: random.Random) -> Fragment:
    return _unseen(rng, "display", "none")


@feature
def display_none_group(rng: random.Random) -> Fragment:
    way = rng.choice([' display="none"', ' style="display:none"', ' style="display : none ;"'])
    return Fragment(f"<g{way}>{box(rng)}<g>{box(rng)}</g></g>{box(rng)}", must_say=SEEN)


@feature
def visibility_hidden(rng: random.Random) -> Fragment:
    return _unseen(rng, "visibility", rng.choice(["hidden", "collapse"]))


@feature
def visibility_child_visible(rng: random.Random) -> Fragment:
    return Fragment(f'<g visibility="hidden">{box(rng)}{box(rng, _VISIBLE)}</g>', must_say=SEEN)


@feature
def opacity_zero(rng: random.Random) -> Fragment:
    return _unseen(rng, rng.choice(["opacity", "fill-opacity"]), rng.choice(["0", "0%"]))


@feature
def fill_transparent(rng: random.Random) -> Fragment:
    return _unseen(rng, "fill", rng.choice(["transparent", "#0000", "rgba(0,0,0,0)"]))


@feature
def fill_none_no_stroke(rng: random.Random) -> Fragment:
    return _unseen(rng, "fill", "none")


def _unseen(rng: random.Random, name: str, value: str) -> Fragment:
    """Hide one of two rectangles by attribute, style, class, id or element rule."""
    seen = '<circle cx="80" cy="80" r="15"/>'
    way = rng.randint(0, 5)
    attributes = (
        f' {name}="{value}"',
        f' style="{name}:{value}"',
        ' class="h"',
        ' id="h"',
        "",
        f' style="{name}:{value} !important"',
    )
    rules = (
        "",
        "",
        f".h{{{name}:{value}}}",
        f"#h{{{name}:{value}}}",
        f"rect{{{name}:{value}}}",
        "",
    )
    return Fragment(box(rng, attributes[way], 5, 30) + seen, css=rules[way], must_say=SEEN)


@feature
def css_cascade(rng: random.Random) -> Fragment:
    """Which of two rules counts: specificity, order, importance, style over attribute."""
    css, more = rng.choice(
        [
            ("#a{display:inline} rect{display:none}", ' id="a"'),
            ("rect{display:none} .b{display:inline}", ' class="b"'),
            (".b{display:none} .b{display:inline}", ' class="b"'),
            (".b{display:none!important} #a{display:inline}", ' id="a" class="b"'),
            ("rect{display:none}", ' style="display:inline"'),
            ("rect{display:inline}", ' display="none"'),
            (".b{display:none!important}", ' class="b" style="display:inline"'),
            ("/* rect{display:none} */", ""),
            ("@media print{rect{display:none}}", ""),
            ("@media screen{rect{display:none}}", ""),
            ("g>g rect{display:none}", ""),
            ("rect.b.c{display:none}", ' class="b c"'),
            ("rect:not(.b){display:none}", ' class="b"'),
            ("circle,rect{display:none}", ""),
        ]
    )
    seen = '<path d="M80 80h15v15h-15z"/>'
    said = SEEN if "none" in css else ""
    return Fragment(
        box(rng, more, 5, 30) + seen, css=css, hints={"browser": True, "must_say_if_hidden": said}
    )


@feature
def css_rule_evenodd(rng: random.Random) -> Fragment:
    css, more, group = rng.choice(
        [
            (".e{fill-rule:evenodd}", ' class="e"', ""),
            ("path{fill-rule:evenodd}", "", ""),
            ("#e{fill-rule:evenodd}", ' id="e"', ""),
            ("g{fill-rule:evenodd}", "", ""),
            ("svg{fill-rule:evenodd}", "", ""),
            (".e{fill-rule:evenodd}", "", ' class="e"'),
            ("path{fill-rule:nonzero}", ' fill-rule="evenodd"', ""),
            ("*{fill-rule:evenodd}", "", ""),
            ("", ' style="FILL-RULE:evenodd"', ""),
            ("", ' style="fill-rule:evenodd!important"', ""),
            ("", ' style="fill:#000;fill-rule:evenodd;stroke:none"', ""),
            ("", "", ' style="fill-rule:evenodd"'),
            ("", ' fill-rule="inherit"', ' fill-rule="evenodd"'),
            ("", ' fill-rule="bogus"', ' fill-rule="evenodd"'),
        ]
    )
    return Fragment(
        f'<g{group}><path d="M10 10h60v60h-60z M25 25h30v30h-30z"{more}/></g>',
        css=css,
        hints={"browser": True},
    )


@feature
def css_in_defs(rng: random.Random) -> Fragment:
    css = rng.choice(["<![CDATA[.h{display:none}]]>", ".h{display:none}"])
    kind = rng.choice(["", ' type="text/css"', ' id="style1"'])
    return Fragment(
        f'{box(rng, _H)}<circle cx="80" cy="80" r="15"/>',
        outside=f"<defs><style{kind}>{css}</style></defs>",
        must_say=SEEN,
    )


@feature
def fill_none_with_stroke(rng: random.Random) -> Fragment:
    """A closed outline without fill: the importer takes its inside."""
    style = rng.choice(
        [' fill="none" stroke="black"', ' style="fill:none;stroke:#000;stroke-width:1"']
    )
    return Fragment(box(rng, style), hints={"paint": "outline"})


@feature
def stroke_on_fill(rng: random.Random) -> Fragment:
    width = rng.choice([6, 10])
    return Fragment(
        box(rng, f' stroke="black" stroke-width="{width}"', 20, 50),
        hints={"paint": "stroke"},
    )


@feature
def switch_first(rng: random.Random) -> Fragment:
    return Fragment(f"<switch>{box(rng)}{box(rng)}{box(rng)}</switch>", must_say=SEEN + "|switch")


@feature
def switch_language(rng: random.Random) -> Fragment:
    return Fragment(
        f"<switch>{box(rng, _DE)}{box(rng, _EN)}{box(rng)}</switch>",
        must_say=SEEN + "|switch|language",
    )


@feature
def system_language_alone(rng: random.Random) -> Fragment:
    attribute = rng.choice(['systemLanguage="de"', 'requiredExtensions="http://x.example/"'])
    return Fragment(
        box(rng, f" {attribute}", 5, 30) + '<circle cx="80" cy="80" r="15"/>',
        must_say=SEEN + "|language|Extensions",
    )


# ---- clips, masks, effects, paint -------------------------------------------------------------


@feature
def clip_path(rng: random.Random) -> Fragment:
    way = rng.choice(
        [' clip-path="url(#c)"', ' style="clip-path:url(#c)"', " style=\"clip-path: url('#c')\""]
    )
    clip = '<clipPath id="c"><rect x="20" y="20" width="30" height="30"/></clipPath>'
    target = rng.choice(
        [f"<g{way}>{box(rng, '', 10, 30)}</g>", f'<circle cx="40" cy="40" r="25"{way}/>']
    )
    return Fragment(target, outside=rng.choice([clip, f"<defs>{clip}</defs>"]))


@feature
def clip_path_class(rng: random.Random) -> Fragment:
    clip = '<clipPath id="c"><rect x="20" y="20" width="30" height="30"/></clipPath>'
    return Fragment(
        '<circle class="k" cx="40" cy="40" r="25"/>', outside=clip, css=".k{clip-path:url(#c)}"
    )


@feature
def clip_path_shape(rng: random.Random) -> Fragment:
    shape = rng.choice(["circle(10px at 20px 20px)", "inset(8px)", "polygon(0 0,20px 0,0 20px)"])
    return Fragment(
        f'<rect x="10" y="10" width="60" height="60" style="clip-path:{shape}"/>',
        hints={"browser": True},
    )


@feature
def mask(rng: random.Random) -> Fragment:
    mask = '<mask id="c"><rect x="20" y="20" width="30" height="30" fill="white"/></mask>'
    return Fragment('<circle cx="40" cy="40" r="25" mask="url(#c)"/>', outside=mask)


@feature
def filter_moves(rng: random.Random) -> Fragment:
    moved = '<filter id="f" x="-1" y="-1" width="3" height="3"><feOffset dx="25"/></filter>'
    return Fragment(box(rng, ' filter="url(#f)"', 10, 40), outside=moved)


@feature
def pattern_fill(rng: random.Random) -> Fragment:
    pattern = (
        '<pattern id="p" width="30" height="30" patternUnits="userSpaceOnUse">'
        '<rect width="15" height="30"/></pattern>'
    )
    return Fragment('<rect x="10" y="10" width="80" height="60" fill="url(#p)"/>', outside=pattern)


@feature
def gradient_fill(rng: random.Random) -> Fragment:
    gradient = (
        '<linearGradient id="p"><stop offset="0.5" stop-opacity="0"/>'
        '<stop offset="0.5" stop-opacity="1"/></linearGradient>'
    )
    return Fragment('<rect x="10" y="10" width="80" height="60" fill="url(#p)"/>', outside=gradient)


@feature
def marker(rng: random.Random) -> Fragment:
    mark = (
        '<marker id="m" markerWidth="20" markerHeight="20" refX="10" refY="10" '
        'markerUnits="userSpaceOnUse"><rect width="20" height="20"/></marker>'
    )
    return Fragment('<path d="M30 30h40v40z" marker-start="url(#m)"/>', outside=mark)


@feature
def text(rng: random.Random) -> Fragment:
    return Fragment(
        box(rng) + '<text x="5" y="95" font-size="20">wall</text>', hints={"told": True}
    )


@feature
def image(rng: random.Random) -> Fragment:
    data = (  # one black pixel
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVO"
        "RK5CYII="
    )
    return Fragment(
        box(rng)
        + f'<image x="5" y="70" width="20" height="20" href="data:image/png;base64,{data}"/>',
        hints={"told": True},
    )


# ---- structure --------------------------------------------------------------------------------


@feature
def use_role_of_target(rng: random.Random) -> Fragment:
    """The role stands at what is used, which alone is not painted."""
    kind = rng.choice(["g", "symbol"])
    defined = f'<defs><{kind} id="obstacle">{box(rng, "", 5, 20)}</{kind}></defs>'
    return Fragment(f'<use {_link(rng)}="#obstacle" x="20"/>', defined, hints={"own_role": True})


@feature
def use_own_role(rng: random.Random) -> Fragment:
    defined = f"<defs>{box(rng, _S, 5, 20)}</defs>"
    body = f'<use id="obstacle3" {_link(rng)}="#s" x="20"/><g id="obstacle">{box(rng)}</g>'
    return Fragment(body, defined, hints={"own_role": True})


@feature
def id_like_a_mark(rng: random.Random) -> Fragment:
    """Ids that happen to begin like a role, inside a group that is an obstacle."""
    name = rng.choice(["original2", "startled", "goalpost", "origin", "Robotics-lab", "workspace1"])
    return Fragment(
        f'{box(rng, f" id={chr(34)}{name}{chr(34)}", 5, 20)}<circle cx="80" cy="80" r="15"/>',
        hints={"named": True},
    )


@feature
def link_element(rng: random.Random) -> Fragment:
    return Fragment(f'<a href="#x" transform="translate(5 5)">{box(rng)}</a>')


@feature
def description_elements(rng: random.Random) -> Fragment:
    what = rng.choice(
        [
            "<title>t</title>",
            "<desc>d</desc>",
            "<metadata/>",
            '<sodipodi:namedview id="v"/>',
            "<!-- c -->",
            "<?pi x?>",
            "<linearGradient id='lg'/>",
            "<script>1</script>",
        ]
    )
    return Fragment(what + box(rng) + f"<g>{what.replace('lg', 'lh')}</g>")


@feature
def foreign_element(rng: random.Random) -> Fragment:
    """An element of another namespace that is called like a shape is not painted."""
    return Fragment(
        '<x:rect xmlns:x="http://x.example/" x="5" y="5" width="40" height="40"/>'
        '<circle cx="80" cy="80" r="15"/>'
    )


@feature
def unknown_container(rng: random.Random) -> Fragment:
    return Fragment(f'<layer>{box(rng)}</layer><circle cx="80" cy="80" r="15"/>')


@feature
def shape_in_shape(rng: random.Random) -> Fragment:
    """Children of a shape are not painted."""
    return Fragment(f'<rect x="5" y="5" width="20" height="20">{box(rng)}</rect>')


@feature
def prefixed_names(rng: random.Random) -> Fragment:
    return Fragment(
        '<s:g xmlns:s="http://www.w3.org/2000/svg">'
        '<s:rect x="5" y="5" width="40" height="30"/></s:g>'
    )


@feature
def foreign_object(rng: random.Random) -> Fragment:
    return Fragment(
        f"<foreignObject><svg>{box(rng)}</svg></foreignObject>{box(rng)}",
        hints={"told": True},
    )


@feature
def off_canvas(rng: random.Random) -> Fragment:
    """Things outside the page count: the canvas is no limit of the world."""
    return Fragment('<rect x="80" y="10" width="15" height="20"/>' + box(rng))


@feature
def capital_tag(rng: random.Random) -> Fragment:
    return Fragment('<RECT x="5" y="5" width="40" height="30"/>' + box(rng))


def _mixed(rng: random.Random) -> Fragment:
    """Put three plain features on one canvas, ids made distinct."""
    parts = []
    while len(parts) < 3:
        part = MAKERS[rng.choice(list(MAKERS))](rng)
        special = part.hints.keys() - {"browser"} or part.css or "100" not in part.head
        if not special and "viewBox" not in part.head:
            parts.append(part)
    body = outside = ""
    browser = any(part.hints.get("browser") for part in parts)
    for k, part in enumerate(parts):
        body += _renamed(part.body, k)
        outside += _renamed(part.outside, k)
    said = next((part.must_say for part in parts if part.must_say), "")
    return Fragment(body, outside, must_say=said, hints={"browser": browser})


def _renamed(text: str, k: int) -> str:
    for mark in ('id="', "#"):
        text = text.replace(mark, f"{mark}k{k}")
    return text


MAKERS["mixed"] = _mixed
