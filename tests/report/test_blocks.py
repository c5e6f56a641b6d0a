"""Blocks, numbers and figures inside a page."""

from __future__ import annotations

import json

import numpy as np
import pytest

from gearlash.report import numbers
from gearlash.report.blocks import (
    Badge,
    Bullets,
    Figure,
    Marked,
    Note,
    Page,
    Ref,
    Section,
    Strong,
    Table,
    Text,
)
from gearlash.report.data import as_json, plain_data
from gearlash.report.page import html, subscripts
from gearlash.report.svg import inline
from gearlash.system import GearlashError
from report.reading import Reading

EVIL = '<script>alert("x")</script> & <b>'
DRAWING = (
    b'<?xml version="1.0"?><!DOCTYPE svg PUBLIC "a" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">\n'
    b'<svg xmlns:xlink="http://www.w3.org/1999/xlink" width="255.118pt" height="9pt" viewBox="0 0 255 9" '
    b'xmlns="http://www.w3.org/2000/svg"><metadata>x</metadata><!-- c --><defs><path id="m1"/></defs>'
    b'<g clip-path="url(#p1)"><use xlink:href="#m1"/></g><clipPath id="p1"/></svg>'
)


def page(*blocks: object) -> Page:
    return Page("Title", "subtitle", (Section("one", "One", tuple(blocks)),))  # pyright: ignore[reportArgumentType]


def test_every_text_is_escaped_wherever_it_stands() -> None:
    made = Page(
        EVIL,
        EVIL,
        (
            Section(
                "one",
                EVIL,
                (
                    Text.of(EVIL, Strong(EVIL), Marked(EVIL), Badge(EVIL)),
                    Bullets((Text.of(EVIL),)),
                    Note(Text.of(EVIL), EVIL),
                    Table("t", EVIL, (EVIL,), ((EVIL,), ([EVIL, (EVIL, Badge(EVIL))],)), widths=(100,)),
                    Figure("f", Text.of(EVIL), EVIL, "drawing"),
                ),
                badge=Badge(EVIL),
            ),
        ),
        EVIL,
    )
    text = html(made, {"drawing": DRAWING})
    seen = Reading(text)
    assert "<script" not in text
    assert '<b>"' not in text
    assert "script" not in seen.tags
    assert seen.problems == []
    assert seen.text.count("alert") == 21, "escaped, not dropped"
    assert EVIL in seen.values("aria-label")


def test_figures_tables_and_sections_are_numbered_and_referred_to() -> None:
    table = Table("t", "Caption.", ("a",), (("1",),))
    made = page(
        Text.of("see ", Ref("t"), ", ", Ref("f"), ", ", Ref("one")),
        table,
        Figure("f", Text.of("C"), "w", "drawing"),
    )
    seen = Reading(html(made, {"drawing": DRAWING}))
    assert "see Table 1, Figure 1, Section 1" in seen.text
    assert {"#t", "#f", "#one"} <= set(seen.values("href"))
    assert {"t", "f", "one"} <= set(seen.values("id"))


def test_an_id_used_twice_is_refused() -> None:
    table = Table("t", "Caption.", ("a",), ())
    with pytest.raises(GearlashError, match="'t'"):
        page(table, table)


def test_a_badge_has_a_sign_and_a_word_of_its_own() -> None:
    kinds = ("good", "fair", "bad", "doubt", "plain")
    assert len({Badge("x", kind).sign for kind in kinds}) == len(kinds)
    seen = Reading(html(page(Text.of(Badge("not found", "bad"))), {}))
    assert "✗ not found" in seen.text


def test_numeric_cells_are_marked_and_lines_kept_apart() -> None:
    made = page(Table("t", "C", ("a", "b"), (("x", "1.5"), (["p", "q"], "2")), frozenset({1})))
    text = html(made, {})
    assert text.count('class="number"') == 3
    assert "<div>p</div><div>q</div>" in text


def test_indices_are_set_low_but_paths_are_not() -> None:
    assert subscripts("√(c_γ/m_red)") == "√(c<sub>γ</sub>/m<sub>red</sub>)"
    assert subscripts("F on σ_d, k_m D_c") == "F on σ<sub>d</sub>, k<sub>m</sub> D<sub>c</sub>"
    for path in ("gear.face_width", "derived.c_t", "back_gap", "natural_frequency_1"):
        assert subscripts(path) == path


def test_a_drawing_gets_ids_of_its_own_and_loses_its_prolog() -> None:
    text = inline(DRAWING, "figure-1", 'words "quoted" <here>')
    assert text.startswith("<svg ")
    assert 'id="figure-1-m1"' in text
    assert 'xlink:href="#figure-1-m1"' in text
    assert "url(#figure-1-p1)" in text
    assert "metadata" not in text
    assert "DTD" not in text
    assert "words &#34;quoted&#34; &lt;here&gt;" in text
    assert 'style="width: 50%"' in text, "90 mm wide on a page of 180 mm"


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (numbers.number(1.112006078, 5), "1.112"),
        (numbers.number(-0.00668), "−0.00668"),
        (numbers.number(3.2e8, 3), "3.2 × 10⁸"),
        (numbers.number(float("nan")), "—"),
        (numbers.number(float("-inf")), "−∞"),
        (numbers.percent(0.010484), "+1.05 %"),
        (numbers.percent(float("nan")), "—"),
        (numbers.scientific(1.24e-14), "1.2 × 10⁻¹⁴"),
        (numbers.scientific(0.0), "0"),
        (numbers.uncertainty(3e-17), "± less than 10⁻¹²"),
        (numbers.uncertainty(2e-5), "± 2.0 × 10⁻⁵"),
        (numbers.complex_number(-0.7714 + 0j), "−0.7714"),
        (numbers.complex_number(0.6 - 0.8j, 2), "0.60 − 0.80 i (modulus 1.00)"),
        (numbers.complex_number(complex("nan")), "—"),
        (numbers.interval(0.5, float("nan")), "—"),
    ],
)
def test_numbers_read_well(made: str, said: str) -> None:
    assert made == said


def test_what_is_no_number_is_null_in_json() -> None:
    made = plain_data(
        {"a": np.array([1.0, np.nan, np.inf]), "b": 1 - 2j, "c": (True, None, "x"), "d": np.int64(3)}
    )
    assert made == {"a": [1.0, None, None], "b": {"re": 1.0, "im": -2.0}, "c": [True, None, "x"], "d": 3}
    assert json.loads(json.dumps(made, allow_nan=False)) == made


def test_json_refuses_what_it_does_not_know() -> None:
    with pytest.raises(GearlashError, match="object"):
        as_json({"a": object()})
