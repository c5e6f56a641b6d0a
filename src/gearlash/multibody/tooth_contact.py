"""Real flanks as a contact of two bodies: the kernel of `contact`, called by an integrator."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ._tables import ContactTables
from .contact import contact_forces, new_memory

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ToothContact:
    """The contact of a pair's flanks.

    Parameters
    ----------
    tables : ContactTables
        Of a `MeshContact`.
    """

    tables: ContactTables

    @cached_property
    def _memory(self) -> Array:
        """Which slices pushed last: where the next call begins. It changes its time, not what it finds."""
        return new_memory(self.tables)

    def forces(self, t: float, q: Array, v: Array) -> Array:
        """Generalised forces on both bodies and the modes; NaN where they were not found.

        Parameters
        ----------
        t : float
            s; errors of real flanks turn with them and not with the time.
        q, v : ndarray, shape (size,)

        Returns
        -------
        ndarray, shape (size,)
        """
        out = np.empty_like(q)
        contact_forces(self.tables, q, v, out, np.empty(8), self._memory)
        return out

    def record(self, t: float, q: Array, v: Array) -> Array:
        """What is kept of a state, in the order of `RECORDED`.

        Parameters
        ----------
        t : float
            s.
        q, v : ndarray, shape (size,)

        Returns
        -------
        ndarray, shape (5,)
        """
        report = np.empty(8)
        contact_forces(self.tables, q, v, np.empty_like(q), report, self._memory)
        return np.array([report[0], report[1], report[4], report[5], 0.0])
