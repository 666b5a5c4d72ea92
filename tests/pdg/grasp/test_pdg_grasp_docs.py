"""The worked example of docs/grasp.md says what it gives."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest


def test_worked_example():
    text = (Path(__file__).parents[3] / "docs" / "grasp.md").read_text(encoding="utf-8")
    code = re.findall(r"```python\n(.*?)```", text, re.DOTALL)[0]
    names: dict[str, Any] = {}
    exec(code, names)
    assert names["closure"].state == "closed"
    assert names["whole"].lower == pytest.approx(0.99829, abs=1e-4)
    assert names["first"].case == "point"
    assert names["first"].offset == pytest.approx([1, -0.0419], abs=1e-4)
    assert names["active"].lower == pytest.approx(0.55259, abs=1e-4)
    assert names["active"].direction == pytest.approx([0.298, -0.596, -0.745], abs=1e-3)
