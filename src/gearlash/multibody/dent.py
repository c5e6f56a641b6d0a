"""What is taken out of the finite elements below a load, and the depth of a half-plane that puts it back.

A layer of depth h below the flank, held where it joins the rest of the tooth, gives under a line load P by

    u = 2 (1 − ν²) P/(π E) ∫ α(kh) 2 J_1(ka)/(ka) dk/k,
    α(s) = (2κ sinh 2s − 4s)/(2κ cosh 2s + 4s² + 1 + κ²),   κ = 3 − 4ν,

in the middle of a Hertzian contact of half width a ≪ h (K. L. Johnson, Contact Mechanics, 5.8). A
half-plane gives, relative to the depth t below the middle of the contact,

    u = 2 (1 − ν²) P/(π E) [ln(2t/a) − ν/(2(1 − ν))]      (Weber and Banaschek; Johnson, 5.6).

They are equal for all a at t = h exp(J − γ + 1/2 + ν/(2(1 − ν))), with J = ∫_0^1 α/s ds + ∫_1^∞ (α − 1)/s ds.
"""

from __future__ import annotations

from math import cosh, exp, sinh

import numpy as np
from scipy.integrate import quad


def half_plane_depth(layer: float, poisson_ratio: float) -> float:
    """Depth in a half-plane relative to which a contact gives as much as a held layer does.

    Parameters
    ----------
    layer : float
        h, depth of the layer, m; well above the half width of the contact.
    poisson_ratio : float
        ν, from 0 to below 1/2.

    Returns
    -------
    float
        t, m.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, 5.6 and 5.8,
    https://doi.org/10.1017/CBO9781139171731

    Examples
    --------
    >>> from gearlash.multibody.dent import half_plane_depth
    >>> round(half_plane_depth(1.0, 0.3), 3)
    1.206
    """
    kappa = 3.0 - 4.0 * poisson_ratio

    def soft(s: float) -> float:
        above = 2.0 * kappa * sinh(2.0 * s) - 4.0 * s
        return above / (2.0 * kappa * cosh(2.0 * s) + 4.0 * s * s + 1.0 + kappa**2)

    near = quad(lambda s: soft(s) / s, 0.0, 1.0)[0]
    far = quad(lambda s: (soft(s) - 1.0) / s, 1.0, 40.0)[0]
    shape = 0.5 * poisson_ratio / (1.0 - poisson_ratio)
    return layer * exp(near + far - float(np.euler_gamma) + 0.5 + shape)
