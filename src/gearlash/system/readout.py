"""What is read of a motion beside the contact itself: a bearing force, a transmission error."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from .harmonics import Fourier, constant


@dataclass(frozen=True, eq=False)
class Readout:
    """A number that follows from the state and the phase: row · z + offset(θ).

    Parameters
    ----------
    name : str
        One of a kind, as in a file.
    words : str
        What it is.
    quantity : {"force", "length"}
        What its unit is: that of contact forces, or that of X.
    row : ndarray of shape (n,)
    offset : ndarray
        Fourier series of the phase of a base period; zero without.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.system.readout import Readout
    >>> Readout("bearing", "force of the bearing", "force", np.array([4.0, 0.1])).offset.tolist()
    [0.0]
    """

    name: str
    words: str
    quantity: Literal["force", "length"]
    row: NDArray[np.float64]
    offset: Fourier = field(default_factory=lambda: constant(0.0))
