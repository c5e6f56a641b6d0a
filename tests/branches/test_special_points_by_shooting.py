"""Special points of branches, solved for again by oracles that share nothing with the package: shooting in 80
bit on another integrator, and a bilinear oscillator in closed form."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

import numpy as np
import pytest

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")

import gearlash as gl
from branches.followed import PLAIN, bundled, linear, parametric, random_pair, window
from branches.shaken import shaken
from gearlash.branches.continuation import Branch, SpecialKind, continue_orbit
from gearlash.system import ContactRule, Family
from oracles import region_oracle
from oracles.bilinear import Bilinear, multiplier_at, touching_values
from oracles.shooting import Returns, closed
from oracles.special_points import HALVED, again, point_again
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import article, one_dof, orbit

Followed = tuple[Family, Branch]


def followed(family: Family, values: Mapping[str, float], name: str, lower: float, upper: float) -> Followed:
    start = orbit(family, **values)
    return family, continue_orbit(family, family.complete(values), name, start, lower, upper, PLAIN)


@cache
def pair(seed: int, rule: ContactRule) -> Followed:
    """`random_pair`, and the family it is of."""
    branch = random_pair(seed, rule)
    return one_dof_under(rule, **branch.values), branch


@cache
def case_of(name: str) -> Followed:
    return CASES[name]()


CASES: dict[str, Callable[[], Followed]] = {
    "one degree of freedom": lambda: (one_dof(error=0.05), linear()),
    "parametric resonance": lambda: (one_dof(error=0.0005, ripple=0.3), parametric()),
    "in contact": lambda: pair(5, ContactRule.IN_CONTACT),
    "no tension": lambda: pair(19, ContactRule.NO_TENSION),
    "back side loaded": lambda: followed(
        one_dof_under(ContactRule.IN_CONTACT, load=-0.1, error=0.05), {"omega": 1.45}, "omega", 0.5, 1.6
    ),
    "back side loaded, no tension": lambda: followed(
        one_dof_under(ContactRule.NO_TENSION, load=-0.1, error=0.05), {"omega": 1.45}, "omega", 1.3, 1.5
    ),
    "soft stop": lambda: followed(shaken(), {"omega": 0.79}, "omega", 0.79, 0.81),
    "two gaps": lambda: followed(two_gaps(ContactRule.IN_CONTACT), {"omega": 0.9}, "omega", 0.9, 1.0),
    "two gaps, no tension": lambda: followed(
        two_gaps(ContactRule.NO_TENSION), {"omega": 0.9}, "gap", 0.3, 0.4
    ),
    "article": lambda: (bundled(), window()),
    "article, first harmonic, low": lambda: followed(article(), {"omega": 0.73}, "omega", 0.73, 0.75),
    "article, first harmonic, high": lambda: followed(article(), {"omega": 0.93}, "omega", 0.91, 0.93),
    "symmetric": lambda: followed(
        one_dof(load=0.0, error=1.0, D=0.2, mesh_damping=0.02), {"omega": 1.15}, "omega", 0.44, 1.2
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_every_special_point_is_one_of_the_oracle(name):
    family, branch = case_of(name)
    assert branch.special
    for special in branch.special:
        theirs = again(family, branch, special)
        scale = branch.upper - branch.lower
        assert theirs.found.defect < 1e-13
        assert theirs.value_apart < max(2e-13, special.error / scale)
        assert theirs.state_apart < (1e-2 if special.kind in HALVED else 1e-12)


@pytest.mark.parametrize("name", CASES)
def test_contacts_and_multipliers_between_them(name):
    family, branch = case_of(name)
    for index in np.linspace(0, len(branch.points) - 1, 4).astype(int):
        checked = point_again(family, branch, int(index))
        assert checked.contacts == ""
        assert checked.state_apart < 1e-11
        assert checked.multipliers_apart < 1e-7


@pytest.mark.parametrize(
    ("name", "value"),
    [("article, first harmonic, low", 0.743), ("article, first harmonic, high", 0.9158)],
)
def test_torus_of_the_article_with_its_old_values(name, value):
    """The angle of the pair, too, is the oracle's; no strong resonance lies there."""
    family, branch = case_of(name)
    (torus,) = branch.of_kind(SpecialKind.TORUS)
    assert torus.value == pytest.approx(value, abs=1e-4)
    pair = [m for m in torus.point.multipliers if abs(abs(m) - 1.0) < 1e-9]
    theirs = [m for m in again(family, branch, torus).found.multipliers if abs(abs(m) - 1.0) < 1e-9]
    assert len(pair) == len(theirs) == 2
    angle = float(np.abs(np.angle(pair[0])))
    assert angle == pytest.approx(float(np.abs(np.angle(theirs[0]))), abs=1e-9)
    assert min(abs(angle - 2.0 * np.pi / n) for n in (1, 2, 3, 4)) > 1e-2


