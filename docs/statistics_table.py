"""Write the table of statistics in docs/method.md from the core's own list.

Run it as ``python docs/statistics_table.py`` after a change of the list in native/statistics.hpp.
"""

from __future__ import annotations

from pathlib import Path

from planar_planner import Seconds, Statistics

PAGE = Path(__file__).with_name("method.md")
BEGIN = "<!-- statistics: written by docs/statistics_table.py -->"
END = "<!-- statistics: end -->"


def block() -> str:
    """Return the table between its two marks."""
    rows = ["| key | meaning |", "|---|---|"]
    for name in Statistics().to_dict():
        rows.append(f"| `{name}` | {_meaning(Statistics, name)} |")
        if name == "seconds":
            rows += [
                f"| `seconds.{clock}` | {_meaning(Seconds, clock)} |"
                for clock in Seconds().to_dict()
            ]
    return "\n".join([BEGIN, *rows, END])


def _meaning(kind: type, name: str) -> str:
    return " ".join(str(getattr(kind, name).__doc__).split())


def main() -> None:
    """Replace what stands between the marks."""
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    after = rest.partition(END)[2]
    if not after:
        raise SystemExit(f"{PAGE}: the marks are missing")
    PAGE.write_text(f"{before}{block()}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
