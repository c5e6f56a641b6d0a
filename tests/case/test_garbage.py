"""Whatever comes in, the loader either takes it or says what is wrong: never any other error.

`GEARLASH_GARBAGE=50` tries fifty times as many examples.
"""

from __future__ import annotations

import datetime
import os
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from case.corpus import BAD_FILES, HELICAL, SPUR
from gearlash.case import Case, CaseError, bundled, load, loads
from gearlash.case.kinds import kind_named, kinds
from gearlash.case.loading import from_tables
from gearlash.case.read import source_text
from gearlash.cli.inputs import read_case, read_near, read_over, read_start
from gearlash.system import GearlashError

TIMES = int(os.environ.get("GEARLASH_GARBAGE", "1"))
PIECEWISE = "piecewise-linear"
PATHS = sorted({path for kind in kinds() for path in kind_named(kind).places})
BUNDLED = {name: load(name).kind for name in bundled()}
GEAR_TEXTS = [source_text(name)[1] for name, kind in BUNDLED.items() if kind != PIECEWISE] + [HELICAL, SPUR]
PIECEWISE_TEXTS = [source_text(name)[1] for name, kind in BUNDLED.items() if kind == PIECEWISE]
TEXTS = GEAR_TEXTS + PIECEWISE_TEXTS
ARTICLE = load("article")


def examples(count: int) -> settings:
    return settings(
        max_examples=count * TIMES,
        suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
    )


def taken_or_refused(load_it: Any, *arguments: Any) -> None:
    """Either outcome is right; a refusal must say why, and what is taken must be usable."""
    try:
        found = load_it(*arguments)
    except CaseError as error:
        assert error.problems  # noqa: PT017
        assert all(p.expected for p in error.problems)  # noqa: PT017
        assert str(error)  # noqa: PT017
    except GearlashError as error:
        assert str(error)  # noqa: PT017
    else:
        if isinstance(found, Case):
            assert found.family()[0].start().size
            assert Case.from_json(found.to_json()).hash == found.hash
            found.values()
            found.notes()


words = st.sampled_from(
    [
        "4 mm",
        "3 kg",
        "0.1",
        "1e8 N/m",
        "20 deg",
        "100 rpm",
        "nan mm",
        "base",
        "1e308 N/m",
        "1e-308 kg",
        "-0 mm",
        "-2*omega",
        "1/0",
        "sqrt(-pi)",
    ]
)
junk = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=12)
    | st.dates()
    | words
    | st.sampled_from([0.5, 12, 10**400])
    | st.just(datetime.time(1, 2)),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["value", "provenance", "reason", "x"]), inner, max_size=3)
    ),
    max_leaves=6,
)


@examples(150)
@given(
    st.sampled_from([*kinds(), "spur", 3]),
    st.dictionaries(st.sampled_from([*PATHS, "mesh.x", "foo.bar", "source.doi"]), junk, max_size=12),
    st.dictionaries(
        st.sampled_from([*PATHS, "D", "omega", "mass", "", "."]) | st.text(max_size=6), junk, max_size=3
    ),
)
def test_garbage_in_the_right_places(kind: object, values: dict[str, Any], overrides: dict[str, Any]):
    raw: dict[str, Any] = {"kind": kind}
    for path, value in values.items():
        table, leaf = path.split(".")
        raw.setdefault(table, {})[leaf] = value
    taken_or_refused(from_tables, raw, overrides)


@examples(200)
@given(st.text(max_size=200))
def test_any_text_at_all(text: str):
    with pytest.raises(CaseError):
        loads(text)


@examples(100)
@given(st.binary(max_size=300))
def test_any_bytes_at_all(tmp_path: Path, content: bytes):
    path = tmp_path / "case.toml"
    path.write_bytes(content)
    with pytest.raises(CaseError):
        load(path)


keys = st.sampled_from([path.rpartition(".")[2] for path in PATHS]) | st.text("ab.\"' -é", max_size=4)
scalars = st.sampled_from(
    [
        "1",
        "-1.5",
        "nan",
        "inf",
        "true",
        '"4 mm"',
        "'x'",
        '"""\na"""',
        "[1, 2]",
        "{value = 1}",
        "1979-05-27",
        "[",
        "0x",
        '"',
    ],
)
lines = st.one_of(
    st.builds("{} = {}".format, keys, scalars),
    st.builds("[{}]".format, st.sampled_from(["mesh", "pinion", "dimensionless", "source", "x"]) | keys),
    st.builds("[[{}]]".format, st.just("clearance") | keys),
    st.builds("{}.{} = {}".format, keys, keys, scalars),
    st.sampled_from([*(f'kind = "{kind}"' for kind in kinds()), "# x", ""]),
    st.text(max_size=8),
)


@examples(200)
@given(st.lists(lines, max_size=12))
def test_text_that_looks_like_a_case(rows: list[str]):
    taken_or_refused(loads, "\n".join(rows))


