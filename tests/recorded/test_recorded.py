"""What commands answered before the house was rebuilt, they answer today.

The quick commands run here. `python -m recorded.compare` (in `tests`) runs all, to the last digit; here
numbers may differ by `WITHIN`, since the recording was made on another machine.
"""

from __future__ import annotations

import copy
from typing import Any

import pytest

from .commands import COMMANDS, Recorded
from .compare import differences
from .record import kept, record

WITHIN = 1e-8


@pytest.mark.parametrize(
    "command", [command for command in COMMANDS if command.quick], ids=lambda command: command.name
)
def test_a_command_answers_what_was_recorded(command: Recorded) -> None:
    assert not list(differences(kept(command.name), record(command), loose=WITHIN))


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_every_command_has_a_recording_with_an_answer(command: Recorded) -> None:
    content = kept(command.name)
    assert content["answer"]
    assert bool(content["arrays"]) == (command.result in {"sweep", "map", "zones", "reproduce"})


def test_one_changed_digit_label_or_missing_field_is_told() -> None:
    old = kept("sweep-soft-stop")
    for change, told in ((_digit, "/answer"), (_label, "/answer"), (_field, "missing")):
        new = copy.deepcopy(old)
        change(new)
        found = list(differences(old, new))
        assert len(found) == 1
        assert told in found[0]


def _digit(content: dict[str, Any]) -> None:
    content["answer"]["sweeps"][0]["points"][0]["minimum"] += 1e-12


def _label(content: dict[str, Any]) -> None:
    content["answer"]["sweeps"][0]["points"][3]["label"] = "1-1-0"


def _field(content: dict[str, Any]) -> None:
    del content["answer"]["sweeps"][0]["points"][5]["status"]
