"""Curves that several tests look at, followed once a process."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from branches.followed import PLAIN, bundled, linear, parametric, six
from gearlash.branches.continuation import (
    Branch,
    ContinuationSettings,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
)
from gearlash.branches.curves import (
    CodimTwoKind,
    CodimTwoPoint,
    Curve,
    CurvePoint,
    Listener,
    Plane,
    beginning,
    curve_through,
)
from gearlash.orbits import Orbit, orbit_at
from gearlash.system import Clearance, Family, Parameter, System
from orbits.members import built, one_dof, orbit

QUIET = Listener(lambda _: None, lambda: False)
COARSE = ContinuationSettings(certify=False, longest=0.1)
Pair = tuple[float, float]


def followed(
    family: Family,
    values: Mapping[str, float],
    names: tuple[str, str],
    special: SpecialPoint | CodimTwoPoint | CurvePoint,
    lower: Pair,
    upper: Pair,
    kind: SpecialKind | None = None,
    steps: ContinuationSettings = PLAIN,
    **choice: Any,
) -> Curve:
    plane = Plane(family, family.complete(values), names, lower, upper)
    place = np.array([plane.values[name] for name in names])
    return curve_through(beginning(plane, special, place, kind, **choice), steps, QUIET)


def named(names: tuple[str, ...], values: tuple[float, ...]) -> dict[str, float]:
    return dict(zip(names, values, strict=True))


def lowest(branch: Branch, kind: SpecialKind) -> SpecialPoint:
    return min(branch.of_kind(kind), key=lambda special: special.value)


def only(curve: Curve, kind: CodimTwoKind) -> CodimTwoPoint:
    (found,) = curve.of_kind(kind)
    return found


@cache
def fold_over_backlash() -> Curve:
    fold = lowest(linear(), SpecialKind.FOLD)
    return followed(one_dof(error=0.05), {"omega": fold.value}, ("omega", "D"), fold, (0.6, 0.05), (0.9, 1.2))


@cache
def doubling_over_error() -> Curve:
    doubling = lowest(parametric(), SpecialKind.DOUBLING)
    values = {"omega": doubling.value}
    family = one_dof(error=0.0005, ripple=0.3)
    return followed(family, values, ("omega", "error"), doubling, (1.7, 0.0001), (2.0, 0.2))


@cache
def corner() -> Curve:
    """The grazing curve of the contact-only orbit over a strong ripple."""
    family, values = one_dof(error=0.09, ripple=0.95), {"omega": 1.3, "error": 0.01}
    branch = continue_orbit(family, values, "error", orbit(family, **values), 0.001, 0.2, PLAIN)
    touch = lowest(branch, SpecialKind.GRAZING)
    values = {"omega": 1.3, "error": touch.value}
    return followed(family, values, ("omega", "error"), touch, (0.95, 0.001), (1.4, 0.2))


@cache
def article() -> Curve:
    """The doubling of the 6-orbit over backlash and bearing damping."""
    doubling = lowest(six(), SpecialKind.DOUBLING)
    values = {"omega": 0.78, "D": doubling.value}
    names = ("D", "bearing_damping")
    return followed(bundled(), values, names, doubling, (0.34, 0.036), (0.36, 0.05), steps=COARSE)


E1, PSI1, E2, PSI2 = 0.0768295371441074, 0.218668945873942, 0.0204190581082424, 3.03938593548254


def two_harmonics(part_1: float, part_2: float) -> tuple[Family, dict[str, float], Orbit]:
    """The contact-only orbit near the flat touch: a cold start would meet another."""
    family = one_dof(error=E1, error_phase=PSI1, error_2=E2, error_phase_2=PSI2, omega=0.8)
    half = orbit_at(built(family, error=0.5 * E1, error_2=0.5 * E2), [1.1, 0.0], 1)
    assert half is not None
    values = {"error": part_1 * E1, "error_2": part_2 * E2}
    found = orbit_at(built(family, **values), half.state, 1)
    assert found is not None
    return family, values, found


@cache
def flat() -> Curve:
    family, values, start = two_harmonics(0.98, 0.9)
    branch = continue_orbit(family, values, "error", start, 0.07, 0.08, PLAIN)
    touch = lowest(branch, SpecialKind.GRAZING)
    values = {**values, "error": touch.value}
    return followed(family, values, ("error", "error_2"), touch, (0.07, 0.018), (0.08, 0.024))


@cache
def swallowtail() -> Curve:
    """Where a phase moves the symmetry is gone: the flat touch opens into two cusps and a crossing."""
    touch = max(flat().points, key=lambda point: point.values[1])
    values = named(("error", "error_2"), touch.values)
    family = two_harmonics(1.0, 1.0)[0]
    return followed(family, values, ("error", "error_phase_2"), touch, (0.07, 2.9), (0.085, 3.2))


curve_family = {
    fold_over_backlash: lambda: one_dof(error=0.05),
    doubling_over_error: lambda: one_dof(error=0.0005, ripple=0.3),
    corner: lambda: one_dof(error=0.09, ripple=0.95),
    flat: lambda: two_harmonics(1.0, 1.0)[0],
    swallowtail: lambda: two_harmonics(1.0, 1.0)[0],
}


def between_two_stops(one: bool = False) -> Family:
    """An oscillator between two stops, each a clearance of its own, or both sides of one."""

    def build(p: Mapping[str, float]) -> System:
        h, g, none, hard = np.array([1.0, 0.0]), np.array([0.0, -1.0]), np.zeros(1), np.array([8.0])
        stops = (
            Clearance(h, g, p["gap"], 9.0, hard, none, name="right"),
            Clearance(h, g, 9.0, p["other"], none, hard, name="left"),
        )
        if one:
            stops = (Clearance(h, g, p["gap"], p["other"], hard, hard, name="stops"),)
        forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
        return System(p["omega"], np.array([[0.0, 1.0], [-1.0, -0.1]]), forcing, stops)

    defaults = {"omega": 1.5, "gap": 1.0, "other": 1.5}
    parameters = tuple(Parameter(name, value) for name, value in defaults.items())
    return Family(parameters, ("x", "v"), build, lambda _: np.zeros(2))
