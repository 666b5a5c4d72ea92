"""Certificates with odd numbers: ``python tests/attacks/certificate_numbers.py``.

One or two numbers of a true certificate are replaced, by tiny, huge and denormal ones among others.
It is then refused, or it still proves the verdict that the scene has; any other error, and any
other verdict, is a failure. ``--seed`` and ``--count`` say which changes are made.
"""

from __future__ import annotations

import argparse
import copy
import random
import sys
from collections import Counter
from collections.abc import Iterator
from typing import Any

from planar_planner import CertificateError, solve, verify_certificate

SCENES = ("corner", "slot-jammed", "slide-blocked", "disc-jammed")
NUMBERS: tuple[float, ...] = (
    *(0, -0.0, 5e-324, 2.2250738585072014e-308, 1e-300, 2.0**-260, 2.0**-261, 1e-17, 1e17),
    *(2.0**60, 2.0**100, 2.0**101, 1e300, 1.7976931348623157e308, float("inf"), float("nan")),
    *(2**60, 2**63, 2**64, 10**400, -1, -(2**63)),
)


def places(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield container and key of every number below a value."""
    if isinstance(value, (dict, list)):
        for key, each in value.items() if isinstance(value, dict) else enumerate(value):
            if type(each) in (int, float):
                yield value, key
            yield from places(each)


def attack(name: str, verdict: str, certificate: dict[str, Any], seed: int) -> str:
    """Change the certificate and verify it; return what came of it, or raise AssertionError."""
    chosen = random.Random(seed)
    forged = copy.deepcopy(certificate)
    for container, key in chosen.sample(list(places(forged)), chosen.choice((1, 2))):
        sign = chosen.choice((1, -1))
        container[key] = sign * chosen.choice(NUMBERS)
    try:
        proven = verify_certificate(name, forged)
    except CertificateError as refused:
        return type(refused).__name__
    assert proven.verdict == verdict, (name, seed, proven)
    return "still proven"


def run(first_seed: int, count: int) -> Counter[str]:
    """Attack every scene so many times; return how often what came of it."""
    found: Counter[str] = Counter()
    for name in SCENES:
        result = solve(name, certificate=True)
        assert result.certificate is not None
        certificate = result.certificate
        found.update(
            attack(name, result.verdict, certificate, seed)
            for seed in range(first_seed, first_seed + count)
        )
    return found


def main() -> int:
    """Print the seed and what came of the changes."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=1000)
    arguments = parser.parse_args()
    print(f"seeds {arguments.seed} to {arguments.seed + arguments.count - 1}")
    print(dict(run(arguments.seed, arguments.count)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
