"""A sample of the attack on exact fits, and that it would notice a wrong answer."""

from __future__ import annotations

import re

import pytest

from attacks import exact_fits
from oracles.rectilinear import is_joined


def test_a_sample(capsys: pytest.CaptureFixture[str]) -> None:
    assert exact_fits.main(["--scenes", "700", "--turning", "20", "--certified", "0.1"]) == 0
    printed = capsys.readouterr().out
    assert "707 scenes without turning: every answer is the oracle's" in printed
    assert len(re.findall(r"^ +\d+  .*: no path$", printed, re.MULTILINE)) == 7
    assert "goal regions: no wrong answer" in printed
    decided, asked = map(int, re.findall(r"ends at angle 0: (\d+) of (\d+)", printed)[0])
    assert decided >= 0.9 * asked > 10


@pytest.mark.parametrize("lie", [True, False, None])
def test_a_wrong_answer_is_noticed(lie: bool | None, monkeypatch: pytest.MonkeyPatch) -> None:
    truth = is_joined
    monkeypatch.setattr(
        exact_fits, "is_joined", lambda scene, *places: lie if places else truth(scene)
    )
    with pytest.raises(AssertionError):
        for seed in range(40):
            exact_fits.attack_fixed(seed, 0.0)
    monkeypatch.undo()
    monkeypatch.setattr(exact_fits, "verdict_of", lambda scene, certified: lie)
    with pytest.raises(AssertionError, match="the oracle says"):
        for seed in range(40):
            exact_fits.attack_fixed(seed, 0.0)
