"""Harmonics of the length of the contact lines, against the lines themselves, added up."""

from __future__ import annotations

from math import radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import ToothGeometry
from gearlash.gears.mesh_cycle import MeshCycle, PairShape

ARTICLE = ToothGeometry((28, 70), 4e-3, radians(20), radians(18))


def ripple(pair: ToothGeometry, width: float, order: int) -> float:
    """Of equal stiffness per length."""
    cycle = MeshCycle(pair.transverse_contact_ratio, pair.overlap_ratio(width), PairShape.CONSTANT)
    return abs(float(cycle.harmonics(order)[-1]))


def summed(transverse: float, overlap: float, order: int) -> float:
    """From the trapezoids of all pairs at many phases of a cycle."""
    phase = (np.arange(4096) + 0.5) / 4096
    total = np.zeros_like(phase)
    for pair in range(-10, 11):
        x = phase + pair
        total += np.clip(
            np.minimum.reduce([x, np.full_like(x, min(transverse, overlap)), transverse + overlap - x]),
            0,
            None,
        )
    spectrum = np.fft.rfft(total)
    return float(2 * np.abs(spectrum[order]) / spectrum[0].real)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_against_the_lines_themselves(order: int):
    width = 65e-3
    ratios = ARTICLE.transverse_contact_ratio, ARTICLE.overlap_ratio(width)
    assert ripple(ARTICLE, width, order) == pytest.approx(summed(*ratios, order), abs=1e-6)


def test_the_article_pair_has_7_per_cent_and_less_than_1():
    first, second = (ripple(ARTICLE, 65e-3, n) for n in (1, 2))
    assert round(first, 3) == 0.071
    assert round(second, 4) == 0.0069


@given(st.floats(5e-3, 0.2), st.floats(5.0, 35.0))
def test_the_second_harmonic_is_never_the_larger(width: float, helix: float):
    pair = ToothGeometry((28, 70), 4e-3, radians(20), radians(helix))
    assert ripple(pair, width, 2) <= ripple(pair, width, 1) + 1e-15
