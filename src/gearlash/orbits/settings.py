"""How an attractor is looked for."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import Record, given

MOST_PERIODS = 1_000_000_000  # base periods


@dataclass(frozen=True, repr=False)
class Settings(Record):
    """How an attractor is looked for, and for how long.

    Parameters
    ----------
    max_period : int
        Base periods up to which periodic orbits are looked for; 1 or more.
    budget : int
        Base periods that the motion is followed at the most, transient, averages and all; 1 or more. What
        Newton's method carries to close an orbit is not the motion, and does not count.
    patience : int
        Base periods before which no motion is called aperiodic; 0 or more.
    exponent_periods : int
        Base periods over which an exponent is averaged at the least before the motion is called
        quasi-periodic; 1 or more.
    precision : float
        A motion is called chaotic where its exponent stands above zero by 1/``precision`` of its error bar,
        and for long enough; above 0. Where neither is settled, it is asked again after half as long again.

    Raises
    ------
    GearlashError
        For numbers out of these ranges.

    Examples
    --------
    >>> import gearlash as gl
    >>> settings = gl.Settings(max_period=128, budget=50_000)
    >>> str(gl.point(gl.load_case("kahraman-singh"), settings=settings).label)
    '1-0-0'
    """

    max_period: int = 64
    budget: int = 20_000
    patience: int = 1_000
    exponent_periods: int = 1_000
    precision: float = 1.0 / 3.0

    def __post_init__(self) -> None:
        for name, least in (("max_period", 1), ("budget", 1), ("patience", 0), ("exponent_periods", 1)):
            object.__setattr__(
                self, name, given.whole(f"Settings.{name}", getattr(self, name), least, MOST_PERIODS)
            )
        object.__setattr__(self, "precision", given.positive("Settings.precision", self.precision))
