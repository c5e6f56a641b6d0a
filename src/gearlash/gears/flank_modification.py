"""Material taken off the flanks on purpose: relief of tips and roots, profile and lead crowning.

Amounts and roll lengths as on drawings (ISO 21771-1): C_αa at the tip, C_αf at the root, C_α of profile and
C_β of lead crowning lie in the transverse plane along the line of action; along the normal of the flanks
they are cos β_b as large. What both gears lack of their involutes adds up to the gap between flanks that
would touch.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from math import cos

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .cylindrical_pair import CylindricalPair

Reals = NDArray[np.float64]


class ReliefForm(StrEnum):
    """How relief grows from where it begins: with the roll length (``LINEAR``), or with its square."""

    LINEAR = "linear"
    PARABOLIC = "parabolic"


@dataclass(frozen=True)
class Relief:
    """Relief of a tip or a root.

    Parameters
    ----------
    amount : float
        C_αa at the tip form diameter, or C_αf where contact reaches lowest, m; at least 0.
    length : float
        L_C: roll length over which it grows, m; above 0.
    """

    amount: float
    length: float


@dataclass(frozen=True)
class FlankModification:
    """What the flanks of one gear lack.

    Parameters
    ----------
    tip, root : Relief, optional
    profile_crowning : float
        C_α, m: at both ends of the path of contact, none in its middle.
    crowning : float
        C_β, m: at both ends of the face width, none in its middle.

    Examples
    --------
    >>> from gearlash.gears.flank_modification import FlankModification, Relief
    >>> FlankModification().modified, FlankModification(tip=Relief(20e-6, 2e-3)).modified
    (False, True)
    """

    tip: Relief | None = None
    root: Relief | None = None
    profile_crowning: float = 0.0
    crowning: float = 0.0

    @property
    def modified(self) -> bool:
        """Is anything taken off?"""
        reliefs = any(each is not None and each.amount > 0.0 for each in (self.tip, self.root))
        return reliefs or self.profile_crowning > 0.0 or self.crowning > 0.0


UNMODIFIED = FlankModification()


@dataclass(frozen=True)
class PairModification:
    """What both gears of a pair lack of their flanks.

    Parameters
    ----------
    pinion, gear : FlankModification
    form : ReliefForm
        Of all reliefs.
    """

    pinion: FlankModification = UNMODIFIED
    gear: FlankModification = UNMODIFIED
    form: ReliefForm = ReliefForm.LINEAR

    @property
    def modified(self) -> bool:
        """Is anything taken off either gear?"""
        return self.pinion.modified or self.gear.modified

    @property
    def crowning(self) -> float:
        """C_β of both, m."""
        return self.pinion.crowning + self.gear.crowning

    def gap(self, pair: CylindricalPair, place: ArrayLike, across: ArrayLike = 0.0) -> Reals:
        """Gap between flanks whose involutes would touch.

        Parameters
        ----------
        pair : CylindricalPair
        place : array_like
            Distances from T1 along the line of action, m.
        across : array_like
            From −½ to ½ across the face width.

        Returns
        -------
        ndarray
            Along the normal of the flanks, m; at least 0.

        Examples
        --------
        >>> from gearlash.gears import CylindricalGear, CylindricalPair
        >>> from gearlash.gears.flank_modification import FlankModification, PairModification, Relief
        >>> pair = CylindricalPair(CylindricalGear(30, 4e-3), CylindricalGear(60, 4e-3))
        >>> relieved = PairModification(FlankModification(tip=Relief(20e-6, 5e-3)))
        >>> start, end = pair.path_of_contact
        >>> (relieved.gap(pair, [start, end - 2.5e-3, end]) * 1e6).round(6).tolist()
        [0.0, 10.0, 20.0]
        """
        s = np.asarray(place, dtype=float)
        start, end = pair.path_of_contact
        whole, grown = pair.tangent_length, self._grown
        tips = [gear.roll_length(gear.tip_form_diameter) for gear in pair.gears]
        found = np.zeros_like(s)
        for one, roll, tip, lowest in (
            (self.pinion, s, tips[0], start),
            (self.gear, whole - s, tips[1], whole - end),
        ):
            if one.tip is not None:
                found = found + grown(one.tip, roll - (tip - one.tip.length))
            if one.root is not None:
                found = found + grown(one.root, lowest + one.root.length - roll)
        middle, half = 0.5 * (start + end), 0.5 * (end - start)
        profile = self.pinion.profile_crowning + self.gear.profile_crowning
        if profile > 0.0 and half > 0.0:
            found = found + profile * ((s - middle) / half) ** 2
        found = found + self.crowning * (2.0 * np.asarray(across, dtype=float)) ** 2
        return found * cos(pair.pinion.base_helix_angle)

    @property
    def _grown(self) -> Callable[[Relief, Reals], Reals]:
        def linear(relief: Relief, beyond: Reals) -> Reals:
            return relief.amount / relief.length * np.maximum(beyond, 0.0)

        def parabolic(relief: Relief, beyond: Reals) -> Reals:
            return relief.amount * np.square(np.maximum(beyond, 0.0) / relief.length)

        return linear if self.form is ReliefForm.LINEAR else parabolic
