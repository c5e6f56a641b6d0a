"""What can be known about a pair without integrating it.

* `exact_linear`: one region, constant stiffness, by the matrix exponential (mpmath).
* `permanent_contact`: the periodic response inside S1 with time-varying stiffness, by harmonic balance.
* `floquet_multipliers`: of the same linear system, from Hill's truncated determinant.
* `grazing_load`: the load at which that response touches X = D⁺.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath as mp
import numpy as np
from scipy.optimize import brentq, minimize_scalar

from gearlash.system import System


def complex_harmonics(series, order: int) -> np.ndarray:
    """Complex coefficients, index −order…order (last axis), of a Fourier array."""
    series = np.atleast_1d(np.asarray(series, dtype=float))
    out = np.zeros((*series.shape[:-1], 2 * order + 1), dtype=complex)
    out[..., order] = series[..., 0]
    for n in range(1, (series.shape[-1] - 1) // 2 + 1):
        out[..., order + n] = (series[..., 2 * n - 1] - 1j * series[..., 2 * n]) / 2
        out[..., order - n] = np.conj(out[..., order + n])
    return out


def contact_system(system: System) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A(θ) = A0 + η⁺(θ) g hᵀ and the forcing inside S1: (A0, g hᵀ, forcing as Fourier rows)."""
    (clearance,) = system.clearances
    if np.any(clearance.offset):
        raise ValueError("permanent contact is written for systems without an offset")
    velocity = clearance.h @ system.matrix  # h·b adds to X′ only if h reads a forced state
    if np.any(clearance.h @ system.forcing):
        raise ValueError("the gap's velocity itself is forced")
    a0 = system.matrix + clearance.damping * np.outer(clearance.g, velocity)
    forcing = np.array(system.forcing)
    eta = clearance.stiffness_plus
    wide = max(forcing.shape[1], len(eta))
    forcing = np.pad(forcing, [(0, 0), (0, wide - forcing.shape[1])])
    forcing[:, : len(eta)] -= np.outer(clearance.g, eta) * clearance.gap_plus
    return a0, np.outer(clearance.g, clearance.h), forcing


def hill_matrix(system: System, order: int) -> np.ndarray:
    """Toeplitz blocks of A(θ) minus inω on the diagonal, for harmonics −order…order of e^{inθ}."""
    a0, coupling, _ = contact_system(system)
    n, count = system.size, 2 * order + 1
    eta = complex_harmonics(system.clearances[0].stiffness_plus, 2 * order)
    hill = np.zeros((count, n, count, n), dtype=complex)
    for row in range(count):
        for column in range(count):
            hill[row, :, column, :] = eta[row - column + 2 * order] * coupling
        hill[row, :, row, :] += a0 - 1j * (row - order) * system.omega * np.eye(n)
    return hill.reshape(count * n, count * n)


@dataclass(frozen=True)
class Response:
    """A periodic response as complex harmonics, shape (2·order + 1, n)."""

    coefficients: np.ndarray

    def __call__(self, theta):
        order = (len(self.coefficients) - 1) // 2
        n = np.arange(-order, order + 1)
        return np.real(np.exp(1j * np.multiply.outer(theta, n)) @ self.coefficients)


def permanent_contact(system: System, order: int = 60) -> Response:
    """The 2π-periodic response that never leaves S1 (whether or not it really stays there)."""
    _, _, forcing = contact_system(system)
    right = -complex_harmonics(forcing, order).T.reshape(-1)
    solution = np.linalg.solve(hill_matrix(system, order), right)
    return Response(solution.reshape(2 * order + 1, system.size))


def floquet_multipliers(system: System, order: int = 60) -> np.ndarray:
    """The n multipliers over one mesh cycle inside S1, by modulus, descending.

    Every exponent appears in Hill's spectrum shifted by all inω; the copies nearest the real axis are the
    accurate ones.
    """
    exponents: Any = np.linalg.eigvals(hill_matrix(system, order))
    multipliers = np.exp(2 * np.pi * exponents / system.omega)
    central = np.argsort(np.abs(exponents.imag), kind="stable")
    found: list[complex] = []
    for value in multipliers[central]:
        if all(abs(value - other) > 1e-7 * (1 + abs(value)) for other in found):
            found.append(value)
        if len(found) == system.size:
            break
    return np.array(sorted(found, key=lambda m: -abs(m)))


def lowest_gap(system: System, order: int = 60) -> tuple[float, float]:
    """min over θ of X of the permanent-contact response, and the θ where it is."""
    response, h = permanent_contact(system, order), system.clearances[0].h
    grid = np.linspace(0, 2 * np.pi, 721)
    coarse = response(grid) @ h
    at, step = grid[np.argmin(coarse)], grid[1]
    best = minimize_scalar(
        lambda t: response(np.array(t)) @ h,
        bounds=(at - step, at + step),
        method="bounded",
        options={"xatol": 1e-12},
    )
    return float(best.fun), float(best.x)


def grazing_parameter(build, lower: float, upper: float, order: int = 60) -> float:
    """The parameter in [lower, upper] where min X of the permanent contact of ``build(value)`` is D⁺."""

    def clearance(value: float) -> float:
        system = build(value)
        return lowest_gap(system, order)[0] - system.clearances[0].gap_plus

    return float(brentq(clearance, lower, upper, xtol=1e-15))  # pyright: ignore[reportArgumentType]


def spur_grazing_load(omega: float, error: float, damping: float) -> float:
    """Constant stiffness 1, E = error·cos θ: X − D = f_m + A cos(θ + …), so it touches at f_m = A."""
    return omega**2 * abs(error) / np.hypot(1 - omega**2, damping * omega)


def spur_grazing_omegas(load: float, error: float, damping: float) -> np.ndarray:
    """The speeds ω > 0 where that amplitude equals the load: roots of a quadratic in ω²."""
    roots = np.roots([load**2 - error**2, load**2 * (damping**2 - 2), load**2])
    return np.sort(np.sqrt(roots[(np.abs(roots.imag) < 1e-14) & (roots.real > 0)].real))


def exact_linear(matrix, forcing, omega, state, cycles, phase=0.0, digits: int = 40):
    """z after ``cycles`` mesh cycles of z′ = A z + b(θ), A constant, by the matrix exponential in mpmath."""
    with mp.workdps(digits):
        n, omega = len(matrix), mp.mpf(omega)
        a = mp.matrix([[mp.mpf(float(x)) for x in row] for row in matrix])
        t0 = 2 * mp.pi * mp.mpf(phase) / omega
        t1 = t0 + 2 * mp.pi * mp.mpf(cycles) / omega

        def steady(t):
            """Per harmonic (inω − A) c = b; the mean is −A⁻¹ b0."""
            z = mp.lu_solve(-a, mp.matrix([mp.mpf(float(f[0])) for f in forcing]))
            for k in range(1, (forcing.shape[1] - 1) // 2 + 1):
                b = mp.matrix([float(f[2 * k - 1]) - mp.j * float(f[2 * k]) for f in forcing])
                c = mp.lu_solve(mp.j * k * omega * mp.eye(n) - a, b)
                z += (c * mp.expj(k * omega * t)).apply(mp.re)
            return z

        start = mp.matrix([mp.mpf(float(x)) for x in state])
        end = mp.expm(a * (t1 - t0)) * (start - steady(t0)) + steady(t1)
        return np.array([float(x) for x in end])
