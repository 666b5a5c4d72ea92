"""Each reason has its sentence; undecided queries that can be helped have a hint."""

from __future__ import annotations

import pickle

import pytest

from planar_planner import DecidedBy, StopReason
from planar_planner.cli.report import HINTS
from planar_planner.planning.outcome import LEGS, MOVED, PATHS, PROOFS, STOPS, sentence

NO_REMEDY = {
    StopReason.INTERRUPTED,
    StopReason.MOVED_ENDS,
    StopReason.NO_DOUBLES,
    StopReason.NO_EVIDENCE,
    StopReason.LOST_CHANNEL,
}


def test_every_reason_has_a_sentence_of_its_own() -> None:
    assert set(STOPS) == set(StopReason)
    assert set(PATHS) | set(PROOFS) == set(DecidedBy)
    for sentences in (STOPS, PATHS, PROOFS):
        assert len(set(sentences.values())) == len(sentences)


def test_every_reason_that_a_user_can_help_has_a_hint() -> None:
    assert set(HINTS) == set(StopReason) - NO_REMEDY


def test_sentences() -> None:
    assert sentence("path", DecidedBy.CHANNEL) == "certified through a channel of cells"
    assert sentence("no_path", DecidedBy.DISC) == "a disc inside the robot has no path"
    assert sentence("undecided", None, StopReason.MAX_CELLS) == "cell limit reached"
    assert sentence("path", DecidedBy.RIDGE, ends_moved=True).endswith(MOVED)
    assert sentence("path", DecidedBy.RIDGE, exact_legs=True).endswith(LEGS)
    assert LEGS not in sentence("path", DecidedBy.JOINED_LAYERS, exact_legs=True)


@pytest.mark.parametrize(
    ("verdict", "decided_by"), [("path", DecidedBy.SEPARATION), ("no_path", None), ("path", None)]
)
def test_verdict_that_rests_on_nothing_is_a_defect(
    verdict: str, decided_by: DecidedBy | None
) -> None:
    with pytest.raises(ValueError, match=verdict):
        sentence(verdict, decided_by)


@pytest.mark.parametrize("kind", [StopReason, DecidedBy])
def test_members_are_words_that_pickle(kind: type[StopReason] | type[DecidedBy]) -> None:
    for member in kind:
        assert kind(str(member)) is member
        assert pickle.loads(pickle.dumps(member)) is member
