"""The documented schemas, and the validator that other tests hold answers against."""

from __future__ import annotations

import subprocess
import sys

import pytest

from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.kinds import ANSWER_KINDS, answer_kind
from gearlash.cli.schemas import answer_schema


def test_the_validator_can_refuse():
    schema = answer_schema(answer_kind("problem"))
    good = {"message": "", "problems": [], "result": "problem"}
    assert problems(good, schema) == []
    assert problems({**good, "result": "run"}, schema)
    assert problems({**good, "more": 1}, schema)
    assert problems({"message": "", "result": "problem"}, schema)
    row = {"path": "a", "value": None, "expected": "b", "nearest": None}
    assert problems({**good, "problems": [row]}, schema) == []
    assert problems({**good, "problems": [{**row, "nearest": 3}]}, schema)


@pytest.mark.parametrize("kind", ANSWER_KINDS)
def test_every_kind_has_a_schema_whose_pointers_lead_somewhere(kind: str, gearlash: Gearlash):
    schema = gearlash("schema", "--result", kind).answer
    assert schema["properties"]["result"]["enum"] == [kind]
    assert problems({"result": kind}, schema)  # something is required

    def pointers(part: object) -> set[str]:
        if isinstance(part, dict):
            own = {str(part["$ref"])} if "$ref" in part else set()
            return own.union(*(pointers(item) for item in part.values()))
        return set().union(*(pointers(item) for item in part)) if isinstance(part, list) else set()

    assert {pointer.removeprefix("#/$defs/") for pointer in pointers(schema)} == set(schema["$defs"])


def test_case_schema_is_that_of_the_case_room(gearlash: Gearlash):
    schema = gearlash("schema").answer
    assert set(schema["discriminator"]["mapping"]) == {"helical-pair", "spur-1dof", "piecewise-linear"}


def test_unknown_kind_names_the_nearest(gearlash: Gearlash):
    ran = gearlash("schema", "--result", "grace")
    assert ran.code == 2
    assert "did you mean 'graze'" in ran.err
    assert ran.out == ""


def test_schemas_do_without_the_engine():
    script = (
        "import sys\n"
        "from gearlash.cli.kinds import ANSWER_KINDS, answer_kind\n"
        "from gearlash.cli.schemas import answer_schema\n"
        "[answer_schema(answer_kind(kind)) for kind in ANSWER_KINDS]; print('numba' in sys.modules)"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "False"
