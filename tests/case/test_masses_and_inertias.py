"""Mass and inertia of drawn bodies: rings by hand, and a mass that leaves the inertia as it is."""

from __future__ import annotations

from math import pi
from typing import Any

import pytest

import gearlash as gl
from gearlash.case import Case, loads
from gearlash.gears.materials import named

SPUR = """
kind = "spur-1dof"
[pinion]
teeth = 30
quality = 6
{pinion}
[gear]
teeth = 61
{gear}
[mesh]
module = "4 mm"
pressure_angle = "20 deg"
face_width = "40 mm"
[operation]
pinion_speed = "4000 rpm"
torque = "250 N m"
"""
BODIES = [
    ("", ""),
    ('bore = "45 mm"', 'bore = "60 mm"'),
    ('bore = "45 mm"', 'bore = "60 mm"\nrim_diameter = "200 mm"\nweb_width = "12 mm"'),
]


def text(kind: str, pinion: str, gear: str) -> str:
    plain = SPUR.format(pinion=pinion, gear=gear)
    if kind == "spur-1dof":
        return plain
    return plain.replace("spur-1dof", kind).replace("[mesh]", '[mesh]\nhelix_angle = "12 deg"')


def values(case: Case) -> dict[str, Any]:
    return {v.path: v for v in case.values()}


def ring(inner: float, outer: float, width: float) -> tuple[float, float]:
    """Mass and inertia of a ring of steel."""
    mass = named("steel").density * pi / 4 * (outer**2 - inner**2) * width
    return mass, mass / 8 * (outer**2 + inner**2)


def by_hand() -> tuple[float, float]:
    """The webbed gear: a rim from 200 mm to d_m = z m − 0.25 m (ISO 53 A), a web of 12 mm down to 60 mm."""
    rim, web = ring(0.2, 61 * 4e-3 - 0.25 * 4e-3, 0.04), ring(0.06, 0.2, 0.012)
    return rim[0] + web[0], rim[1] + web[1]


def test_a_webbed_gear_has_the_mass_and_inertia_of_its_rings():
    found, hand = values(loads(text("spur-1dof", *BODIES[2]))), by_hand()
    assert (found["gear.mass"].value, found["gear.inertia"].value) == pytest.approx(hand, rel=1e-12)


@pytest.mark.parametrize("kind", ["spur-1dof", "helical-pair"])
@pytest.mark.parametrize("bodies", BODIES)
@pytest.mark.parametrize("factor", [1.0, 0.7, 1.02])
def test_a_mass_leaves_the_inertia_of_the_drawn_body(kind: str, bodies: tuple[str, str], factor: float):
    """Stated, set and varied, with whatever body: nothing but the mass is another one."""
    case = loads(text(kind, *bodies))
    plain = values(case)
    mass = factor * plain["gear.mass"].value
    stated = loads(text(kind, bodies[0], f'{bodies[1]}\nmass = "{mass!r} kg"'))
    for found in (values(stated), values(case.with_overrides({"gear.mass": f"{mass!r} kg"}))):
        assert found["gear.mass"].value == pytest.approx(mass, rel=1e-12)
        for path in ("pinion.inertia", "gear.inertia", "derived.equivalent_mass"):
            assert found[path].value == plain[path].value, path
            assert (found[path].least, found[path].greatest) == (plain[path].least, plain[path].greatest)
    weights = [n for n in case.with_overrides({"gear.mass": f"{mass!r} kg"}).notes() if n.path == "gear.mass"]
    assert bool(weights) == (not plain["gear.mass"].least <= mass <= plain["gear.mass"].greatest)


@pytest.mark.parametrize("bodies", BODIES)
def test_a_mass_that_varies_has_no_part_in_a_pair_that_only_turns(bodies: tuple[str, str]):
    family, _ = loads(text("spur-1dof", *bodies)).varying("pinion.mass").family()
    own = family.system()
    other = family.system({"pinion.mass": 0.8 * family.defaults["pinion.mass"]})
    assert other.omega == own.omega
    assert (other.matrix == own.matrix).all()
    assert (other.forcing == own.forcing).all()
    assert (other.clearances[0].stiffness_plus == own.clearances[0].stiffness_plus).all()


@pytest.mark.parametrize("more", ["", '[model]\nbody = "solid-disc"\n'])
def test_without_a_drawing_or_as_stated_it_is_a_disc_of_the_mass_estimated_or_not(more: str):
    """m r²/2 with r the pitch radius; setting the estimated mass changes nothing either."""
    plain = text("spur-1dof", *BODIES[1 if more else 0]) + more
    if not more:
        plain = plain.replace("quality = 6\n", "")
    case = loads(plain)
    found = values(case)
    mass = found["gear.mass"].value
    assert found["derived.inertia_gear"].value == pytest.approx(mass / 2 * (61 * 2e-3) ** 2, rel=1e-12)
    same = values(case.with_overrides({"gear.mass": f"{mass!r} kg"}))
    whole = found["derived.equivalent_mass"].value
    assert same["derived.equivalent_mass"].value == pytest.approx(whole, rel=1e-14)
    heavier = values(case.with_overrides({"gear.mass": f"{2 * mass!r} kg"}))
    assert heavier["derived.inertia_gear"].value == pytest.approx(2 * found["derived.inertia_gear"].value)


def test_the_article_keeps_the_discs_of_its_masses():
    found = values(gl.load_case("article"))
    assert "derived.inertia_pinion" in found
