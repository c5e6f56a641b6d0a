"""What a drawing leaves open, estimated: each value with the range it may lie in and where it comes from.

An estimate is no measurement. Its ends are limits where the source tells limits, and estimates where it says
so.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from math import cos, pi

import numpy as np

from . import backlash, bearings, gear_fits, unloaded_error
from .cylindrical_pair import CylindricalPair
from .drawing import GRADE_SPREAD, Drawing, Estimate
from .gear_body import GearBody, mean_tooth_diameter
from .stiffness_estimates import mean_stiffness, ripples

USUAL_FIT, TIGHT_FIT, LOOSE_FIT = "25cd", "24e", "27b"
"""Of DIN 3967: what general mechanical engineering often has, and about the least and the most of it."""


MESH_DAMPING = Estimate(
    0.07, 0.03, 0.17, "practice: 0.03 to 0.17 (R. Kasuba, J. W. Evans, J. Mech. Des. 103 (1981) 398)"
)
BEARING_DAMPING = Estimate(0.02, 0.01, 0.05, "practice: 0.01 to 0.05 for rolling bearings, an estimate")
ERROR_PHASE = Estimate(
    0.5 * pi, -pi, pi, "not known; a quarter of a cycle after the stiffness, so that neither hides the other"
)
ALONE = "of the gear alone; what turns rigidly with it is stated as added_inertia, its mass as added_mass"
USUAL_BORE = 0.6
"""Of the root diameter: of a shaft that is not known."""
GEARS = ("pinion", "gear")


NAMES = (
    "mean_stiffness", "ripple", "error", "error_phase", "backlash", "mesh_damping", "bodies", "bearings",
    "bearing_damping", "bearing_span",
)  # fmt: skip
"""What can be estimated."""


def estimates(drawing: Drawing, harmonics: int = 8, names: Collection[str] = NAMES) -> dict[str, Estimate]:
    """What a model of the pair needs and the drawing does not say.

    Parameters
    ----------
    drawing : Drawing
    harmonics : int
        How many of the stiffness.
    names : collection of str
        Of `NAMES`: what is wanted.

    Returns
    -------
    dict of str to Estimate
        ``mean_stiffness`` (N/m, along the normal), ``ripple_1`` … (over the mean, signed, phase 0 in the
        middle of a pair's path; modified flanks have ``ripple_phase_1`` … too), ``error`` (amplitude at the
        mesh frequency along the normal, m),
        ``error_phase`` (rad, not known), ``backlash`` (normal, m), ``mesh_damping``, ``pinion_mass``,
        ``gear_mass`` (kg), ``pinion_inertia``, ``gear_inertia`` (kg·m²), ``pinion_bearing_y`` …
        ``gear_bearing_z`` (N/m, radial and axial), ``bearing_damping``, ``pinion_bearing_span`` and
        ``gear_bearing_span`` (m, from middle to middle of the two bearings of a shaft).
    """
    found: dict[str, Estimate] = {}
    if "mean_stiffness" in names:
        found["mean_stiffness"] = mean_stiffness(drawing)
    if "ripple" in names:
        found |= ripples(drawing, harmonics)
    if "error" in names:
        found["error"] = _error(drawing)
    if "error_phase" in names:
        found["error_phase"] = ERROR_PHASE
    if "backlash" in names:
        found["backlash"] = _backlash(drawing)
    if "mesh_damping" in names:
        found["mesh_damping"] = MESH_DAMPING
    if "bodies" in names:
        found |= _masses(drawing)
    if "bearings" in names:
        found |= _bearings(drawing)
    if "bearing_damping" in names:
        found["bearing_damping"] = BEARING_DAMPING
    if "bearing_span" in names:
        found |= _spans(drawing)
    return found


def _error(drawing: Drawing) -> Estimate:
    """Of the classes; the range goes to the most that the coarsest of them allow."""
    finest, own, coarsest = (drawing.grades_apart(n * GRADE_SPREAD) for n in (-1, 0, 1))
    nominal, coarse = (unloaded_error.unloaded_error(drawing.meshing, g).mesh for g in (own, coarsest))
    told = [
        f"{grade} (assumed, {low} to {high})" if low != high else f"{grade}"
        for grade, low, high in zip(own, finest, coarsest, strict=True)
    ]
    source = f"ISO 1328-1, classes {told[0]} and {told[1]}; {unloaded_error.ASSUMPTION}"
    return Estimate(nominal.nominal, nominal.least, coarse.greatest, source)


def _backlash(drawing: Drawing) -> Estimate:
    """From stated allowances, from stated fits, or from usual ones."""
    pair = drawing.pair
    grade = drawing.distance_grade
    deviation = 0.0 if grade is None else gear_fits.centre_distance_deviation(grade, pair.centre_distance)
    distance = "deviation of the centre distance as stated" if grade is None else f"js{grade} of DIN 3964"
    if any(gear.thickness_allowance != 0.0 for gear in pair.gears):
        first, second = (gear.thickness_allowance for gear in pair.gears)
        stated = (first, first), (second, second)
        least, greatest = backlash.limits(pair, stated, (-deviation, deviation))
        source = f"stated tooth thickness; {'' if grade is None else 'centre distance '}{distance}"
        return Estimate(backlash.of_pair(pair).normal, least.normal, greatest.normal, source)
    nominal = _fitted(pair, drawing.fits or (USUAL_FIT, USUAL_FIT), deviation)
    middle = 0.5 * (nominal[0] + nominal[1])
    if drawing.fits is not None:
        source = f"DIN 3967, {' and '.join(drawing.fits)}; {distance}"
        return Estimate(middle, *nominal, source)
    least = _fitted(pair, (TIGHT_FIT, TIGHT_FIT), deviation)[0]
    greatest = _fitted(pair, (LOOSE_FIT, LOOSE_FIT), deviation)[1]
    source = (
        f"no fit stated: {USUAL_FIT} of DIN 3967 assumed, {TIGHT_FIT} to {LOOSE_FIT} in the range; {distance}"
    )
    return Estimate(middle, least, greatest, source)


def _fitted(pair: CylindricalPair, fits: tuple[str, str], deviation: float) -> tuple[float, float]:
    """Least and greatest normal backlash of two fits."""
    first, second = (
        gear_fits.thickness_allowances(fit, gear.reference_diameter)
        for fit, gear in zip(fits, pair.gears, strict=True)
    )
    least, greatest = backlash.limits(pair, (first, second), (-deviation, deviation))
    return least.normal, greatest.normal


def _bearings(drawing: Drawing) -> dict[str, Estimate]:
    """Of two ball bearings on the shaft, under the load of the teeth where a torque is known."""
    pair, found = drawing.pair, {}
    force = 0.0
    if drawing.torque is not None:
        force = 2.0 * abs(drawing.torque) / pair.pinion.base_diameter / cos(pair.pinion.base_helix_angle)
    spans = _spans(drawing)
    for name, (shaft, whose), stated in zip(GEARS, _shafts(drawing), drawing.stated_bending, strict=True):
        span = spans[f"{name}_bearing_span"].value
        bends = bearings.shaft_stiffness(shaft, 0.5 * (span - pair.face_width))
        source = (
            f"two deep groove ball bearings on a shaft of {shaft * 1e3:.3g} mm ({whose}), A. Palmgren; "
            f"range: a factor of {bearings.SPREAD:g} either way for rollers, shaft and housing, an estimate"
        )
        for axis, value in zip("yz", bearings.shaft_bearings(shaft, force), strict=True):
            least, told = value / bearings.SPREAD, source
            with_shaft = 1.0 / (1.0 / value + 1.0 / bends)
            if axis == "y" and with_shaft < least and not stated:
                least = with_shaft
                told += f", and lower with this shaft, which bends between bearings {span * 1e3:.3g} mm apart"
            found[f"{name}_bearing_{axis}"] = Estimate(value, least, value * bearings.SPREAD, told)
    return found


def _shafts(drawing: Drawing) -> list[tuple[float, str]]:
    """Diameter of each shaft in its bearings, and where it is from."""
    pair, found = drawing.pair, []
    smaller = "gear" if pair.gear.root_diameter < pair.pinion.root_diameter else "pinion"
    usual = USUAL_BORE * min(one.root_diameter for one in pair.gears)
    for body, own in zip(drawing.bodies, drawing.shafts, strict=True):
        if own is not None:
            found.append((own, "as stated"))
        elif body is not None and body.bore > 0.0:
            found.append((body.bore, "the stated bore"))
        else:
            found.append((usual, f"{USUAL_BORE} of the {smaller}'s root diameter"))
    return found


def _spans(drawing: Drawing) -> dict[str, Estimate]:
    """Of bearings in the walls of a housing on both sides of the pair, or as stated."""
    width, distance = drawing.pair.face_width, drawing.pair.centre_distance
    found: dict[str, Estimate] = {}
    for name, stated, (shaft, whose) in zip(GEARS, drawing.spans, _shafts(drawing), strict=True):
        span, factor = stated, 1.0
        source = "as stated"
        if span is None:
            span, factor = bearings.bearing_span(width, distance, shaft), bearings.SPAN_FACTOR
            source = (
                f"bearings in the walls beside {width * 1e3:.3g} mm of face, on a shaft of {shaft * 1e3:.3g} "
                f"mm ({whose}), by the practice of gear units; an estimate, half to twice as far"
            )
        found[f"{name}_bearing_span"] = Estimate(span, span / factor, span * factor, source)
    return found


def _masses(drawing: Drawing) -> dict[str, Estimate]:
    """Mass and inertia of the stated bodies, or of solid discs with a bore that is not known."""
    found = {}
    for name, gear, body, material in zip(
        GEARS, drawing.pair.gears, drawing.bodies, drawing.chosen_materials, strict=True
    ):
        if body is not None:
            exact = "rings of the stated body"
            for what, value in (
                ("mass", body.mass(material.density)),
                ("inertia", body.inertia(material.density)),
            ):
                found[f"{name}_{what}"] = Estimate(
                    value, 0.97 * value, 1.03 * value, f"{exact}, {ALONE}; {material.source}"
                )
            continue
        solid = GearBody(mean_tooth_diameter(gear), drawing.pair.face_width)
        hollow = replace(solid, bore=0.6 * solid.outer_diameter)
        for what in ("mass", "inertia"):
            values = [getattr(one, what)(material.density) for one in (solid, hollow)]
            found[f"{name}_{what}"] = Estimate(
                values[0],
                values[1],
                1.03 * values[0],
                f"no body stated: a solid disc, a bore of 0.6 d in the range; {ALONE}",
            )
    return found


def natural_frequency(found: dict[str, Estimate], pair: CylindricalPair) -> Estimate:
    """Frequency of the torsional mode of the closed mesh, of the estimates' values and ends.

    Parameters
    ----------
    found : dict of str to Estimate
    pair : CylindricalPair

    Returns
    -------
    Estimate
        Hz: √(K/m_e)/2π with m_e of the base radii and rotation along the normal.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.estimates import Drawing, estimates, natural_frequency
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> round(natural_frequency(estimates(Drawing(pair)), pair).value)
    8580
    """

    def at(stiffness: float, pinion: float, gear: float) -> float:
        along = np.cos(pair.pinion.base_helix_angle)
        masses = sum(
            (0.5 * along * one.base_diameter) ** 2 / inertia
            for one, inertia in zip(pair.gears, (pinion, gear), strict=True)
        )
        return float(np.sqrt(stiffness * masses) / (2.0 * pi))

    k, first, second = (found[name] for name in ("mean_stiffness", "pinion_inertia", "gear_inertia"))
    return Estimate(
        at(k.value, first.value, second.value),
        at(k.least, first.greatest, second.greatest),
        at(k.greatest, first.least, second.least),
        "mean stiffness and inertias as estimated",
    )
