"""Teeth that no pair can run with, refused with the nearest value that can be, and unusual ones, told.

Refused: flanks that meet below the tip, tips in the roots of the mate where these were stated, and less than
one pair of teeth in contact at some time of the mesh cycle. Told: undercut and interference, thin tips,
little clearance, ε_α below 1 of helical teeth, and plastics beyond what the estimates are for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import cos

from gearlash.case.errors import Problem
from gearlash.case.note import Note
from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.cylindrical_pair import tip_shortening
from gearlash.gears.drawing import Drawing
from gearlash.system import GearlashError

from .drawn import CENTRE
from .keys import GEARS
from .play import OF_DRAWINGS, temperatures
from .rules import EntriesByKey

THIN_TIP = 0.2
"""Of the normal module: thinner tips break where they are hard (DIN 3960)."""
LEAST_CLEARANCE = 0.1
"""Of the normal module."""
BENT = 0.02
"""Of the normal module: with more deflection teeth touch well before their path of contact."""
PLASTIC = 20e9
"""Pa: moduli below are those of plastics."""


def impossible(entries: EntriesByKey, pair: CylindricalPair) -> Iterator[Problem]:
    """Why no pair can run with these teeth."""
    yield from _pointed(entries, pair)
    yield from _colliding(entries, pair)
    if pair.total_contact_ratio < 1.0:
        yield _too_short(entries, pair)


def _pointed(entries: EntriesByKey, pair: CylindricalPair) -> Iterator[Problem]:
    for name, one in zip(GEARS, pair.gears, strict=True):
        if one.tip_thickness() > 0.0:
            continue
        most = _root(lambda d, one=one: _thickness(one, d), one.tip_diameter, one.base_diameter)
        key = f"{name}.tip_diameter"
        if key not in entries:
            key = next((k for k in (f"{name}.profile_shift", f"{name}.span") if k in entries), key)
        ratio = THIN_TIP * one.normal_module
        usual = _root(lambda d, one=one, r=ratio: _thickness(one, d) - r, most, one.base_diameter)
        expected = (
            f"a tip that is no point: the flanks of the {name} meet at a tip diameter of "
            f"{_down(most)} mm; up to {_down(usual)} mm the tip keeps {THIN_TIP:g} m_n"
        )
        yield Problem(key, _text(entries, key), expected)


def _thickness(one: CylindricalGear, diameter: float) -> float:
    return replace(one, stated_tip_diameter=diameter).tip_thickness()


def _colliding(entries: EntriesByKey, pair: CylindricalPair) -> Iterator[Problem]:
    """Stated tips that reach into the root of the mate; those that nobody stated are told only."""
    for name, one, mate, clearance in _clearances(pair):
        key = f"{name}.tip_diameter"
        if clearance < 0.0 and key in entries:
            most = one.tip_diameter + 2.0 * clearance
            usual = most - 2.0 * LEAST_CLEARANCE * one.normal_module
            expected = (
                f"a tip diameter up to {_down(most)} mm, where the tip reaches the root of the {mate}; "
                f"up to {_down(usual)} mm {LEAST_CLEARANCE:g} m_n of clearance are left"
            )
            yield Problem(key, _text(entries, key), expected)


def _clearances(pair: CylindricalPair) -> Iterator[tuple[str, CylindricalGear, str, float]]:
    """Of each gear's tip."""
    for i, (one, clearance) in enumerate(zip(pair.gears, pair.tip_clearances, strict=True)):
        yield GEARS[i], one, GEARS[1 - i], clearance


def _too_short(entries: EntriesByKey, pair: CylindricalPair) -> Problem:
    """A pair of teeth that leaves before the next one comes."""
    what = f"teeth that mesh all round: these have ε_γ = {pair.total_contact_ratio:.3g}, and 1 is the least"
    stated = [gear for gear in GEARS if f"{gear}.tip_diameter" in entries]
    if stated and (grown := _grown(pair, stated)) is not None:
        key = f"{stated[0]}.tip_diameter"
        sizes = " and ".join(f"{1e3 * d:.5g} mm of the {gear}" for gear, d in grown.items())
        return Problem(key, _text(entries, key), f"{what}; tip diameters from {sizes} have it")
    undercut = [i for i in range(2) if pair.gears[i].undercut]
    if CENTRE in entries and not undercut:

        def missing(distance: float) -> float:
            return replace(pair, stated_centre_distance=distance).total_contact_ratio - 1.0

        near = pair.tight_centre_distance
        if near < pair.centre_distance and missing(near) > 0.0:
            most = _root(missing, pair.centre_distance, near)
            return Problem(
                CENTRE, _text(entries, CENTRE), f"{what}; centre distances up to {_down(most)} mm have"
            )
    for i in undercut:
        one = pair.gears[i]
        key = f"{GEARS[i]}.profile_shift"
        key = key if _text(entries, key) else f"{GEARS[i]}.teeth"
        expected = (
            f"{what}; the {GEARS[i]} is undercut, from a profile shift of {one.undercut_limit:.3g} on it is "
            f"not, nor from {_uncut(one)} teeth on"
        )
        return Problem(key, _text(entries, key), expected)
    return Problem("mesh", None, what)


