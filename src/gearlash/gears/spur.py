"""The one-degree-of-freedom gear pair: torsion only, one backlash.

    X″ = f_m − c_t² Φ − E″,   Φ = η(θ) f(X; D) + ζ X′

Model of Kahraman & Singh, J. Sound Vib. 142 (1990) 49–75, doi:10.1016/0022-460X(90)90582-K, with periodic
stiffness; there c_t = 1 (displacement measured along the line of action, `Projection.BASE`).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from gearlash.system import ContactRule, Family, GearlashError, Parameter, System
from gearlash.system.readout import Readout

from .excitation import NOTHING, Excitation
from .mesh import (
    ERROR_READOUT,
    acceleration_forcing,
    harmonic_count,
    mesh_clearance,
    mesh_parameters,
    resting_displacement,
    rotation_parameter,
    series,
)

STATES = ("X", "X'")
H = np.array([1.0, 0.0])


def family(
    defaults: Mapping[str, float],
    contact: ContactRule = ContactRule.ALWAYS,
    excitation: Excitation = NOTHING,
) -> Family:
    """The spur pair as a family of systems with the states X and X′.

    Parameters
    ----------
    defaults : mapping of str to float
        Parameter values by short name: ``omega``, ``D``, ``load``, and whatever is not zero of ``ripple``,
        ``ripple_phase``, ``error``, ``error_phase`` (each also ``_2``, ``_3`` …) and ``mesh_damping``;
        ``back_stiffness``, ``back_gap`` and ``rotation_factor`` (c_t²) are 1 where nothing is given.
    contact : ContactRule
        When the damping of the mesh acts.
    excitation : Excitation
        Curves of stiffness and error and run-out of the shafts, beside the named harmonics.

    Returns
    -------
    Family

    Raises
    ------
    GearlashError
        For a name that is no parameter, or where ``omega``, ``D`` or ``load`` is missing.

    References
    ----------
    A. Kahraman, R. Singh, J. Sound Vib. 142 (1990) 49, doi:10.1016/0022-460X(90)90582-K.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.gears import spur
    >>> family = spur.family({"omega": 0.7, "D": 1.0, "load": 0.2, "error": 0.05, "mesh_damping": 0.05})
    >>> gl.attractor(family.system(), family.start()).label
    1-0-0
    """
    parameters = (
        *mesh_parameters(defaults),
        *excitation.parameters(defaults),
        rotation_parameter(defaults.get("rotation_factor", 1.0)),
    )
    reject_unknown(defaults, parameters)
    orders = harmonic_count(defaults, "ripple"), harmonic_count(defaults, "error")

    def build(values: Mapping[str, float]) -> System:
        driven = acceleration_forcing(values, orders[1], excitation)
        forcing = np.vstack([np.zeros_like(driven), driven])
        g = np.array([0.0, -values["rotation_factor"]])
        clearance = mesh_clearance(values, H, g, orders[0], contact, excitation)
        matrix = np.array([[0.0, 1.0], [0.0, 0.0]])
        return System(values["omega"], matrix, forcing, (clearance,), excitation.cycles)

    def cold_start(values: Mapping[str, float]) -> NDArray[np.float64]:
        return np.array([resting_displacement(values, values["rotation_factor"]), 0.0])

    return Family(parameters, STATES, build, cold_start)


def natural_frequencies(rotation_factor: float = 1.0) -> NDArray[np.float64]:
    """The one undamped natural frequency with the mesh closed at its mean stiffness: c_t.

    Parameters
    ----------
    rotation_factor : float
        c_t².

    Returns
    -------
    ndarray, shape (1,)
        Over ω_n.

    Examples
    --------
    >>> from gearlash.gears import spur
    >>> spur.natural_frequencies(0.81).tolist()
    [0.9]
    """
    return np.sqrt(np.array([rotation_factor]))


def readouts(values: Mapping[str, float], excitation: Excitation = NOTHING) -> tuple[Readout, ...]:
    """The transmission error, X + E over D_c: what the rotation of both gears gives along the line of action.

    Parameters
    ----------
    values : mapping of str to float
        Every parameter of the family by short name.
    excitation : Excitation
        As `family` got it.

    Returns
    -------
    tuple of Readout
        ``transmission_error``.

    Examples
    --------
    >>> from gearlash.gears import spur
    >>> family = spur.family({"omega": 0.7, "D": 1.0, "load": 0.2, "error": 0.05})
    >>> spur.readouts(family.complete())[0].offset.round(2).tolist()
    [0.0, 0.05, -0.0]
    """
    error = excitation.error_series(values, series(values, "error", 0.0, harmonic_count(values, "error")))
    return (Readout(*ERROR_READOUT, H, error),)


def reject_unknown(defaults: Mapping[str, float], parameters: tuple[Parameter, ...]) -> None:
    """Raises `GearlashError` where a default is given for a name that is no parameter."""
    names = {p.name for p in parameters}
    unknown = sorted(set(defaults) - names)
    if unknown:
        known = ", ".join(sorted(names))
        raise GearlashError(f"no parameter {', '.join(unknown)} in this model (it has {known})")
