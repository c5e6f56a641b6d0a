"""A bilinear oscillator in closed form: where its motion with one contact a period folds, doubles or touches.

    x″ + c₁ x′ + k₁ x = p + q cos ωτ              below x = d
    x″ + c₂ x′ + k₁ x + k (x - d) = p + q cos ωτ   beyond it

On either side the motion is a sum of exponentials and one cosine. So an orbit that is beyond d once a period
is a root of five equations in where it enters and leaves, and its monodromy M a product of two exponentials
of matrices: a multiplier is μ = ±1 where μ² - μ tr M + det M = 0. The damping may jump at d: x′ does not.
All with mpmath, to as many digits as are asked for. S. W. Shaw, P. J. Holmes, J. Sound Vib. 90 (1983) 129,
doi:10.1016/0022-460X(83)90407-8.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import mpmath

DIGITS = 30
mp: Any = mpmath.mp
mpf: Any = mpmath.mpf


@dataclass(frozen=True)
class Bilinear:
    """All numbers of it; ``period``: in periods of the excitation."""

    omega: Any
    edge: Any
    stiffness: Any  # k₁
    stop: Any  # k
    damping: Any  # c₁
    damping_beyond: Any  # c₂
    mean: Any
    force: Any
    period: int = 1

    @property
    def duration(self) -> Any:
        return self.period * 2 * mp.pi / mpf(self.omega)

    def carried(self, beyond: bool, begin, span, x, v) -> tuple[Any, Any, Any]:
        """(x, x′) after ``span`` from the time ``begin`` within one side, and the matrix that carries
        differences."""
        k = mpf(self.stiffness) + (mpf(self.stop) if beyond else 0)
        c = mpf(self.damping_beyond) if beyond else mpf(self.damping)
        push = mpf(self.mean) + (mpf(self.stop) * mpf(self.edge) if beyond else 0)
        matrix = _exponential(k, c, span)
        w = mpf(self.omega)
        steady = mpf(self.force) / mp.mpc(k - w**2, c * w)

        def particular(time):
            turn, since = steady * mp.exp(mp.mpc(0, w * time)), time - begin
            place, speed = _pushed(push, k, c, since)
            return place + turn.real, speed + (mp.mpc(0, w) * turn).real

        before, after = particular(begin), particular(begin + span)
        free = matrix * mp.matrix([x - before[0], v - before[1]])
        return free[0] + after[0], free[1] + after[1], matrix


def _pushed(push, k, c, since) -> tuple[Any, Any]:
    """A motion under a constant force: at rest, drifting, or falling."""
    if k != 0:
        return push / k, mpf(0)
    if c != 0:
        return push / c * since, push / c
    return push * since**2 / 2, push * since


def _exponential(k, c, span) -> Any:
    """Of [[0, 1], [-k, -c]] times ``span``."""
    half, root = c / 2, mp.sqrt(mp.mpc(c**2 / 4 - k))
    decay, size = mp.exp(-half * span), mp.cosh(root * span)
    across = span if root == 0 else mp.sinh(root * span) / root
    entries = [[size + half * across, across], [-k * across, size - half * across]]
    return decay * mp.matrix([[mp.re(value) for value in row] for row in entries])


def _around(model: Bilinear, enter, contact, v_in, v_out) -> tuple[list, Any, Any]:
    """What does not close, trace and determinant of the monodromy, of the motion that enters at a time and
    stays beyond for another."""
    d = mpf(model.edge)
    x1, v1, inside = model.carried(True, enter, contact, d, v_in)
    x2, v2, outside = model.carried(False, enter + contact, model.duration - contact, d, v_out)
    jump = mpf(model.damping_beyond) - mpf(model.damping)
    into, out = mp.matrix([[1, 0], [-jump, 1]]), mp.matrix([[1, 0], [jump, 1]])
    whole = outside * out * inside * into
    return [x1 - d, v1 - v_out, x2 - d, v2 - v_in], whole[0, 0] + whole[1, 1], mp.det(whole)


def multiplier_at(build: Callable[[Any], Bilinear], mu: int, guess: tuple) -> tuple[Any, list]:
    """Parameter at which a multiplier of the orbit with one contact is ``mu``. ``guess``: parameter, time it
    enters, time it stays, velocities there. Returns the parameter and what else was solved for."""

    def equations(parameter, enter, contact, v_in, v_out):
        defect, trace, determinant = _around(build(parameter), enter, contact, v_in, v_out)
        return [*defect, 1 - mu * trace + determinant]

    with mp.workdps(DIGITS):
        root = mp.findroot(equations, [mpf(value) for value in guess])
        return root[0], list(root[1:])


def touching_values(model: Callable[[Any], Bilinear], guess: float, beyond: bool) -> Any:
    """Parameter within 0.1 % of ``guess`` at which the motion on one side alone comes to x = d: there the
    amplitude of its cosine is the distance."""

    def distance(parameter):
        at = model(parameter)
        k = mpf(at.stiffness) + (mpf(at.stop) if beyond else 0)
        c = mpf(at.damping_beyond) if beyond else mpf(at.damping)
        push = mpf(at.mean) + (mpf(at.stop) * mpf(at.edge) if beyond else 0)
        amplitude = abs(mpf(at.force) / mp.mpc(k - mpf(at.omega) ** 2, c * mpf(at.omega)))
        return amplitude - abs(push / k - mpf(at.edge))

    with mp.workdps(DIGITS):
        return mp.findroot(distance, (mpf(guess) * 0.999, mpf(guess) * 1.001), solver="anderson")
