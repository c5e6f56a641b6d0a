"""The periodic orbit near a state: the one way in which orbits are made outside the search for attractors."""

from __future__ import annotations

from numpy.typing import ArrayLike

from gearlash.flow import Propagators, propagators_of
from gearlash.system import System, given

from .results import Orbit
from .shooting import SHOOTING_ITERATIONS, TOLERANCE, minimal, shoot


def orbit_at(
    system: System | Propagators,
    start: ArrayLike,
    period: int,
    *,
    iterations: int = SHOOTING_ITERATIONS,
    least: bool = False,
) -> Orbit | None:
    """The periodic orbit near a state, stable or not.

    Parameters
    ----------
    system : System or Propagators
    start : array_like of shape (n,)
        At phase zero, near the orbit.
    period : int
        Base periods after which it closes; 1 or more.
    iterations : int
        Of Newton's method, at the most.
    least : bool
        Whether an orbit that closes after a part of the period is given with that part.

    Returns
    -------
    Orbit or None
        Its residual is at most 1e-11; None where Newton's method does not come so far. Its status is ok, or
        uncertain where a contact on it could not be decided.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.orbit_at(family.system({"omega": 0.8}), [1.08, 0.07], 1)
    >>> str(orbit.label), orbit.stable
    ('1-0-0', True)
    """
    props, least = propagators_of(system), given.truth("least", least)
    shot = shoot(props, start, period, iterations=iterations)
    if not shot.residual <= TOLERANCE:
        return None
    shot = minimal(props, shot) if least else shot
    return Orbit(props, shot, 0, shot.status, "")
