"""What reproduces a measurement, as for attacks, and one core to measure on."""

from __future__ import annotations

import os

from support.provenance import RESULTS, ROOT, print_provenance, provenance, write_csv

__all__ = ["RESULTS", "ROOT", "print_provenance", "provenance", "use_one_core", "write_csv"]


def use_one_core() -> None:
    """Keep this process on one core, where the system allows that."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
