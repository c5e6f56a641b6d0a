"""Stiffness over the mesh cycle: closed forms against sums of slices, quadrature and the literature."""

from __future__ import annotations

from math import cos, pi, radians

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.integrate import quad

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.mesh_cycle import MeshCycle, ripple_ranges
from gearlash.gears.pair_shape import PairShape
from gearlash.system import GearlashError

cycles = st.builds(
    MeshCycle,
    transverse_contact_ratio=st.floats(1.0, 2.5),
    overlap_ratio=st.one_of(st.just(0.0), st.floats(0.01, 3.0)),
    shape=st.sampled_from(PairShape),
)
SHAPES = pytest.mark.parametrize("shape", PairShape)


@SHAPES
@pytest.mark.parametrize("frequency", [0.0, 1e-6, 0.29, 0.31, 2.0, 7.5, 40.0])
def test_transforms_of_the_shapes_against_quadrature(shape, frequency):
    exact = quad(
        lambda u: float(shape.at(u, 1.6)) * cos(2 * frequency * u), -0.5, 0.5, epsabs=1e-13, limit=200
    )[0]
    assert float(shape.transform(frequency, 1.6)) == pytest.approx(exact, abs=1e-12)


@SHAPES
def test_integrals_of_the_shapes_against_quadrature(shape):
    for place in (-0.7, -0.5, -0.2, 0.3, 0.5, 0.9):
        exact = quad(lambda u: float(shape.at(u, 1.3)), -0.5, min(place, 0.5))[0] if place > -0.5 else 0.0
        assert float(shape.integral(place, 1.3)) == pytest.approx(exact, abs=1e-12)


def test_the_second_moment_continues_over_the_end_of_its_series():
    shape = PairShape.PARABOLA
    below, above = shape.transform(0.3 - 1e-9, 1.6), shape.transform(0.3 + 1e-9, 1.6)
    assert float(above - below) == pytest.approx(0.0, abs=2e-9)


@given(cycles)
def test_a_pair_is_the_mean_of_its_slices(cycle):
    phase = np.linspace(-0.2, cycle.total_contact_ratio + 0.2, 37)
    if cycle.overlap_ratio == 0.0:
        slices = np.array([0.0])
    else:
        slices = (np.arange(4000) + 0.5) / 4000 * cycle.overlap_ratio
    ratio = cycle.transverse_contact_ratio
    places = (phase[:, None] - slices) / ratio - 0.5
    summed = cycle.shape.at(places, ratio).mean(axis=1)
    assert cycle.pair_stiffness(phase) == pytest.approx(summed, abs=4e-4)


@given(cycles)
def test_harmonics_against_the_spectrum_of_the_cycle_itself(cycle):
    count = 5
    points = 8192
    phase = (np.arange(points) + 0.5) / points
    spectrum = np.fft.rfft(cycle.stiffness(phase)) / points
    orders = np.arange(1, count + 1)
    turned = 2 * spectrum[1 : count + 1] * np.exp(1j * pi * orders * (cycle.total_contact_ratio - 1 / points))
    assert spectrum[0].real == pytest.approx(1.0, abs=3e-4)
    assert turned.real == pytest.approx(cycle.harmonics(count), abs=1.5e-3)
    assert turned.imag == pytest.approx(0.0, abs=1.5e-3)


@given(st.floats(1.0, 2.5), st.floats(0.0, 3.0))
def test_equal_stiffness_per_length_has_the_ratio_of_maatar_and_velex(transverse, overlap):
    first, second = MeshCycle(transverse, overlap, PairShape.CONSTANT).harmonics(2)
    assume(abs(first) > 1e-3)
    assert second / first == pytest.approx(cos(pi * transverse) * cos(pi * overlap), abs=1e-9)


@given(cycles)
def test_the_shares_of_all_pairs_are_the_load(cycle):
    shares = cycle.load_shares(np.linspace(0.0, 1.0, 41))
    assert shares.sum(axis=0) == pytest.approx(1.0, abs=1e-12)
    assert np.all(shares >= 0.0)


