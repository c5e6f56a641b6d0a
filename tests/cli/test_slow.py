"""What will take long is said beforehand."""

from __future__ import annotations

import re

import pytest

from cli.conftest import Gearlash
from gearlash.cli import slow


@pytest.mark.parametrize("over", [(), ("--over", "omega=0.05:0.8:2")])
def test_a_slow_system_is_told_before_it_is_computed(
    over: tuple[str, ...], gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(slow, "MANY", 1e6)
    command = ("sweep", *over) if over else ("run", "--set", "omega=0.05")
    ran = gearlash(command[0], "kahraman-singh", *command[1:])
    assert re.match(
        r"slow: \d\d cells a period, \d MB of tables \(omega = 0.05 is slow beside the rate 1.0\d+, "
        r"which stiffness = 1 of side [+] of 'mesh' makes\)",
        ran.complaint,
    )


def test_what_is_not_slow_is_not_told(gearlash: Gearlash):
    assert gearlash("run", "kahraman-singh").err == ""
