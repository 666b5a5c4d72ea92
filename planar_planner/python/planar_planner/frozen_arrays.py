"""Results hold arrays that nobody may change, also after they were copied or sent on."""

from __future__ import annotations

from typing import Any

import numpy as np


class FrozenArrays:
    """A base of dataclasses whose arrays stay read-only through `pickle` and `copy`."""

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        freeze(self)


def freeze(owner: object) -> None:
    """Make the arrays among an object's attributes read-only."""
    for value in vars(owner).values():
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