def _grown(pair: CylindricalPair, stated: list[str]) -> dict[str, float] | None:
    """Stated tip diameters, all larger by the same, with which the contact ratio is 1."""

    def larger(by: float) -> CylindricalPair:
        gears = [
            replace(one, stated_tip_diameter=one.tip_diameter + by) if name in stated else one
            for name, one in zip(GEARS, pair.gears, strict=True)
        ]
        return replace(pair, pinion=gears[0], gear=gears[1])

    most = 2.0 * pair.pinion.normal_module
    if larger(most).total_contact_ratio < 1.0:
        return None
    by = _root(lambda x: larger(x).total_contact_ratio - 1.0, 0.0, most)
    whole = larger(by)
    return {name: one.tip_diameter for name, one in zip(GEARS, whole.gears, strict=True) if name in stated}


def _uncut(one: CylindricalGear) -> int:
    """The least number of teeth without undercut at this profile shift."""
    teeth = one.teeth
    while teeth < 200 and replace(one, teeth=teeth, stated_tip_diameter=None).undercut:
        teeth += 1
    return teeth


def _root(function: Callable[[float], float], wrong: float, right: float) -> float:
    """Between a place where the function is below 0 and one where it is not: where that changes."""
    for _ in range(60):
        middle = 0.5 * (wrong + right)
        if function(middle) < 0.0:
            wrong = middle
        else:
            right = middle
    return right


def _down(length: float) -> str:
    """In mm, rounded down to a hundredth."""
    return f"{int(1e5 * length) / 100.0:g}"


def _text(entries: EntriesByKey, key: str) -> str | None:
    return repr(entries[key].text) if key in entries and entries[key].text else None


def unusual(entries: EntriesByKey, drawing: Drawing, force: float) -> Iterator[Note]:
    """What is unusual about teeth that can run, under this normal force."""
    pair = drawing.meshing
    module = pair.pinion.normal_module
    yield from _roots(pair)
    for name, one in zip(GEARS, pair.gears, strict=True):
        tip = one.tip_thickness()
        if tip < THIN_TIP * module:
            thick = f"{1e3 * tip:.3g} mm thick, {tip / module:.2g} m_n; usual is {THIN_TIP:g} m_n"
            yield Note(f"{name}.tip_diameter", f"the tip of the {name} is {thick}")
    shortened = tip_shortening(pair)
    for name, one, mate, clearance in _clearances(pair):
        if clearance < LEAST_CLEARANCE * module:
            usual = one.tip_diameter + 2.0 * min(shortened, 0.0)
            left = f"has {1e3 * clearance:.3g} mm of clearance in" if clearance >= 0.0 else "would reach into"
            text = f"the tip of the {name} {left} the root of the {mate}"
            text += (
                f"; shortened as usual it has {1e3 * usual:.5g} mm"
                if f"{name}.tip_diameter" not in entries
                else ""
            )
            yield Note(f"{name}.tip_diameter", text)
    if pair.transverse_contact_ratio < 1.0:
        text = (
            f"ε_α = {pair.transverse_contact_ratio:.3g} is below 1: only the overlap keeps teeth in contact"
        )
        yield Note("derived.transverse_contact_ratio", text)
    yield from _soft(entries, drawing, force)


def _roots(pair: CylindricalPair) -> Iterator[Note]:
    for name, one, reached in zip(GEARS, pair.gears, pair.interference, strict=True):
        if one.undercut:
            text = (
                f"the {name} is undercut: from a profile shift of {one.undercut_limit:.3g} on it would not "
                f"be, nor from {_uncut(one)} teeth on; contact begins where the fillet ends"
            )
            yield Note(f"{name}.profile_shift", text)
        elif reached:
            text = f"the tip of its mate reaches below the involute of the {name}"
            yield Note(f"{name}.root_diameter", f"{text}: contact begins where that does")


def _soft(entries: EntriesByKey, drawing: Drawing, force: float) -> Iterator[Note]:
    """Plastics: what heat does, and how far teeth bend."""
    pair, stiffness = drawing.meshing, entries.get("mesh.mean_stiffness")
    for name, material in zip(GEARS, drawing.chosen_materials, strict=True):
        warm = temperatures(entries)[name]
        if material.youngs_modulus < PLASTIC and warm > OF_DRAWINGS + 10.0:
            low, high = (1e-9 * value for value in material.youngs_range)
            text = (
                f"{material.name} at {warm:g} °C is softer than at 20 °C, for which its modulus is; the "
                f"range of the estimates has {low:g} to {high:g} GPa"
            )
            yield Note(f"{name}.temperature", text)
    module = pair.pinion.normal_module
    if stiffness is not None and force / stiffness.number > BENT * module:
        bent = force / stiffness.number
        text = (
            f"teeth give way by {1e6 * bent:.3g} µm under this torque, {bent / module:.2g} m_n (along the "
            "normal, in the mean): they touch well before and behind the path of contact. Of that the "
            "estimated variation of the stiffness has what pairs of teeth under this torque tell; the mean "
            "stiffness, of the path of contact alone, has it not, and is rather too low"
        )
        yield Note("operation.torque", text)


def normal_force(pair: CylindricalPair, torque: float) -> float:
    """Of a torque of the pinion, N."""
    return 2.0 * abs(torque) / pair.pinion.base_diameter / cos(pair.pinion.base_helix_angle)


class ValueProblemError(GearlashError):
    """A stated value that no pair can have, with what it may be."""

    def __init__(self, problem: Problem):
        super().__init__(str(problem))
        self.problem = problem

    def __reduce__(self) -> tuple[type[ValueProblemError], tuple[Problem]]:
        return type(self), (self.problem,)