@examples(200)
@given(st.data())
def test_a_right_file_with_letters_damaged(data: st.DataObject):
    text = data.draw(st.sampled_from(TEXTS))
    start = data.draw(st.integers(0, len(text) - 1))
    length = data.draw(st.integers(0, 12))
    taken_or_refused(loads, text[:start] + data.draw(st.text(max_size=6)) + text[start + length :])


@examples(100)
@given(st.data())
def test_a_right_file_with_lines_lost_doubled_or_exchanged(data: st.DataObject):
    rows = data.draw(st.sampled_from(TEXTS)).splitlines()
    for _ in range(data.draw(st.integers(1, 4))):
        i = data.draw(st.integers(0, len(rows) - 1))
        j = data.draw(st.integers(0, len(rows) - 1))
        match data.draw(st.sampled_from(["lost", "doubled", "exchanged"])):
            case "lost":
                rows[i] = ""
            case "doubled":
                rows.insert(j, rows[i])
            case _:
                rows[i], rows[j] = rows[j], rows[i]
    taken_or_refused(loads, "\n".join(rows))


def tables_in(part: Any) -> list[dict[str, Any]]:
    """Every table that holds something, however deep: in arrays too, such as [[clearance]]."""
    inner = part.values() if isinstance(part, dict) else part if isinstance(part, list) else ()
    found = [table for one in inner for table in tables_in(one)]
    return [part, *found] if isinstance(part, dict) and part else found


def disturbed(data: st.DataObject, text: str) -> dict[str, Any]:
    """The tables of a file with one to four values or whole tables replaced, lost or moved."""
    raw = tomllib.loads(text)
    for _ in range(data.draw(st.integers(1, 4))):
        tables = tables_in(raw)
        if not tables:
            break
        table = data.draw(st.sampled_from(tables))
        leaf = data.draw(st.sampled_from(sorted(table)))
        match data.draw(st.sampled_from(["replaced", "lost", "moved"])):
            case "replaced":
                table[leaf] = data.draw(junk)
            case "lost":
                del table[leaf]
            case _:
                data.draw(st.sampled_from(tables))[leaf] = table.pop(leaf)
    return raw


@pytest.mark.parametrize("texts", [GEAR_TEXTS, PIECEWISE_TEXTS], ids=["gears", "piecewise-linear"])
@examples(250)
@given(data=st.data())
def test_a_right_file_with_values_replaced_lost_or_moved(texts: list[str], data: st.DataObject):
    taken_or_refused(from_tables, disturbed(data, data.draw(st.sampled_from(texts))))


names = st.sampled_from(["omega", "D", "pinion_speed", "mesh.backlash", "load", "contact", "teeth", "kind"])
numbers = st.sampled_from(
    ["0.5", "1e999", "-1", "nan", "3600rpm", "80 um", "80 µm", "0x1", "", " ", "1e-400", "१"]
)
typed = st.one_of(
    st.text(max_size=20),
    st.builds("{}={}".format, names, numbers | st.text(max_size=8)),
    st.builds(
        "{}={}:{}:{}".format, names, numbers, numbers, st.sampled_from(["9", "-1", "2e3", "²", "9" * 30, ""])
    ),
)


@examples(200)
@given(st.lists(typed, max_size=3))
def test_whatever_is_typed_after_set(texts: list[str]):
    taken_or_refused(read_case, "article", texts)


@examples(200)
@given(typed, st.lists(typed, max_size=2))
def test_whatever_is_typed_after_over(text: str, texts: list[str]):
    taken_or_refused(read_over, ARTICLE, text, texts)
    name, _, value = text.partition("=")
    taken_or_refused(read_near, ARTICLE, name, value, texts)


@examples(200)
@given(st.lists(typed | st.builds("{}={}".format, st.sampled_from(["X", "X'", "Y_p"]), numbers), max_size=3))
def test_whatever_is_typed_after_initial(texts: list[str]):
    family, _ = ARTICLE.family()
    taken_or_refused(read_start, family, family.complete(), texts)


@examples(100)
@given(
    st.binary(max_size=60)
    | st.recursive(st.none() | st.floats() | st.text(max_size=5), st.lists).map(repr).map(str.encode)
)
def test_whatever_the_file_of_initial_holds(tmp_path: Path, content: bytes):
    path = tmp_path / "run.json"
    path.write_bytes(content)
    family, _ = ARTICLE.family()
    with pytest.raises(CaseError):
        read_start(family, family.complete(), [str(path)])


@examples(60)
@given(st.sampled_from(BAD_FILES), st.sampled_from(BAD_FILES))
def test_two_kinds_of_bad_input_in_one_file(first: Any, second: Any):
    if first.base == second.base and second.old in first.text:
        with pytest.raises(CaseError):
            loads(first.text.replace(second.old, second.new, 1))
