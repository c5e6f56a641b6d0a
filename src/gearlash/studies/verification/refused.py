"""What of a case a pair of bodies with real teeth cannot have, or needs and is not told."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, isclose

from gearlash.case import Case, CaseError, Problem
from gearlash.case.kinds.gears.keys import GEARS
from gearlash.case.kinds.gears.kind import GearContent
from gearlash.gears import CylindricalPair

CYCLE = "mesh cycle"
"""Period of the curves that lie on every tooth alike."""
SIDES = {"back_stiffness": "stiffness", "back_gap": "gap"}
SAME = 1e-6
"""Of c_t² to that of the teeth, relative."""


class NotVerifiableError(CaseError):
    """A case that no model with real teeth stands for: every problem, with its field, value and what is
    expected."""


def gears_of(case: Case) -> GearContent:
    """The pair of gears that a case is.

    Parameters
    ----------
    case : Case

    Returns
    -------
    GearContent

    Raises
    ------
    NotVerifiableError
        If the case is no pair of gears, says too little for real teeth, or has what these cannot have.
    """
    content = case.content
    if not isinstance(content, GearContent):
        expected = "helical-pair or spur-1dof: there are no teeth to verify with"
        raise NotVerifiableError(case.name, [Problem("kind", content.kind.name, expected)])
    problems = [*_missing(content), *_load(content), *_sides(content), *_turns(content)]
    if problems:
        raise NotVerifiableError(case.name, problems)
    return content


def _missing(content: GearContent) -> Iterator[Problem]:
    """Teeth, widths and bodies; masses only where bearings let them move."""
    rules, entries, numbers = content.rules, content.completed.entries, content.numbers
    leaves = ["teeth", "face_width", *(["mass"] if rules.bearings else [])]
    leaves += [] if numbers.body.inertias is not None else ["inertia"]
    wanted = [f"{gear}.{leaf}" for leaf in leaves for gear in GEARS]
    wanted += [rules.module, "mesh.pressure_angle", *rules.angles]
    if not numbers.scales.physical:
        wanted += ["mesh.mean_stiffness", "mesh.backlash", "operation.torque"]
    for path in wanted:
        place = rules.places.quantities[path]
        stated = entries.get(place.key)
        if stated is None or stated.dimensionless:
            yield Problem(path, None, f"{place.expected}, for real teeth", missing=True)


def _told(content: GearContent, key: str, expected: str) -> Problem:
    entry = content.completed.entries[key]
    return Problem(entry.path, entry.text or f"{entry.number:g}", expected)


def _load(content: GearContent) -> Iterator[Problem]:
    """The drive side carries."""
    load = content.numbers.parameters["load"]
    if load < 0.0:
        yield _told(content, "load", "a torque above 0: the pinion drives real teeth, with their drive side")
    if load == 0.0:
        yield _told(content, "load", "a torque above 0: the stiffness of real teeth is that under a load")


def _sides(content: GearContent) -> Iterator[Problem]:
    """Both sides of a tooth are one flank and its mirror image, with play between them."""
    values = content.numbers.parameters
    for key, what in SIDES.items():
        if values.get(key, 1.0) != 1.0:
            yield _told(content, key, f"1, or nothing: both sides of a real tooth have the same {what}")
    if values["D"] == 0.0:
        yield _told(content, "D", "a backlash above 0: teeth without play jam as their axes come nearer")


def _turns(content: GearContent) -> Iterator[Problem]:
    """What repeats with a shaft and not with the mesh; a rotation that acts otherwise than by the teeth."""
    numbers = content.numbers
    alike = "that of one tooth is that of all in the model with real teeth"
    for gear in GEARS:
        if numbers.parameters.get(f"{gear}_runout", 0.0) != 0.0:
            yield _told(
                content, f"{gear}_runout", f"0, or nothing: an error repeats with the mesh, as {alike}"
            )
    for name, curve in content.curves.items():
        if curve["over"] != CYCLE:
            yield Problem(f"curves.{name}.over", repr(curve["over"]), f"{CYCLE!r}: a curve, as {alike}")
    line, factor = numbers.body.line, numbers.parameters.get("rotation_factor")
    if line is not None and factor is not None and not isclose(factor, line.c_t**2, rel_tol=SAME):
        yield _told(content, "rotation_factor", f"nothing: with these teeth it is {line.c_t**2:.6g}")


def meshing(case: Case, pair: CylindricalPair) -> CylindricalPair:
    """The pair, if its involutes hand over the contact.

    Parameters
    ----------
    case : Case
    pair : CylindricalPair
        With its face width.

    Returns
    -------
    CylindricalPair

    Raises
    ------
    NotVerifiableError
        Before any finite element is computed.
    """
    problems = list(_interference(pair))
    ratio = pair.transverse_contact_ratio
    if not ratio > 1.0:
        expected = "above 1: real teeth hand over the contact in every transverse section"
        problems.append(Problem("mesh", f"ε_α {ratio:.4g}", expected))
    if problems:
        raise NotVerifiableError(case.name, problems)
    return pair


def _interference(pair: CylindricalPair) -> Iterator[Problem]:
    """Tips that reach below the involute of their mates, where nothing is known of the flank."""
    for i, reached in enumerate(pair.interference):
        if not reached:
            continue
        own, other = pair.gears[i], pair.gears[1 - i]
        roll = pair.tangent_length - own.roll_length(own.root_form_diameter)
        most = 2.0 * hypot(roll, 0.5 * other.base_diameter)
        expected = (
            f"up to {1e3 * most:.5g} mm, which ends where the involute of the {GEARS[i]} begins, or more "
            f"{GEARS[i]}.profile_shift"
        )
        yield Problem(f"{GEARS[1 - i]}.tip_diameter", f"{1e3 * other.tip_diameter:.5g} mm", expected)
