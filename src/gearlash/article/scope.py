"""How far and how finely the study looks."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Scope:
    """How far and how finely the study looks.

    Parameters
    ----------
    omega, backlash : (float, float, int)
        Lower end, upper end and number of points of the sweeps over ω and over D, both dimensionless.
    fixed_backlash : float
        D of everything but the sweep over D.
    fixed_omega : float
        ω of the sweep over D.
    rules_backlash : tuple of float
        Values of D at which the contact rules are compared, followed down.

    Examples
    --------
    >>> from gearlash.article import Scope
    >>> Scope(omega=(0.9, 1.2, 31)).backlash
    (0.1, 1.0, 361)
    """

    omega: tuple[float, float, int] = (0.5, 1.4, 451)
    backlash: tuple[float, float, int] = (0.1, 1.0, 361)
    fixed_backlash: float = 1.0
    fixed_omega: float = 0.78
    rules_backlash: tuple[float, ...] = (
        *(round(0.34 + 0.01 * i, 2) for i in range(17)),
        0.6,
        0.7,
        0.8,
        0.9,
        1.0,
    )

    @property
    def fixed(self) -> dict[str, float]:
        """ω and D where another parameter, or none, is scanned."""
        return {"omega": self.fixed_omega, "D": self.fixed_backlash}

    def limits(self, name: str) -> tuple[float, float, int]:
        """Lower end, upper end and number of points of the scan over ``omega`` or ``D``."""
        return {"omega": self.omega, "D": self.backlash}[name]

    def beside(self, name: str) -> dict[str, float]:
        """The value of the other one while this one is scanned."""
        return {other: value for other, value in self.fixed.items() if other != name}
