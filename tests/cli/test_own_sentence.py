"""The sentence of `run` for systems that need not have teeth."""

from __future__ import annotations

import pytest

from cli.conftest import Gearlash


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("shaw-holmes",), "ω = 0.8: 1-1, stop met on side + once per cycle"),
        (("shaw-holmes", "--set", "gap=5"), "ω = 0.8: 1-0, stop never in contact"),
        (
            ("geared-rotor",),
            "ω = 0.5: 1-0-0/0-0/0-0, mesh always in contact on side +; bearing-1 always in contact on side "
            "-; bearing-2 always in contact on side +",
        ),
        (
            ("geared-rotor", "--set", "load=-0.1"),
            "ω = 0.5: 1-0-0/0-0/0-0, mesh always in contact on side -; bearing-1 always in contact on side "
            "+; bearing-2 always in contact on side -",
        ),
    ],
)
def test_contacts_are_told_by_name_and_side(gearlash: Gearlash, arguments: tuple[str, ...], sentence: str):
    assert gearlash("run", *arguments, "--json").answer["sentence"].startswith(f"{sentence}; ")
