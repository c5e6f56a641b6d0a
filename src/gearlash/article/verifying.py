"""How the article's pair is verified with real teeth, and whether this code computes what is kept of it."""

from __future__ import annotations

from dataclasses import replace

from gearlash.case import Case
from gearlash.studies.verification import Plan, inputs_of, planned

RELIEF = {"tip": 80e-6, "length": 8e-3, "crowning": 70e-6}
"""A modification that turns the harmonics of the stiffness round, m: of both tips, over which roll length,
and at both ends of the face. With it the case's width is about as stiff as the case says, at its torque."""
VARIED = "stiffness", "dimensionless", "absolute"
"""Inputs with which every setting is tried."""
CLOSE = 1e-6
"""Relative, of numbers of one code on two machines."""


def plan_of_article() -> Plan:
    """Everything; flanks with `RELIEF` as one more way to hold the inputs; and every setting with all inputs
    that are not modified, so that those which disagree with the article are tried as hard as one that agrees.

    Returns
    -------
    Plan
    """
    from gearlash.multibody.topography import Relief

    tip, length = RELIEF["tip"], RELIEF["length"]
    relief = Relief(tip, tip, length, length, crowning=RELIEF["crowning"])
    return replace(planned(relief=relief), varied=VARIED)


def check_numbers(case: Case) -> dict[str, float]:
    """A few numbers of the whole way from flanks to forces, in seconds: coarse elements, two mesh cycles.

    They are no result: they say whether the code computes what it did.

    Parameters
    ----------
    case : Case

    Returns
    -------
    dict of str to float
        Stiffness, N/m; its first two harmonics; least and greatest force, N.
    """
    from gearlash.multibody.compliance import SectorSettings
    from gearlash.multibody.tooth_contact import ToothContact
    from gearlash.multibody.tooth_section import Fineness
    from gearlash.studies.verification.mesh import mesh_of
    from gearlash.studies.verification.point import run_point
    from gearlash.studies.verification.settings import PLANNED

    coarse = SectorSettings(Fineness(flank=2, fillet=1, core=1, rim=1, axial=2), teeth=3)
    inputs = inputs_of(case, (1.0,))
    mesh = mesh_of(inputs, inputs.pair.face_width, inputs.torque, coarse)
    contact = mesh.contact(inputs, errors=((inputs.error, 0.0),), flexible=True)
    found = run_point(
        inputs,
        ToothContact(contact.tables),
        replace(PLANNED, finest=PLANNED.finer, settle=1, read=2),
        omega=0.45,
        stiffness=mesh.stiffness,
        torque=inputs.torque,
        modes=mesh.modes(flexible=True),
    )
    return {
        "stiffness": mesh.stiffness,
        "first_harmonic": mesh.ripples[0],
        "second_harmonic": mesh.ripples[1],
        "least_force": found.reading.least,
        "greatest_force": found.reading.most,
    }


def checked(case: Case, kept: dict[str, float]) -> str:
    """What this run says of numbers that are kept.

    Parameters
    ----------
    case : Case
    kept : dict of str to float
        `check_numbers` of the code that computed what is kept; empty where there are none.

    Returns
    -------
    str
        A sentence.
    """
    from gearlash.multibody.extra import MissingExtraError, require_extra

    if not kept:
        return "No numbers are kept that this run could check the code with."
    try:
        require_extra()
    except MissingExtraError:
        return (
            "Whether this code still computes them was not checked in this run: the extra multibody is not "
            "installed."
        )
    now = check_numbers(case)
    off = max(abs(now[name] - value) / max(abs(value), 1e-12) for name, value in kept.items())
    what = "stiffness, its harmonics and forces of a short motion with coarse elements"
    if off < CLOSE:
        return (
            f"In this run {what} were computed anew: they are those of the code that computed these numbers."
        )
    return (
        f"In this run {what} were computed anew: they differ by up to {100.0 * off:.2g} % from those of the "
        "code that computed these numbers, so this code may give other ones."
    )
