"""Breaking a bound, a remainder, a direction or a switch of the flow is noticed.

Each mutant (`oracles.mutants`) is a copy of the package with one text replaced, and fails the fact
(`oracles.flow_facts`) it is listed with; the copy without a replacement has them all.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from oracles.flow_facts import FACTS
from oracles.mutants import MUTANTS, Mutant, Verdict, ask, copied, places

WORKERS = 2


def test_every_text_occurs_once_and_every_fact_is_needed():
    assert {mutant.name: len(places(mutant.old)) for mutant in MUTANTS} == {m.name: 1 for m in MUTANTS}
    assert {mutant.fact for mutant in MUTANTS} == set(FACTS)


@pytest.mark.slow
def test_no_mutant_survives(tmp_path: Path):
    """A fact must fail because of what the mutant does, not because it cannot be imported."""

    def fate(number: int, mutant: Mutant | None) -> Verdict:
        facts = FACTS if mutant is None else (mutant.fact,)
        return ask(copied(tmp_path / str(number), mutant), *facts)

    with ThreadPoolExecutor(WORKERS) as pool:
        sound, *verdicts = pool.map(fate, range(1 + len(MUTANTS)), (None, *MUTANTS))
    assert sound.held, sound.told
    told = {mutant.name: v.told for mutant, v in zip(MUTANTS, verdicts, strict=True) if not v.asked}
    assert not told, "these never came to be asked"
    survivors = [mutant.name for mutant, v in zip(MUTANTS, verdicts, strict=True) if v.held]
    assert not survivors
