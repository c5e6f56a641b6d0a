"""Piecewise-linear systems integrated by heyoka's Taylor method in 80-bit arithmetic.

Time is counted in mesh cycles s; Fourier series have the phase 2πs/cycles. One integrator is compiled for one
*shape* (which coefficients exist); all numbers are its runtime parameters, so that hundreds of systems share
one compilation. The region enters as two parameters (drive side on, back side on) that events switch.
Rule ``always`` and one clearance only: the field is continuous there, so nothing but the region changes.

heyoka: Biscani, Izzo, MNRAS 504 (2021) 2614, doi:10.1093/mnras/stab1032.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import heyoka as hy
import numpy as np

from gearlash.system import System

Real = np.longdouble
TAU = 2 * Real("3.14159265358979323846264338327950288")


@dataclass(frozen=True)
class Run:
    """End state and, in order of occurrence, every crossing and (if asked for) every extremum of X."""

    state: np.ndarray
    jacobian: np.ndarray  # (n, n) with respect to the start, or (0, n)
    end: np.longdouble  # phase of ``state``
    phase: np.ndarray
    boundary: np.ndarray  # +1 at X = D⁺, -1 at X = -D⁻
    engaging: np.ndarray
    states: np.ndarray
    velocity: np.ndarray
    extremum_phase: np.ndarray
    extremum_state: np.ndarray
    extremum_curvature_sign: np.ndarray

    @property
    def contacts(self) -> list[int]:
        """Counts: engagements at + and −, releases at + and −."""
        return [self.crossings.count(kind) for kind in ((1, True), (-1, True), (1, False), (-1, False))]

    @property
    def crossings(self) -> list[tuple[int, bool]]:
        return [(int(b), bool(e)) for b, e in zip(self.boundary, self.engaging, strict=True)]


@dataclass
class Slots:
    """Runtime parameters: named blocks of the vector that heyoka calls ``par``."""

    size: int = 0
    blocks: dict[str, tuple[int, tuple[int, ...]]] = field(default_factory=dict)

    def block(self, name: str, shape: tuple[int, ...] = ()) -> np.ndarray:
        """Reserve a block; returns its parameters as an object array."""
        count = int(np.prod(shape))
        self.blocks[name] = (self.size, shape)
        out = np.array([hy.par[self.size + i] for i in range(count)], dtype=object).reshape(shape)
        self.size += count
        return out

    def write(self, pars: np.ndarray, name: str, values) -> None:
        start, shape = self.blocks[name]
        source = np.zeros(shape, dtype=Real)
        values = np.asarray(values, dtype=Real)
        source[tuple(slice(0, k) for k in values.shape)] = values
        pars[start : start + source.size] = source.ravel()


class _Record:
    """What the callbacks of one integration saw, and the region switch."""

    def __init__(self, slots: Slots, size: int):
        self._slots, self.size = slots, size
        self.start(forward=True)

    def __deepcopy__(self, memo) -> _Record:
        return self  # heyoka copies its callbacks; all copies must write here

    def start(self, forward: bool) -> None:
        self.forward, self.crossings, self.turns = forward, [], []

    def crossed(self, integrator, boundary: int, sign: int) -> bool:
        """Switch the region. ``sign`` is that of d/ds of the gap, s increasing."""
        outward = sign * boundary > 0
        start, _ = self._slots.blocks["plus" if boundary > 0 else "minus"]
        integrator.pars[start] = Real(outward == self.forward)
        time, last = Real(integrator.time), self.crossings[-1] if self.crossings else None
        # heyoka's cooldown is a guess from the size of its Taylor terms; sometimes it reports a root twice.
        again = last is not None and last[1:3] == (boundary, outward) and abs(time - last[0]) < 1e-14
        if not again:
            self.crossings.append((time, boundary, outward, integrator.state[: self.size].copy()))
        return True

    def turned(self, integrator, time, sign: int) -> None:
        integrator.update_d_output(time)
        self.turns.append((Real(time), sign, integrator.d_output[: self.size].copy()))


@dataclass
class _Crossing:
    record: _Record
    boundary: int

    def __call__(self, integrator, sign: int) -> bool:
        return self.record.crossed(integrator, self.boundary, sign)


@dataclass
class _Turning:
    record: _Record

    def __call__(self, integrator, time, sign: int) -> None:
        self.record.turned(integrator, time, sign)


def _sum(terms: list):
    return hy.sum(terms) if terms else hy.expression(0.0)


class Oracle:
    """Integrator for every system whose nonzero coefficients are among those of the ``examples``.

    ``harmonics`` bounds the order of all Fourier series. ``variational`` adds the derivative with respect to
    the start: with the rule ``always`` the field is continuous, so that runs through events unchanged.
    """

    def __init__(self, examples: list[System], harmonics: int = 3, variational: bool = False):
        self.size = examples[0].size
        self.harmonics = harmonics
        mask = {
            "matrix": np.any([s.matrix != 0 for s in examples], axis=0),
            "forcing": np.any([np.any(s.forcing != 0, axis=1) for s in examples], axis=0),
            "h": np.any([s.clearances[0].h != 0 for s in examples], axis=0),
            "g": np.any([s.clearances[0].g != 0 for s in examples], axis=0),
        }
        self._mask = mask
        self._has_offset = any(np.any(s.clearances[0].offset) for s in examples)
        self._slots = Slots()
        self._record = _Record(self._slots, self.size)
        self._variational = variational
        self._compile()

    def _compile(self) -> None:
        n, width, slots = self.size, 2 * self.harmonics + 1, self._slots
        states = np.array(hy.make_vars(*[f"z{i}" for i in range(n)]), dtype=object)
        scale, rate, turn = slots.block("scale"), slots.block("rate"), slots.block("turn")
        plus, minus = slots.block("plus"), slots.block("minus")
        gap_plus, gap_minus, damping = (
            slots.block("gap_plus"),
            slots.block("gap_minus"),
            slots.block("damping"),
        )
        matrix, forcing = slots.block("matrix", (n, n)), slots.block("forcing", (n, width))
        h, g = slots.block("h", (n,)), slots.block("g", (n,))
        eta_plus, eta_minus = slots.block("eta_plus", (width,)), slots.block("eta_minus", (width,))
        offset = slots.block("offset", (width,)) if self._has_offset else np.array([])

        basis = self._basis(turn.item())

        def fourier(coefficients):
            return _sum([c * b for c, b in zip(coefficients, basis, strict=True)])

        linear = [
            _sum([matrix[i, j] * states[j] for j in range(n) if self._mask["matrix"][i, j]])
            + (fourier(forcing[i]) if self._mask["forcing"][i] else 0.0)
            for i in range(n)
        ]
        gap = _sum([h[i] * states[i] for i in range(n) if self._mask["h"][i]])
        velocity = _sum([h[i] * linear[i] for i in range(n) if self._mask["h"][i]])
        if self._has_offset:
            slope = []
            for k in range(1, self.harmonics + 1):
                slope += [
                    -float(k) * offset[2 * k - 1] * basis[2 * k],
                    float(k) * offset[2 * k] * basis[2 * k - 1],
                ]
            gap, velocity = gap - fourier(offset), velocity - rate.item() * _sum(slope)
        above, below = gap - gap_plus.item(), gap + gap_minus.item()
        force = (
            plus.item() * fourier(eta_plus) * above
            + minus.item() * fourier(eta_minus) * below
            + damping.item() * velocity
        )
        rates = [scale.item() * (linear[i] + (g[i] * force if self._mask["g"][i] else 0.0)) for i in range(n)]
        events = [
            hy.t_event(above, callback=_Crossing(self._record, 1), fp_type=Real),
            hy.t_event(below, callback=_Crossing(self._record, -1), fp_type=Real),
        ]
        turning = [hy.nt_event(velocity, callback=_Turning(self._record), fp_type=Real)]
        equations: Any = list(zip(states, rates, strict=True))
        if self._variational:
            equations = hy.var_ode_sys(equations, hy.var_args.vars, order=1)
        self._integrator = hy.taylor_adaptive(
            equations,
            np.zeros(n + n * n * self._variational, dtype=Real),
            fp_type=Real,
            tol=Real(1e-20),
            pars=np.zeros(slots.size, dtype=Real),
            t_events=events,
            nt_events=turning,
            compact_mode=True,
        )

    def _basis(self, turn) -> list:
        basis = [hy.expression(1.0)]
        for k in range(1, self.harmonics + 1):
            angle = float(k) * turn * hy.time
            basis += [hy.cos(angle), hy.sin(angle)]
        return basis

    def load(self, system: System) -> None:
        """Put the numbers of a system into the integrator."""
        (clearance,) = system.clearances
        for name in self._mask:
            array = (
                system.matrix
                if name == "matrix"
                else (system.forcing if name == "forcing" else getattr(clearance, name))
            )
            array = array.any(axis=1) if name == "forcing" else array != 0
            if np.any(array & ~self._mask[name]):
                raise ValueError(f"{name} has a coefficient that the compiled shape lacks")
        if np.any(clearance.offset) and not self._has_offset:
            raise ValueError("offset present but the compiled shape has none")
        pars, write = self._integrator.pars, self._slots.write
        write(pars, "scale", TAU / Real(system.omega))  # dτ/ds
        write(pars, "rate", Real(system.omega) / system.cycles)  # of the phase of the series, per τ
        write(pars, "turn", TAU / system.cycles)  # the same per s
        write(pars, "gap_plus", clearance.gap_plus)
        write(pars, "gap_minus", clearance.gap_minus)
        write(pars, "damping", clearance.damping)
        write(pars, "matrix", system.matrix)
        write(pars, "forcing", system.forcing)
        write(pars, "h", clearance.h)
        write(pars, "g", clearance.g)
        write(pars, "eta_plus", clearance.stiffness_plus)
        write(pars, "eta_minus", clearance.stiffness_minus)
        if self._has_offset:
            write(pars, "offset", clearance.offset)

    def run(self, system: System, state, cycles: float, phase: float = 0.0) -> Run:
        """Integrate ``cycles`` mesh cycles (negative: backwards) from phase θ/2π = ``phase``.

        The gap must have some width: of two events at one instant heyoka reports one.
        """
        self.load(system)
        integrator = self._integrator
        self._record.start(forward=cycles >= 0)
        region = region_of(system, state, phase)
        self._slots.write(integrator.pars, "plus", region > 0)
        self._slots.write(integrator.pars, "minus", region < 0)
        integrator.time = Real(phase)
        integrator.state[: self.size] = np.asarray(state, dtype=Real)
        integrator.state[self.size :] = np.eye(self.size).ravel()[: integrator.state.size - self.size]
        integrator.reset_cooldowns()
        outcome = integrator.propagate_until(Real(phase) + Real(cycles), max_steps=1_000_000)[0]
        if outcome != hy.taylor_outcome.time_limit:
            raise RuntimeError(f"heyoka stopped early: {outcome}")
        result = self._result(system)
        check_walk(system, result, region, forward=cycles >= 0)
        return _at_stops(system, result)

    def _result(self, system: System) -> Run:
        crossings, turns, n = self._record.crossings, self._record.turns, self.size
        states = np.array([c[3] for c in crossings], dtype=Real).reshape(-1, n)
        phase = np.array([c[0] for c in crossings], dtype=Real)
        return Run(
            state=self._integrator.state[:n].copy(),
            jacobian=self._integrator.state[n:].reshape(-1, n).copy(),
            end=Real(self._integrator.time),
            phase=phase,
            boundary=np.array([c[1] for c in crossings], dtype=int),
            engaging=np.array([c[2] for c in crossings], dtype=bool),
            states=states,
            velocity=np.array(
                [gap_velocity(system, z, s) for z, s in zip(states, phase, strict=True)], dtype=Real
            ),
            extremum_phase=np.array([t[0] for t in turns], dtype=Real),
            extremum_state=np.array([t[2] for t in turns], dtype=Real).reshape(-1, n),
            extremum_curvature_sign=np.array([t[1] for t in turns], dtype=int),
        )


def _at_stops(system: System, run: Run) -> Run:
    """Without what crosses the edge of a side that has no stiffness: nothing is hit there."""
    real = np.array([system.clearances[0].stops(b) for b in run.boundary], dtype=bool)
    names = ("phase", "boundary", "engaging", "states", "velocity")
    return replace(run, **{name: getattr(run, name)[real] for name in names})


def check_walk(system: System, run: Run, region: int, forward: bool) -> None:
    """Raise if the crossings are not a possible walk through the regions, or if an extremum lies in another
    region than the walk has it: between neighbouring extrema X is monotone, so no pair of roots can hide.
    """
    visits = [region]
    for boundary, engaging in run.crossings:
        into_contact = engaging == forward
        if visits[-1] != (0 if into_contact else boundary):
            raise RuntimeError(f"impossible walk: crossing {boundary, engaging} from region {visits[-1]}")
        visits.append(boundary if into_contact else 0)
    order = 1 if forward else -1
    places = list(zip(run.extremum_phase, run.extremum_state, strict=True))
    for phase, state in places:
        walk = visits[int(np.searchsorted(order * run.phase, order * phase))]
        x, clearance = gap(system, state, phase), system.clearances[0]
        near = min(abs(x - clearance.gap_plus), abs(x + clearance.gap_minus)) < 1e-16 * (1 + abs(x))
        if not near and region_of(system, state, phase) != walk:
            raise RuntimeError(f"a pair of crossings was missed at phase {phase}, X = {x}")


def fourier(coefficients, angle) -> Any:
    """Value of a Fourier array (last axis) at ``angle`` in rad, in 80-bit arithmetic."""
    c = np.asarray(coefficients, dtype=Real)
    multiple = Real(angle) * np.arange(1, (c.shape[-1] - 1) // 2 + 1)
    return c[..., 0] + c[..., 1::2] @ np.cos(multiple) + c[..., 2::2] @ np.sin(multiple)


def _slope(coefficients, angle) -> Any:
    c = np.asarray(coefficients, dtype=Real)
    order = np.arange(1, (len(c) - 1) // 2 + 1)
    return order * c[2::2] @ np.cos(angle * order) - order * c[1::2] @ np.sin(angle * order)


def angle(system: System, phase) -> Any:
    """The phase of the series at mesh phase ``phase`` (cycles), in rad."""
    return TAU * Real(phase) / system.cycles


def gap(system: System, state, phase) -> Any:
    """X = h·z − e(θ)."""
    c = system.clearances[0]
    return c.h.astype(Real) @ np.asarray(state, dtype=Real) - fourier(c.offset, angle(system, phase))


def gap_velocity(system: System, state, phase) -> Any:
    """X′ = h·(M z + b) − e′."""
    c, at = system.clearances[0], angle(system, phase)
    drift = system.matrix.astype(Real) @ np.asarray(state, dtype=Real) + fourier(system.forcing, at)
    return c.h.astype(Real) @ drift - Real(system.omega) / system.cycles * _slope(c.offset, at)


def region_of(system: System, state, phase) -> int:
    """+1 in S1, 0 in the gap, −1 in S3."""
    x, clearance = gap(system, state, phase), system.clearances[0]
    return int(x > clearance.gap_plus) - int(x < -clearance.gap_minus)