def test_a_spur_mesh_has_two_pairs_and_then_one():
    cycle = MeshCycle(1.6)
    shares = cycle.load_shares([0.3, 0.599, 0.601, 0.9])
    assert (np.count_nonzero(shares, axis=0) == [2, 2, 1, 1]).all()
    assert shares.max(axis=0)[2:].tolist() == [1.0, 1.0]
    # At 0.3 both pairs stand equally far from the middle of their paths, 0.8: each carries half.
    assert shares[:2, 0].tolist() == pytest.approx([0.5, 0.5])


def test_a_pair_that_comes_in_carries_about_a_third():
    # Measured and calculated shares of spur pairs at first contact are about 1/3 (ISO/TS 6336-20 and 6336-3
    # practice).
    for shape in (PairShape.PARABOLA, PairShape.COSINE):
        for ratio in (1.4, 1.6, 1.8):
            assert MeshCycle(ratio, 0.0, shape).load_shares([0.0])[0, 0] == pytest.approx(1 / 3, abs=0.06)


@given(st.floats(1.25, 2.0))
def test_published_means_agree(ratio):
    # c_γα/c′ of ISO 6336-1 is 0.75 ε_α + 0.25; that of the shapes must be near it, made by others from other
    # data.
    iso = 0.75 * ratio + 0.25
    assert MeshCycle(ratio).mean == pytest.approx(iso, rel=0.12)
    if ratio >= 1.35:  # the cosine is narrower where ε_α is small
        assert MeshCycle(ratio, 0.0, PairShape.COSINE).mean == pytest.approx(iso, rel=0.12)


@given(cycles, st.integers(1, 3))
def test_a_whole_overlap_has_no_ripple(cycle, whole):
    flat = MeshCycle(cycle.transverse_contact_ratio, float(whole), cycle.shape)
    assert flat.harmonics(6) == pytest.approx(0.0, abs=1e-12)
    assert flat.stiffness(np.linspace(0, 1, 21)) == pytest.approx(1.0, abs=1e-12)
    assert flat.left_out(0) < 1e-12


def test_a_rectangle_of_contact_ratio_1_6():
    cycle = MeshCycle(1.6, 0.0, PairShape.CONSTANT)
    assert cycle.stiffness([0.3, 0.8]) == pytest.approx([2 / 1.6, 1 / 1.6])
    # Fourier integral of the two steps, ends of the high one at 0 and 0.6, phase from 0.8 on.
    exact = [(np.sin(-0.4 * pi * n) + np.sin(1.6 * pi * n)) / (1.6 * pi * n) for n in (1, 2, 3)]
    assert cycle.harmonics(3) == pytest.approx(exact, abs=1e-14)
    variance = 0.6 * (2 / 1.6 - 1) ** 2 + 0.4 * (1 - 1 / 1.6) ** 2
    assert cycle.left_out(0) == pytest.approx(variance**0.5, rel=2e-3)


def test_more_harmonics_leave_less_out():
    cycle = MeshCycle(1.6)
    rest = [cycle.left_out(n) for n in (0, 1, 2, 4, 8, 16, 32)]
    assert rest == sorted(rest, reverse=True)
    # Parseval: what the first leaves out is the variance less half its square.
    assert rest[1] ** 2 == pytest.approx(rest[0] ** 2 - cycle.harmonics(1)[0] ** 2 / 2, abs=1e-4)


def test_a_small_overlap_is_nearly_a_spur_mesh():
    assert MeshCycle(1.6, 1e-6).harmonics(4) == pytest.approx(MeshCycle(1.6).harmonics(4), abs=1e-9)


def test_the_range_of_a_harmonic_holds_every_shape():
    pair = CylindricalPair(
        CylindricalGear(25, 2e-3, radians(10)), CylindricalGear(57, 2e-3, radians(10)), None, 0.02
    )
    least, greatest = ripple_ranges(pair, 4)
    for shape in PairShape:
        one = MeshCycle.of_pair(pair, shape).harmonics(4)
        assert (least <= one).all()
        assert (one <= greatest).all()


@pytest.mark.parametrize("ratios", [(0.0, 1.0), (1.5, -0.1)])
def test_teeth_that_do_not_mesh_have_no_cycle(ratios):
    with pytest.raises(GearlashError, match="ε_α above 0"):
        MeshCycle(*ratios)
