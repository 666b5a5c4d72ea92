"""Random path data: star-shaped outlines whose edges are drawn by every command."""

from __future__ import annotations

import math
import random

Point = tuple[float, float]


def number(value: float, rng: random.Random) -> str:
    """Write a number in one of the ways the grammar allows."""
    value = round(value, 2)
    text = repr(value)
    ways = [text, f"{value:g}", f"{value:.3f}"]
    if value == int(value):
        ways.append(str(int(value)))
    if abs(value) < 1 and value != 0:
        ways.append(text.replace("0.", ".", 1))
    if value != 0 and rng.random() < 0.1:
        ways.append(f"{value / 10:.4f}e1")
    if value > 0 and rng.random() < 0.05:
        ways.append("+" + text)
    return rng.choice(ways)


def joined(numbers: list[str], rng: random.Random) -> str:
    """Put numbers one after another; a separator is left out where the grammar allows it."""
    text = ""
    for word in numbers:
        glued = text and (word[0] in "+-" or (word[0] == "." and "." in text.rsplit(" ", 1)[-1]))
        glued = glued and "e" not in text[-4:]
        if not text or (glued and rng.random() < 0.7):
            text += word
        else:
            text += rng.choice([" ", ",", ", ", " , ", "\n", "\t"]) + word
    return text


def star(rng: random.Random, corners: int | None = None, size: float = 1.0) -> list[Point]:
    """Return the corners of a star-shaped outline in the middle of the drawing."""
    n = corners or rng.randint(3, 7)
    cx, cy = rng.uniform(35, 65), rng.uniform(35, 65)
    turn = rng.uniform(0, math.tau)
    points = []
    for k in range(n):
        r = rng.uniform(14, 28) * size
        t = turn + math.tau * (k + rng.uniform(-0.25, 0.25)) / n
        points.append((round(cx + r * math.cos(t), 1), round(cy + r * math.sin(t), 1)))
    return points


class Pen:
    """Writes path data command by command, absolute or relative."""

    def __init__(self, rng: random.Random, commands: str, relative: float = 0.5) -> None:
        self._rng = rng
        self._commands = commands
        self._relative = relative
        self._text: list[str] = []
        self._at: Point = (0.0, 0.0)
        self._last = ""

    @property
    def text(self) -> str:
        """What has been written."""
        return self._rng.choice(["", " "]).join(self._text)

    def outline(self, points: list[Point], *, close: bool = True) -> None:
        """Write one closed outline, or one that only filling closes."""
        start = points[0]
        self._write("M", [start], start)
        for p in points[1:]:
            self._edge(p)
        if close:
            self._text.append(self._rng.choice("zZ"))
            self._at, self._last = start, "z"

    def _edge(self, p: Point) -> None:
        kind = self._rng.choice(self._commands)
        (x, y), (px, py) = self._at, p
        across = (-(py - y), px - x)
        bend = self._rng.uniform(-0.15, 0.3)

        def near(t: float) -> Point:
            return (
                round(x + t * (px - x) + bend * across[0], 2),
                round(y + t * (py - y) + bend * across[1], 2),
            )

        if kind == "L":
            self._write("L", [p], p)
        elif kind == "H":
            corner = (px, y)
            self._write("H", [corner], corner)
            self._write("V", [p], p)
        elif kind == "C":
            self._write("C", [near(0.3), near(0.7), p], p)
        elif kind == "S":
            self._write("S", [near(0.7), p], p)
        elif kind == "Q":
            self._write("Q", [near(0.5), p], p)
        elif kind == "T":
            self._write("T", [p], p)
        else:
            self._arc(p)

    def _arc(self, p: Point) -> None:
        chord = math.dist(self._at, p)
        rx = round(chord * self._rng.uniform(0.7, 2.0), 2)
        ry = rx if self._rng.random() < 0.5 else round(rx * self._rng.uniform(0.8, 1.2), 2)
        rng = self._rng
        turn, large, sweep = rng.choice([0, 0, 30, -20]), 0, rng.randint(0, 1)
        relative = rng.random() < self._relative
        x, y = (p[0] - self._at[0], p[1] - self._at[1]) if relative else p
        head = joined([number(rx, rng), number(ry, rng), number(turn, rng)], rng)
        flags = rng.choice(
            [f"{large} {sweep} ", f"{large}{sweep} ", f"{large}{sweep}", f"{large},{sweep},"]
        )
        xs = number(x, rng)
        if flags[-1] in "01" and xs[0] == "+":
            xs = xs[1:]
        tail = joined([xs, number(y, rng)], rng)
        self._text.append(f"{'a' if relative else 'A'}{head} {flags}{tail}")
        self._at = p if not relative else self._shifted(x, y)
        self._last = "A"

    def _shifted(self, x: float, y: float) -> Point:
        return self._at[0] + round(x, 2), self._at[1] + round(y, 2)

    def _write(self, letter: str, points: list[Point], end: Point) -> None:
        relative = self._rng.random() < self._relative
        x0, y0 = self._at if relative else (0.0, 0.0)
        words = []
        for x, y in points:
            if letter != "V":
                words.append(number(x - x0, self._rng))
            if letter != "H":
                words.append(number(y - y0, self._rng))
        name = letter.lower() if relative else letter
        implied = self._last == name and name not in "Mm" and self._rng.random() < 0.4
        implied = implied or (
            (self._last, name) in (("M", "L"), ("m", "l")) and self._rng.random() < 0.4
        )
        space = " " if implied else self._rng.choice(["", " "])
        self._text.append(("" if implied else name) + space + joined(words, self._rng))
        if implied:
            self._text[-1] = " " + self._text[-1].lstrip()
        self._at, self._last = end, name
