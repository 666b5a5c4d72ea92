"""Draw the picture of the tutorial by running its Python: ``python docs/draw_tutorial.py``.

Needs the installed package. Rewrites ``docs/pictures/tutorial.png``.
"""

import re
from pathlib import Path
from typing import Any

from small_picture import save_small

HERE = Path(__file__).parent
DPI = 90  # as in the gallery


def main() -> None:
    """Run the page down to its drawing."""
    page = (HERE / "tutorial.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    for block in blocks:
        exec(block.replace(', "table.png"', ""), names)
        if "figure" in names:
            break
    save_small(names["figure"], HERE / "pictures" / "tutorial.png", DPI)


if __name__ == "__main__":
    main()
