"""A bar that comes late: not for what is soon done, and then with what was done so far."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from gearlash.cli import late, progress
from gearlash.jobs import Progress
from gearlash.studies.impact_free import SPEEDS, impact_free_speeds


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, Progress | None] | str]:
    """What a bar was told, and that it went."""
    told: list[tuple[str, Progress | None] | str] = []

    @contextmanager
    def bar() -> Iterator[progress.StageCallback]:
        yield lambda stage, done: told.append((stage, done))
        told.append("gone")

    monkeypatch.setattr(progress, "stage_bar", bar)
    return told


def test_nothing_is_shown_of_what_is_soon_done(shown: list):
    with late.late_bar("short") as tell:
        tell(1, 2)
        tell(2, 2)
    assert shown == []


def test_what_takes_long_is_shown_until_it_ends(shown: list, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(late, "PATIENCE", -1.0)
    with late.late_bar("long") as tell:
        tell(1, 2)
        tell(2, 2)
    *told, end = shown
    assert [(stage, done.done, done.total, done.remaining) for stage, done in told] == [
        ("long", 1, 2, None),
        ("long", 2, 2, None),
    ]
    assert end == "gone"


def test_nothing_is_foretold_of_steps_that_grow(
    shown: list, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setattr(late, "PATIENCE", -1.0)
    monkeypatch.setattr(late, "LONG", -1.0)
    for steady, said in ((False, False), (True, True)):
        with late.late_bar("walk", steady=steady) as tell:
            tell(1, 1000)
        assert ("about" in capsys.readouterr().err) == said


def test_a_search_tells_how_far_it_is():
    from gearlash.case import load

    family = load("article-first-harmonic").family()[0]
    told: list[tuple[int, int]] = []
    impact_free_speeds(family, family.complete({"omega": 1.03}), tell=lambda *far: told.append(far))
    assert [done for done, _ in told] == list(range(1, len(told) + 1))
    assert {total for _, total in told} == {SPEEDS}
    assert len(told) > 5
