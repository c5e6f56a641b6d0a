"""Compliance of flanks: symmetric, the same for finer meshes, and as stiff as the theory of ISO 6336-1."""

from __future__ import annotations

from math import log, pi, radians, sqrt

import numpy as np
import pytest

from gearlash.gears import CylindricalGear, CylindricalPair, mesh_stiffness
from gearlash.gears.materials import named
from gearlash.multibody.compliance import (
    FlankCompliance,
    SectorSettings,
    flank_compliance,
    pair_compliances,
)
from gearlash.multibody.tooth_section import Fineness

STEEL = named("steel")
COARSE = Fineness(flank=6, fillet=1, core=1, rim=2, axial=3)


def single_stiffness(
    pair: CylindricalPair, flanks: tuple[FlankCompliance, ...], place: float, line_load: float
):
    """N/m² of one pair of spur teeth that touch all along the face at one place of the path: the bulk of both
    teeth, and Hertz's approach down to the depth that the finite elements left out."""
    plane = (1.0 - STEEL.poisson_ratio**2) / STEEL.youngs_modulus
    relative = place * (pair.tangent_length - place) / pair.tangent_length
    half = sqrt(4.0 * line_load / pi * relative * 2.0 * plane)
    total, width = 0.0, pair.face_width
    for flank, roll in zip(flanks, (place, pair.tangent_length - place), strict=True):
        nr, nz = len(flank.roll), len(flank.axial)
        same = flank.influence[len(flank.influence) // 2].reshape(nr, nz, nr, nz)
        row = np.interp(roll, flank.roll, np.arange(nr))
        low = min(int(row), nr - 2)
        weights = np.zeros(nr)
        weights[low : low + 2] = low + 1 - row, row - low
        bulk = np.einsum("i,iajb,j->ab", weights, same, weights)
        share = np.full(nz, width / (nz - 1))
        share[[0, -1]] *= 0.5
        dent = (
            2.0
            / pi
            * plane
            * (log(2.0 * flank.depth / half) - 0.5 * STEEL.poisson_ratio / (1.0 - STEEL.poisson_ratio))
        )
        total = total + bulk + np.diag(dent / share)
    return np.linalg.inv(total).sum() / width


@pytest.fixture(scope="module")
def standard_pair() -> CylindricalPair:
    return CylindricalPair(CylindricalGear(28, 4e-3), CylindricalGear(70, 4e-3), face_width=0.03)


@pytest.fixture(scope="module")
def flanks(standard_pair: CylindricalPair):
    return pair_compliances(standard_pair, (0.03, 0.03), settings=SectorSettings(COARSE), keep=False)


def test_one_pair_is_as_stiff_as_the_theory_of_the_standard_within_ten_percent(standard_pair, flanks):
    middle = 0.5 * sum(standard_pair.path_of_contact)
    theory = mesh_stiffness.theoretical_stiffness(standard_pair)
    places = np.linspace(0.8, 1.2, 5) * middle
    greatest = max(single_stiffness(standard_pair, flanks, place, 300e3) for place in places)
    assert greatest == pytest.approx(theory, rel=0.1)


def test_force_and_displacement_may_change_places(flanks):
    for flank in flanks:
        mirrored = flank.influence[::-1].transpose(0, 2, 1)
        assert np.abs(flank.influence - mirrored).max() <= 1e-12 * np.abs(flank.influence).max()
        assert flank.asymmetry < 0.02


def test_forces_do_positive_work_without_the_dent(flanks):
    for flank in flanks:
        least = np.linalg.eigvalsh(flank.influence[len(flank.influence) // 2])[0]
        assert least > 0.0


def test_the_other_hand_is_the_mirror_image():
    gears = CylindricalGear(30, 4e-3, radians(18.0)), CylindricalGear(30, 4e-3, radians(18.0))
    settings = SectorSettings(Fineness(flank=2, fillet=1, core=1, rim=2, axial=3), teeth=3)
    right, left = pair_compliances(CylindricalPair(*gears), (0.03, 0.03), settings=settings, keep=False)
    nr, nz = len(right.roll), len(right.axial)
    shape = (3, nr, nz, nr, nz)
    turned = left.influence.reshape(shape)[:, :, ::-1, :, ::-1]
    assert turned == pytest.approx(right.influence.reshape(shape), rel=1e-9, abs=1e-16)


EQUAL = CylindricalPair(CylindricalGear(28, 4e-3), CylindricalGear(28, 4e-3), face_width=6e-3)
PLACES = np.linspace(*EQUAL.path_of_contact, 7)


def stiffness_along_the_path(line_load: float = 300e3, depth: float = 0.2, **numbers: int) -> np.ndarray:
    settings = SectorSettings(Fineness(**({"axial": 1} | numbers)), layer=depth)
    flank = flank_compliance(EQUAL.pinion, EQUAL.face_width, settings=settings, keep=False)
    return np.array([single_stiffness(EQUAL, (flank, flank), place, line_load) for place in PLACES])


def test_more_elements_change_the_stiffness_by_less_than_two_percent():
    finer = stiffness_along_the_path(flank=12, fillet=3, layer=2, core=3, rim=6)
    assert stiffness_along_the_path() == pytest.approx(finer, rel=0.02)


def test_it_does_not_matter_how_deep_the_layer_is_that_is_taken_out():
    """For contacts that are narrow beside it: 30 N/mm make one 0.15 mm wide."""
    thin, thick = (stiffness_along_the_path(30e3, depth, flank=10) for depth in (0.12, 0.22))
    assert thin == pytest.approx(thick, rel=0.015)
