"""One of the values that a drawn case estimates together, stated by an override: the others stay."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl
from gearlash.case import loads

CASES = Path(__file__).resolve().parents[1] / "cases"
DRAWING = CASES / "drawing.toml"


def estimates(case: gl.Case) -> dict[str, float]:
    """Those with a range, in their units."""
    return {v.path: float(v.value) for v in case.values() if v.least is not None}


@pytest.fixture(scope="module")
def case() -> gl.Case:
    return gl.load_case(DRAWING)


@pytest.mark.parametrize("path", sorted(estimates(gl.load_case(DRAWING))))
def test_a_value_set_is_the_only_one_that_is_estimated_no_more(case: gl.Case, path: str):
    before = {v.path: v for v in case.values()}
    value, unit = before[path].value, before[path].unit
    after = estimates(case.with_overrides({path: f"{value!r} {unit}".strip()}))
    gone = set(estimates(case)) - set(after)
    assert gone == {path}
    rest = {name: number for name, number in estimates(case).items() if name != path}
    assert after == pytest.approx(rest, rel=1e-6)


@pytest.mark.parametrize("path", ["mesh.ripple_phase_2", "mesh.error_2", "mesh.error_phase"])
def test_what_is_no_estimate_with_a_range_drops_none(case: gl.Case, path: str):
    value = "1 um" if path == "mesh.error_2" else "30 deg"
    assert set(estimates(case)) - {path} <= set(estimates(case.with_overrides({path: value})))


def test_the_rest_stays_from_process_to_process_and_override_to_override(case: gl.Case):
    one = case.with_overrides({"ripple_2": 0.01})
    assert gl.Case.from_json(one.to_json()) == one
    assert gl.Case.from_json(one.to_json()).family()[0].defaults == one.family()[0].defaults
    assert one.hash != case.hash
    both = one.with_overrides({"ripple_3": 0.02, "error_2": "1 um"})
    kept = {f"mesh.ripple_{n}" for n in range(4, 9)} | {"mesh.ripple", "mesh.error"}
    assert kept <= set(estimates(both))
    turned = one.with_overrides({"torque": "-100 N m"})
    assert "mesh.ripple_3" in estimates(turned)


def test_a_file_that_states_harmonics_has_those():
    text = DRAWING.read_text(encoding="utf-8").replace("[mesh]", "[mesh]\nripple_2 = 0.01")
    found = loads(text, label="pair.toml")
    harmonics = [path for path in estimates(found) if path.startswith("mesh.ripple")]
    assert all("phase" in path for path in harmonics)


def test_a_sweep_over_one_harmonic_keeps_the_others(case: gl.Case):
    own = case.family()[0].defaults
    family = case.with_overrides({"ripple_3": 0.01}).family()[0]
    changed = {name for name, value in family.defaults.items() if value != own[name]}
    assert changed == {"ripple_3"}
    assert family.defaults.keys() == own.keys()
    at = family.system({"ripple_3": own["ripple_3"]}).clearances[0].stiffness_plus
    assert at == pytest.approx(case.family()[0].system().clearances[0].stiffness_plus, rel=1e-12)
