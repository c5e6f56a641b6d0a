"""Tooth geometry and inertia against closed values and identities."""

from math import cos, pi, radians, sin, sqrt, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import (
    Projection,
    ToothGeometry,
    YAxis,
    disc_face_width,
    equivalent_mass,
    line_of_action,
    solid_disc,
)

ARTICLE = ToothGeometry((28, 70), 4e-3, radians(20.0), radians(18.0))
MASSES = (5.98, 34.72)
geometries = st.builds(
    ToothGeometry,
    teeth=st.tuples(st.integers(12, 200), st.integers(12, 200)),
    normal_module=st.floats(2e-4, 5e-2),
    pressure_angle=st.floats(radians(10), radians(30)),
    helix_angle=st.floats(radians(-40), radians(40)),
)


@given(geometries)
def test_direction_factors_obey_the_identities_of_involute_gears(geometry):
    alpha_t, beta_b = geometry.transverse_pressure_angle, geometry.base_helix_angle
    pitch = line_of_action(geometry, Projection.PITCH)
    base = line_of_action(geometry, Projection.BASE)
    assert pitch.c_t == pytest.approx(cos(alpha_t) * cos(beta_b), rel=1e-13)
    assert (
        pitch.c_z
        == base.c_z
        == pytest.approx(cos(geometry.pressure_angle) * sin(geometry.helix_angle), rel=1e-13)
    )
    assert tan(beta_b) == pytest.approx(tan(geometry.helix_angle) * cos(alpha_t), rel=1e-12, abs=1e-15)
    assert base.c_t**2 + base.c_z**2 == pytest.approx(1.0, rel=1e-13)
    # The same displacement by rotation, whichever radius it is written with.
    for i in (0, 1):
        assert pitch.radii[i] * pitch.c_t == pytest.approx(base.radii[i] * base.c_t, rel=1e-13)


def test_named_options_change_only_what_they_name():
    pitch = line_of_action(ARTICLE)
    literal = line_of_action(ARTICLE, Projection.MIXED)
    along = line_of_action(ARTICLE, Projection.PITCH, YAxis.LINE_OF_ACTION)
    assert pitch.c_y == pitch.c_t == cos(radians(20)) * cos(radians(18))
    assert literal.radii == ARTICLE.base_radii
    assert literal.c_t == pitch.c_t
    assert along.c_y == cos(ARTICLE.base_helix_angle)
    assert (along.radii, along.c_t, along.c_z) == (pitch.radii, pitch.c_t, pitch.c_z)


def test_the_article_pair_has_the_radii_of_its_drawing():
    assert ARTICLE.pitch_radii == pytest.approx(
        (0.112 / (2 * cos(radians(18))), 0.280 / (2 * cos(radians(18))))
    )
    assert ARTICLE.centre_distance == pytest.approx(0.206087, abs=5e-7)
    assert ARTICLE.base_radii[0] == pytest.approx(0.0549923, abs=5e-8)


def test_spur_contact_ratio_equals_the_rack_construction():
    # 20° full-depth spur pair: path of approach and recess written out from the triangle of the base circle.
    pair = ToothGeometry((25, 40), 2e-3, radians(20.0))
    path = sum(sqrt((z + 2) ** 2 - (z * cos(radians(20))) ** 2) - z * sin(radians(20)) for z in pair.teeth)
    assert pair.transverse_contact_ratio == pytest.approx(path / (2 * pi * cos(radians(20))), rel=1e-13)
    assert 1.6 < pair.transverse_contact_ratio < 1.7  # handbook value for 25/40 teeth
    assert pair.overlap_ratio(0.02) == 0.0


def test_overlap_and_total_contact_ratio_of_the_article_pair():
    assert ARTICLE.overlap_ratio(0.065) == pytest.approx(0.065 * sin(radians(18)) / (pi * 0.004), rel=1e-14)
    assert ARTICLE.total_contact_ratio(0.065) == pytest.approx(
        ARTICLE.transverse_contact_ratio + ARTICLE.overlap_ratio(0.065), rel=1e-15
    )


def test_a_left_hand_helix_has_the_same_overlap_as_a_right_hand_one():
    left = ToothGeometry((28, 70), 4e-3, radians(20.0), radians(-18.0))
    assert left.overlap_ratio(0.065) == ARTICLE.overlap_ratio(0.065)
    assert line_of_action(left).c_z == -line_of_action(ARTICLE).c_z


def test_solid_discs_give_the_equivalent_mass_in_closed_form():
    radii = ARTICLE.pitch_radii
    inertias = tuple(solid_disc(m, r) for m, r in zip(MASSES, radii, strict=True))
    m_e = equivalent_mass(radii, (inertias[0], inertias[1]))
    assert m_e == pytest.approx(MASSES[0] * MASSES[1] / (2 * sum(MASSES)), rel=1e-14)
    assert round(m_e, 4) == 2.5507
    assert round(sqrt(3.2e8 / m_e)) == 11201


def test_stated_masses_are_steel_discs_of_70_and_65_mm():
    widths = [1e3 * disc_face_width(m, r) for m, r in zip(MASSES, ARTICLE.pitch_radii, strict=True)]
    assert [round(w) for w in widths] == [70, 65]


def test_speeds_of_the_article_are_3600_and_4000_rpm_to_its_printed_digits():
    omega_n = sqrt(3.2e8 / (MASSES[0] * MASSES[1] / (2 * sum(MASSES))))
    for omega, rpm in ((0.942, 3600), (1.047, 4000)):
        assert round(rpm / 60 * 28 * 2 * pi / omega_n, 3) == omega
