"""The search reads no clock: planning reads it, and hands down stopwatches and limits."""

from __future__ import annotations

import re

from architecture.import_graph import native_files

READS_THE_CLOCK = {"planar_planner/native/planning/limit_watch.cpp"}
CLOCK = re.compile(r"#include <(chrono|ctime|time\.h|sys/time\.h)>|_clock\b|\bclock_gettime\b")


def test_one_file_of_the_planner_reads_the_clock() -> None:
    files = {n: p for n, p in native_files().items() if n.startswith("planar_planner/")}
    assert len(files) > 80
    reading = {n for n, p in files.items() if CLOCK.search(p.read_text(encoding="utf-8"))}
    assert reading == READS_THE_CLOCK


def test_only_planning_and_bindings_ask_for_the_time() -> None:
    asking = {
        name.split("/")[2]
        for name, path in native_files().items()
        if name.startswith("planar_planner/") and "steady_seconds" in path.read_text("utf-8")
    }
    assert asking == {"planning"}
