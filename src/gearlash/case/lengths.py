"""Lengths and backlashes from dimensionless numbers and back: what `Scales` inherits."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gearlash.system import given

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Values: TypeAlias = NDArray[np.float64]


class Lengths:
    """Conversions with the unit of length, and with the gap of the back side over that of the drive side."""

    back_gap: float

    def _known(self, name: str) -> float:
        """A unit of the case by its name. Raises `GearlashError` where the case has none."""
        raise NotImplementedError

    def length_m(self, displacement: ArrayLike) -> Values:
        """Length of a dimensionless displacement or error amplitude.

        Parameters
        ----------
        displacement : array_like
            Dimensionless.

        Returns
        -------
        ndarray
            m.
        """
        return given.reals("displacement", displacement) * self._known("length")

    def displacement_from_m(self, metres: ArrayLike) -> Values:
        """Dimensionless displacement of a length.

        Parameters
        ----------
        metres : array_like
            m.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return given.reals("metres", metres) / self._known("length")

    def length_um(self, displacement: ArrayLike) -> Values:
        """Length in micrometres of a dimensionless displacement or error amplitude.

        Parameters
        ----------
        displacement : array_like
            Dimensionless.

        Returns
        -------
        ndarray
            µm.
        """
        return self.length_m(displacement) * 1e6

    def displacement_from_um(self, micrometres: ArrayLike) -> Values:
        """Dimensionless displacement of a length in micrometres.

        Parameters
        ----------
        micrometres : array_like
            µm.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return self.displacement_from_m(given.reals("micrometres", micrometres) / 1e6)

    def backlash_m(self, half_backlash: ArrayLike) -> Values:
        """Whole backlash b, both sides of the gap: D + D⁻.

        Parameters
        ----------
        half_backlash : array_like
            D, dimensionless.

        Returns
        -------
        ndarray
            m.
        """
        return self.length_m(half_backlash) * (1.0 + self.back_gap)

    def half_backlash_from_m(self, backlash: ArrayLike) -> Values:
        """Half-backlash D of a whole backlash.

        Parameters
        ----------
        backlash : array_like
            b, m.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return self.displacement_from_m(given.reals("backlash", backlash) / (1.0 + self.back_gap))

    def backlash_um(self, half_backlash: ArrayLike) -> Values:
        """Whole backlash b in micrometres.

        Parameters
        ----------
        half_backlash : array_like
            D, dimensionless.

        Returns
        -------
        ndarray
            µm.
        """
        return self.backlash_m(half_backlash) * 1e6

    def half_backlash_from_um(self, backlash: ArrayLike) -> Values:
        """Half-backlash D of a whole backlash in micrometres.

        Parameters
        ----------
        backlash : array_like
            b, µm.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return self.half_backlash_from_m(given.reals("backlash", backlash) / 1e6)
