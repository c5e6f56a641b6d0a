"""Words of the plain sentence."""

from __future__ import annotations

import pytest

from cli.conftest import Gearlash
from gearlash.cli.answers.sentence import rate

RATES = {
    (1, 1): "once per mesh cycle",
    (2, 1): "twice per mesh cycle",
    (6, 6): "once per mesh cycle",
    (1, 6): "once in 6 mesh cycles",
    (3, 2): "3 times in 2 mesh cycles",
    (150, 200): "0.75 times per mesh cycle on average",
}


@pytest.mark.parametrize(("counts", "words"), RATES.items())
def test_rates(counts: tuple[int, int], words: str):
    assert rate(*counts) == words


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        (["omega=1.05"], "4011 rpm: 1-0, teeth stay in contact; impact-free from 3715 rpm to 4247 rpm"),
        (
            ["omega=0.78", "D=0.384"],
            "2980 rpm: 6-6-1, teeth hit the drive side once per mesh cycle and the back side once in 6 mesh "
            "cycles; nearest impact-free speed 3715 rpm †",
        ),
    ],
)
def test_whole_sentences(settings: list[str], sentence: str, gearlash: Gearlash):
    options = [part for setting in settings for part in ("--set", setting)]
    assert gearlash("run", "article", *options, "--json").answer["sentence"] == sentence
