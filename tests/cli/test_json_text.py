"""The JSON that is written is what Python's own encoder writes."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.cli.jsonio import text


class Word(StrEnum):
    ONE = "one"


class Number(IntEnum):
    TWO = 2


@dataclass(frozen=True)
class Inner:
    value: Any


@dataclass(frozen=True)
class Nothing:
    """Has no fields."""


SCALARS = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(st.characters(max_codepoint=0x7E))
)
VALUES = st.recursive(SCALARS, lambda inner: st.lists(inner) | st.dictionaries(st.text('ab"\\\n '), inner))


@pytest.mark.parametrize("ascii_only", [False, True])
@given(value=VALUES)
def test_as_the_encoder_of_python(value: object, ascii_only: bool):
    assert text(value, ascii_only) == json.dumps(value, indent=2, ensure_ascii=ascii_only) + "\n"


def test_what_is_no_json_of_itself():
    answer = {
        "record": Inner(Inner((1, 2.5))), "empty": (Inner([]), {}, Nothing()),
        "enums": [Word.ONE, Number.TWO],
        "none": [math.nan, math.inf, np.float64("nan")], "arrays": np.array([[1.0, np.nan]]), 7: np.int64(7),
        "flag": np.bool_(True), "ä": "ω\x7f\u202e",
    }  # fmt: skip
    same = {
        "record": {"value": {"value": [1, 2.5]}}, "empty": [{"value": []}, {}, {}], "enums": ["one", 2],
        "none": [None, None, None], "arrays": [[1.0, None]], "7": 7, "flag": True, "ä": "ω\x7f\u202e",
    }  # fmt: skip
    written = text(answer)
    assert json.loads(written) == same
    assert written == json.dumps(same, indent=2, ensure_ascii=False).replace("\x7f", "\\u007f").replace(
        "\u202e", "\\u202e"
    ) + "\n"  # fmt: skip
    with pytest.raises(TypeError, match="complex has no place"):
        text([1j])
