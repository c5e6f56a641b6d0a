"""The 1-DOF pair of Kahraman and Singh, whose loss of contact has a closed form."""

from __future__ import annotations

import math

from gearlash import case
from gearlash.studies import Axis

CLASSICAL = case.load("kahraman-singh")
SPEEDS = Axis.even("omega", 0.3, 1.6, 53)


def loss_of_contact() -> tuple[float, float]:
    """Frequencies at which x'' + 0.1 x' + x = 0.1 + 0.05 ω² cos ωτ just reaches x = 0: amplitude 0.1, that is
    (1 − w)² + 0.01 w = w²/4 in w = ω²."""
    a, b, c = 0.75, -1.99, 1.0
    root = math.sqrt(b * b - 4.0 * a * c)
    return math.sqrt((-b - root) / (2.0 * a)), math.sqrt((-b + root) / (2.0 * a))
