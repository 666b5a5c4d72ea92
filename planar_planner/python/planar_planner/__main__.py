"""The process of the command line, of ``planar-planner`` and of ``python -m planar_planner``."""

from __future__ import annotations

import os
import sys

from planar_planner.cli.leave import answer_interrupts, ignore_interrupts


def run() -> int:
    """Run the command line with Ctrl-C answered from here to the end of the process.

    Nothing that takes time is imported before.
    """
    answer_interrupts()
    from planar_planner.cli.main import outcome

    found = outcome()
    ignore_interrupts()
    if found.interrupted:  # libraries that were interrupted can crash when the interpreter ends
        for stream in (sys.stdout, sys.stderr):
            if stream is not None:
                stream.flush()
        os._exit(found.status)
    return found.status


if __name__ == "__main__":
    sys.exit(run())
