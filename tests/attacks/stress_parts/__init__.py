"""The parts of ``tests/attacks/stress.py``: each module has ``run(settings) -> Iterable[Row]``.

`PARTS` names them in the order in which they run; `common` holds what they share.
"""

PARTS: tuple[str, ...] = (
    "invariance",
    "random_scenes",
    "contact",
    "critical",
    "false_no_path",
    "faults",
    "hostile",
)
