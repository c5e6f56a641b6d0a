"""How the length of the contact lines varies over a mesh cycle: stiffness of unmodified flanks follows it.

A pair of teeth carries along a line whose length is a trapezoid over the roll, the convolution of two
rectangles of ε_α and ε_β mesh cycles; the sum over all pairs has the harmonics

    a_n / a_0 = 2 |sinc(n ε_α) sinc(n ε_β)|,   sinc(x) = sin(πx)/(πx).

As |sinc(2x)| ≤ |sinc(x)|, the second is never larger than the first. Source: Maatar & Velex, An analytical
expression for the time-varying contact length in perfect cylindrical gears, J. Mech. Des. 118
(1996)."""

from __future__ import annotations

import numpy as np

from .geometry import ToothGeometry


def ripple(geometry: ToothGeometry, face_width: float, order: int) -> float:
    """Amplitude of one harmonic of the length of the contact lines, over the mean length.

    Parameters
    ----------
    geometry : ToothGeometry
    face_width : float
        Common face width, m; above 0.
    order : int
        Harmonic of the mesh frequency, from 1.

    Returns
    -------
    float
        a_n / a_0, from 0 to 2.

    References
    ----------
    M. Maatar, P. Velex, J. Mech. Des. 118 (1996) 586.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import ToothGeometry, contact_lines
    >>> teeth = ToothGeometry((28, 70), 4e-3, radians(20), radians(18))
    >>> round(contact_lines.ripple(teeth, 0.065, 1), 4)
    0.0715
    """
    transverse, overlap = geometry.transverse_contact_ratio, geometry.overlap_ratio(face_width)
    return 2.0 * abs(float(np.sinc(order * transverse) * np.sinc(order * overlap)))
