"""The answers of one call for many rows: one array a field, and the single answer of each row."""

from __future__ import annotations

import dataclasses
from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any, Self, TypeVar, overload

import numpy as np

One_co = TypeVar("One_co", covariant=True)


class Batch(Sequence[One_co]):
    """Answers for n rows, in the rows' order: a sequence of the single answers.

    A batch has the fields of the single answer, in their order. Each is an array whose first axis
    has length n, or a batch itself. ``batch[i]`` is the single answer of row i, and a slice is a
    batch of these rows.
    """

    __slots__ = ()

    @abstractmethod
    def _row(self, row: int) -> One_co:
        """Return the single answer of one row."""

    def _values(self, row: int) -> list[Any]:
        """Return each field's value in one row: numbers, strings, tuples and single answers."""
        return [_plain(column[row]) for column in self._columns()]

    def _columns(self) -> list[Any]:
        return [getattr(self, name) for name in self._names()]

    @classmethod
    def _names(cls) -> list[str]:
        return [field.name for field in dataclasses.fields(cls)]  # type: ignore[arg-type]

    def __len__(self) -> int:
        return len(self._columns()[0])

    @overload
    def __getitem__(self, row: int) -> One_co: ...
    @overload
    def __getitem__(self, row: slice) -> Self: ...
    def __getitem__(self, row: int | slice) -> One_co | Self:
        if isinstance(row, slice):
            return type(self)(*(column[row] for column in self._columns()))
        return self._row(row)

    def __iter__(self) -> Iterator[One_co]:
        return (self._row(row) for row in range(len(self)))


def _plain(value: Any) -> Any:
    """Return numpy's scalars and rows as Python's own numbers, strings and tuples."""
    if isinstance(value, np.ndarray):
        return tuple(value.tolist())
    return value.item() if isinstance(value, np.generic) else value
