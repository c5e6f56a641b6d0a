"""The helical gear pair: torsion, lateral and axial motion of both gears, one backlash. Ten states.

    Y_i″ + 2ξ κ Y_i′ + κ² Y_i = ∓c_y (m_e/m_i) Φ   (− pinion, + gear; Z likewise with c_z)
    X″ = f_m − c_t² Φ + c_y (Y_p″ − Y_g″) + c_z (Z_p″ − Z_g″) − E″

Lengths over D_c, time τ = ω_n t, ω_n = √(k_m/m_e), κ = √(k_i/m_i)/ω_n. Motion along the line of centres
and tilt are absent.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

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
from .spur import reject_unknown

STATES = ("Y_p", "Y_p'", "Z_p", "Z_p'", "Y_g", "Y_g'", "Z_g", "Z_g'", "X", "X'")
BEARINGS = ("yp", "zp", "yg", "zg")
"""The four bearing directions, in the order of the states."""
SPEEDS = np.array([1, 3, 5, 7])
"""Indices of Y_p′, Z_p′, Y_g′, Z_g′."""
BEARING_WORDS = ("pinion, lateral", "pinion, axial", "gear, lateral", "gear, axial")
"""What the four bearing directions are."""
_EACH_DAMPING = tuple(f"bearing_damping_{b}" for b in BEARINGS)


@dataclass(frozen=True)
class HelicalPair:
    """The fixed numbers of a dimensionless helical pair.

    Parameters
    ----------
    rotation_factor : float
        c_t², above 0.
    y_factor, z_factor : float
        c_y and c_z.
    mass_ratios : (float, float)
        m_e/m_p and m_e/m_g.
    bearing_frequencies : (float, float, float, float)
        κ = √(k_i/m_i)/ω_n of Y_p, Z_p, Y_g, Z_g, the order of `BEARINGS`.
    contact : ContactRule
        When the damping of the mesh acts.

    Examples
    --------
    >>> from gearlash.gears import HelicalPair
    >>> pair = HelicalPair(0.8, 0.9, 0.3, (0.5, 0.1), (0.7, 0.6, 0.4, 0.3))
    >>> pair.bearing_gains.tolist()
    [-0.45, -0.15, 0.09000000000000001, 0.03]
    """

    rotation_factor: float
    y_factor: float
    z_factor: float
    mass_ratios: tuple[float, float]
    bearing_frequencies: tuple[float, float, float, float]
    contact: ContactRule = ContactRule.ALWAYS

    @cached_property
    def bearing_gains(self) -> NDArray[np.float64]:
        """Acceleration of Y_p, Z_p, Y_g, Z_g per unit of Φ, shape (4,)."""
        directions = np.array([-self.y_factor, -self.z_factor, self.y_factor, self.z_factor])
        return directions * np.repeat(self.mass_ratios, 2)

    @cached_property
    def bearing_directions(self) -> NDArray[np.float64]:
        """How Y_p, Z_p, Y_g, Z_g enter X, shape (4,)."""
        return np.array([self.y_factor, self.z_factor, -self.y_factor, -self.z_factor])


def family(pair: HelicalPair, defaults: Mapping[str, float], excitation: Excitation = NOTHING) -> Family:
    """The helical pair as a family of systems with ten states, `STATES`.

    Parameters
    ----------
    pair : HelicalPair
    defaults : mapping of str to float
        Parameter values by short name: those of `gears.spur.family`, and ``bearing_damping`` (all four ratios
        ξ) or ``bearing_damping_yp``, ``_zp``, ``_yg``, ``_zg``. Where the four differ there is no common
        ``bearing_damping`` to vary. ``rotation_factor`` is the pair's where nothing is given.
    excitation : Excitation
        Curves of stiffness and error and run-out of the shafts, beside the named harmonics.

    Returns
    -------
    Family

    Raises
    ------
    GearlashError
        For a name that is no parameter, or where ``omega``, ``D`` or ``load`` is missing.

    Examples
    --------
    >>> from gearlash.gears import HelicalPair, helical
    >>> pair = HelicalPair(0.8, 0.89, 0.29, (0.3, 0.05), (0.7, 0.6, 0.4, 0.3))
    >>> family = helical.family(pair, {"omega": 0.9, "D": 1.0, "load": 0.2, "ripple": 0.1})
    >>> family.system({"omega": 1.1}).omega, len(family.states)
    (1.1, 10)
    """
    damping = _damping_parameters(defaults)
    parameters = (
        *mesh_parameters(defaults),
        *excitation.parameters(defaults),
        *damping,
        rotation_parameter(defaults.get("rotation_factor", pair.rotation_factor)),
    )
    reject_unknown(defaults, (*parameters, Parameter("bearing_damping", 0.0)))
    orders = harmonic_count(defaults, "ripple"), harmonic_count(defaults, "error")
    h = np.zeros(10)
    h[8] = 1.0
    undamped = _undamped(pair)

    def build(values: Mapping[str, float]) -> System:
        driven = acceleration_forcing(values, orders[1], excitation)
        forcing = np.zeros((10, len(driven)))
        forcing[9] = driven
        g = _force_direction(pair, values["rotation_factor"])
        clearance = mesh_clearance(values, h, g, orders[0], pair.contact, excitation)
        rates = -2.0 * _bearing_damping(values, damping) * pair.bearing_frequencies
        matrix = _with_bearings(undamped, pair, SPEEDS, rates)
        return System(values["omega"], matrix, forcing, (clearance,), excitation.cycles)

    def cold_start(values: Mapping[str, float]) -> NDArray[np.float64]:
        start = np.zeros(10)
        start[8] = resting_displacement(values, values["rotation_factor"])
        return start

    return Family(parameters, STATES, build, cold_start)


def natural_frequencies(pair: HelicalPair, rotation_factor: float | None = None) -> NDArray[np.float64]:
    """Undamped natural frequencies with the mesh closed at its mean stiffness.

    Parameters
    ----------
    pair : HelicalPair
    rotation_factor : float, optional
        c_t²; the pair's where nothing is given.

    Returns
    -------
    ndarray, shape (5,)
        Over ω_n, ascending: of the symmetric problem in (Y_p, Z_p, Y_g, Z_g, u) with masses m_i/m_e and 1.

    Examples
    --------
    >>> from gearlash.gears import HelicalPair, helical
    >>> pair = HelicalPair(1.0, 0.0, 0.0, (0.3, 0.05), (0.7, 0.6, 0.4, 0.3))  # bearings apart from the mesh
    >>> helical.natural_frequencies(pair).round(12).tolist()
    [0.3, 0.4, 0.6, 0.7, 1.0]
    """
    roots = np.append(np.sqrt(np.repeat(pair.mass_ratios, 2)), 1.0)  # 1/√mass: makes the problem ordinary
    c_t = np.sqrt(pair.rotation_factor if rotation_factor is None else rotation_factor)
    mesh = np.append(pair.bearing_directions, c_t) * roots
    stiffness = np.diag(np.append(np.square(pair.bearing_frequencies), 0.0)) + np.outer(mesh, mesh)
    return np.sqrt(np.maximum(np.linalg.eigvalsh(stiffness), 0.0))  # rounding may go below zero


def readouts(
    pair: HelicalPair,
    defaults: Mapping[str, float],
    values: Mapping[str, float],
    excitation: Excitation = NOTHING,
) -> tuple[Readout, ...]:
    """Forces of the bearings, and the transmission error.

    A bearing force is that of all bearings of a shaft together in one direction, k_i y_i + c_i ẏ_i over
    k_m D_c; the transmission error what the rotation of both gears alone gives along the line of action,
    c_t (R_p θ_p − R_g θ_g)/D_c = X − c_y (Y_p − Y_g) − c_z (Z_p − Z_g) + E.

    Parameters
    ----------
    pair : HelicalPair
    defaults : mapping of str to float
        As `family` got them.
    values : mapping of str to float
        Every parameter of that family by short name.
    excitation : Excitation
        As `family` got it.

    Returns
    -------
    tuple of Readout
        ``bearing_force_yp``, ``_zp``, ``_yg``, ``_zg``, then ``transmission_error``.

    Examples
    --------
    >>> from gearlash.gears import HelicalPair, helical
    >>> pair = HelicalPair(1.0, 1.0, 0.0, (0.5, 0.1), (0.7, 0.6, 0.4, 0.3))
    >>> defaults = {"omega": 0.9, "D": 1.0, "load": 0.2, "bearing_damping": 0.1}
    >>> first, *_, last = helical.readouts(pair, defaults, helical.family(pair, defaults).complete())
    >>> first.row[:2].round(3).tolist(), last.row.tolist()
    ([0.98, 0.28], [-1.0, 0.0, -0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
    """
    kappa = np.asarray(pair.bearing_frequencies)
    ratios = _bearing_damping(values, _damping_parameters(defaults))
    masses = 1.0 / np.repeat(pair.mass_ratios, 2)  # over m_e
    found = []
    for i, (name, words) in enumerate(zip(BEARINGS, BEARING_WORDS, strict=True)):
        row = np.zeros(10)
        row[2 * i], row[2 * i + 1] = masses[i] * kappa[i] ** 2, masses[i] * 2.0 * ratios[i] * kappa[i]
        found.append(Readout(f"bearing_force_{name}", f"bearing force, {words}", "force", row))
    turned = np.zeros(10)
    turned[SPEEDS - 1], turned[8] = -pair.bearing_directions, 1.0
    error = excitation.error_series(values, series(values, "error", 0.0, harmonic_count(values, "error")))
    return (*found, Readout(*ERROR_READOUT, turned, error))


def _undamped(pair: HelicalPair) -> NDArray[np.float64]:
    """M without Φ and without bearing damping, shape (10, 10)."""
    matrix = np.zeros((10, 10))
    matrix[8, 9] = 1.0
    matrix[SPEEDS - 1, SPEEDS] = 1.0
    return _with_bearings(matrix, pair, SPEEDS - 1, -np.square(pair.bearing_frequencies))


def _with_bearings(
    matrix: NDArray[np.float64], pair: HelicalPair, columns: NDArray[np.intp], rates: NDArray[np.float64]
) -> NDArray[np.float64]:
    """A copy in which the bearing accelerations are these rates times these states; X feels them too."""
    result = matrix.copy()
    result[SPEEDS, columns] = rates
    result[9, columns] = pair.bearing_directions * rates
    return result


def _force_direction(pair: HelicalPair, rotation_factor: float) -> NDArray[np.float64]:
    """g: what one unit of Φ adds to z′, shape (10,)."""
    g = np.zeros(10)
    g[SPEEDS] = pair.bearing_gains
    g[9] = pair.bearing_directions @ pair.bearing_gains - rotation_factor
    return g


def _damping_parameters(defaults: Mapping[str, float]) -> tuple[Parameter, ...]:
    common = defaults.get("bearing_damping", 0.0)
    ratios = [defaults.get(f"bearing_damping_{b}", common) for b in BEARINGS]
    each = [
        Parameter(f"bearing_damping_{b}", ratio, f"damping ratio ξ of bearing direction {b}", 0.0)
        for b, ratio in zip(BEARINGS, ratios, strict=True)
    ]
    if len(set(ratios)) > 1:
        return tuple(each)
    common_one = Parameter(
        "bearing_damping", ratios[0], "damping ratio ξ of all four bearing directions", 0.0
    )
    return (common_one, *each)


def _bearing_damping(values: Mapping[str, float], parameters: tuple[Parameter, ...]) -> NDArray[np.float64]:
    """ξ of the four directions. The common ratio and a single one may not both leave their defaults."""
    default = {p.name: p.default for p in parameters}
    each = {name: values[name] for name in _EACH_DAMPING}
    moved = [name for name, value in each.items() if value != default[name]]
    common = values.get("bearing_damping", default.get("bearing_damping", 0.0))
    if common == default.get("bearing_damping", 0.0):
        return np.array(list(each.values()))
    if moved:
        raise GearlashError(
            f"bearing damping is named twice: bearing_damping = {common:g} and {moved[0]} = "
            f"{each[moved[0]]:g}; set the common ratio in the case, then vary one"
        )
    return np.full(4, common)