def test_physical_names_and_units_lead_to_the_same_point():
    case = gl.load_case("article")
    branch = gl.continue_branch(
        case, "pinion_speed", lower="3700 rpm", upper="3760 rpm", values={"pinion_speed": "3740 rpm"},
        steps=PLAIN,
    )  # fmt: skip
    (touch,) = branch.of_kind("grazing")
    assert again(bundled(), branch, touch).value_apart < 1e-12


@pytest.mark.parametrize("damping", [0.03, 0.05])
@pytest.mark.parametrize("rule", [ContactRule.ALWAYS, ContactRule.IN_CONTACT])
def test_folds_and_touches_of_a_bilinear_oscillator_in_closed_form(rule, damping):
    """The pair with constant stiffness, which reaches one boundary only."""
    load, error, width = 0.1, 1.2 * damping, 2.0 * damping
    family = one_dof_under(rule, load=load, error=error, mesh_damping=damping, D=5.0)
    _, branch = followed(family, {"omega": 1.5}, "omega", 0.5, 1.6)

    def model(omega) -> Bilinear:
        inside = 0.0 if rule is ContactRule.ALWAYS else width  # beyond the gap both have it
        return Bilinear(omega, 5.0, 0.0, 1.0, width - inside, width, load, error * omega**2)

    for touch in branch.of_kind("grazing"):
        expected = touching_values(model, round(touch.value, 4), beyond=True)
        assert touch.value == pytest.approx(float(expected), rel=1e-13)
    for fold in branch.of_kind("fold"):
        expected, _ = multiplier_at(model, 1, _guess(family, branch, fold))
        assert fold.value == pytest.approx(float(expected), rel=1e-12)
    assert len(branch.of_kind("fold")) == 2


def test_the_doubling_of_a_soft_stop_in_closed_form():
    family, branch = case_of("soft stop")
    values = branch.values

    def model(omega) -> Bilinear:
        c = 2.0 * values["zeta"]
        return Bilinear(omega, values["gap"], 1.0, values["beta"], c, c, 0.0, values["a"] * omega**2)

    touch, doubling = branch.special
    assert touch.value == pytest.approx(float(touching_values(model, 0.802, beyond=False)), rel=1e-13)
    expected, _ = multiplier_at(model, -1, _guess(family, branch, doubling))
    assert doubling.value == pytest.approx(float(expected), rel=1e-12)


def _guess(family: Family, branch: Branch, special) -> tuple:
    """Six digits of where the orbit enters and leaves contact."""
    system = family.system({**branch.values, branch.name: special.value})
    events = region_oracle.run(system, special.point.state, 1).events
    (enter,) = (e for e in events if e.engaging)
    (leave,) = (e for e in events if not e.engaging)
    period = 2.0 * np.pi / special.value
    rough = (
        special.value,
        float(enter.phase) * period,
        float(leave.phase - enter.phase) % 1.0 * period,
        float(enter.velocity),
        float(leave.velocity),
    )
    return tuple(float(f"{value:.6g}") for value in rough)


@pytest.mark.parametrize("name", ["in contact", "no tension", "back side loaded", "two gaps"])
def test_the_square_root_law_by_multipliers_of_the_oracle(name):
    """c from orbits at two depths beyond the touch; on the other side the multipliers do not move."""
    family, branch = case_of(name)
    for touch in branch.of_kind(SpecialKind.GRAZING):
        assert touch.extremum is not None
        if name == "no tension" and touch.extremum.surface == "gap":
            continue  # there the map has a corner, and no such law holds
        law = gl.grazing_law(family, branch, touch)
        deeper = -np.sign(touch.extremum.a0 * law.rate)  # way of the parameter into the excursion
        slopes = {
            side: [_slope(family, branch, touch, law, side * depth) for depth in DEPTHS] for side in (1, -1)
        }
        beyond, before = (2.0 * fine - coarse for coarse, fine in (slopes[deeper], slopes[-deeper]))
        size = float(np.abs(law.coefficients).max())
        assert np.abs(beyond - law.coefficients).max() < 1e-4 * max(size, 1.0)
        assert np.abs(before).max() < 1e-6 * max(size, 1.0)


DEPTHS = 4e-9, 1e-9


def _slope(family: Family, branch: Branch, touch, law: gl.GrazingLaw, signed: float) -> np.ndarray:
    """(λ - λ0)/√d of every multiplier where the extremum has moved by d."""

    def build(value: float):
        return family.system({**branch.values, branch.name: value})

    returns = Returns(build, float(len(touch.point.strobes)))
    found = closed(returns, touch.point.state, touch.value + signed / abs(law.rate))
    theirs = list(found.multipliers)
    paired = [theirs.pop(int(np.argmin(np.abs(np.array(theirs) - each)))) for each in law.multipliers]
    return (np.array(paired) - law.multipliers) / np.sqrt(abs(law.rate * (found.value - touch.value)))
