"""Physical values as engineers type them, and what looks like one and is not."""

from fractions import Fraction
from math import isfinite, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.case import units
from gearlash.case.units import (
    ANGLE,
    FORCE,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    NUMBER,
    SPEED,
    STIFFNESS,
    TORQUE,
    UnitError,
    read,
)


@pytest.mark.parametrize(
    ("text", "value", "dimension"),
    [
        ("4 mm", 0.004, LENGTH),
        ("4mm", 0.004, LENGTH),
        ("  4  mm ", 0.004, LENGTH),
        (".5 cm", 0.005, LENGTH),
        ("100 um", 1e-4, LENGTH),
        ("100 µm", 1e-4, LENGTH),  # micro sign
        ("100 μm", 1e-4, LENGTH),  # Greek mu
        ("100 micron", 1e-4, LENGTH),
        ("1 inch", 0.0254, LENGTH),
        ("5.98 kg", 5.98, MASS),
        ("3.2e8 N/m", 3.2e8, STIFFNESS),
        ("3.2E+8 N / m", 3.2e8, STIFFNESS),
        ("320 N/um", 3.2e8, STIFFNESS),
        ("320 kN/mm", 3.2e8, STIFFNESS),
        ("3.2e5 N/mm", 3.2e8, STIFFNESS),
        ("1.5 kN", 1500.0, FORCE),
        ("450 Nm", 450.0, TORQUE),
        ("450 N·m", 450.0, TORQUE),
        ("450 N⋅m", 450.0, TORQUE),
        ("450 N*m", 450.0, TORQUE),
        ("450 N m", 450.0, TORQUE),
        ("450 N\u00a0m", 450.0, TORQUE),
        ("-0.45 kNm", -450.0, TORQUE),
        ("−0.45 kN m", -450.0, TORQUE),  # minus sign
        ("4500 Ncm", 45.0, TORQUE),
        ("0.01 kg·m²", 0.01, INERTIA),
        ("0.01 kgm²", 0.01, INERTIA),
        ("25 gcm²", 25e-7, INERTIA),
        ("25 gcm^2", 25e-7, INERTIA),
        ("300 gmm2", 3e-7, INERTIA),
        ("0.01 kg m^2", 0.01, INERTIA),
        ("0.01 kg m2", 0.01, INERTIA),
        ("100 kg cm^2", 0.01, INERTIA),
        ("3600 rpm", 120 * pi, SPEED),
        ("3600 rev/min", 120 * pi, SPEED),
        ("377 rad/s", 377.0, SPEED),
        ("1680 Hz", 1680.0, FREQUENCY),
        ("1.68 kHz", 1680.0, FREQUENCY),
        ("1680 1/s", 1680.0, FREQUENCY),
        ("18 deg", pi / 10, ANGLE),
        ("18°", pi / 10, ANGLE),
        ("18 °", pi / 10, ANGLE),
        ("0.3 rad", 0.3, ANGLE),
        ("2.5 %", 0.025, NUMBER),
        ("2.5%", 0.025, NUMBER),
        ("0.07", 0.07, NUMBER),
        ("3.4·10⁸ N/m", 3.4e8, STIFFNESS),
        ("3.4 × 10^8 N/m", 3.4e8, STIFFNESS),
        ("3.4*10^8N/m", 3.4e8, STIFFNESS),
        ("3.4x10^8 N/m", 3.4e8, STIFFNESS),
        ("3.4 · 10 ** 8 N/m", 3.4e8, STIFFNESS),
        ("3.4·10^(8) N/m", 3.4e8, STIFFNESS),
        ("−3.4·10⁻³ mm", -3.4e-6, LENGTH),
        ("10⁸ N/m", 1e8, STIFFNESS),
        ("10 ^ 8 N/m", 1e8, STIFFNESS),
        ("10 mm", 0.01, LENGTH),
        ("10^3", 1000.0, NUMBER),
        ("2.5e8N/m", 2.5e8, STIFFNESS),
        ("340 N/µm", 3.4e8, STIFFNESS),
        ("340 N\u202fµm⁻¹", 3.4e8, STIFFNESS),
        ("12 N-m", 12.0, TORQUE),
        ("12 N.m", 12.0, TORQUE),
        ("450.N.m", 450.0, TORQUE),
        ("12 kgf·m", 117.6798, TORQUE),
        ("3600 U/min", 120 * pi, SPEED),
        ("3600 r/min", 120 * pi, SPEED),
        ("3600 rev min⁻¹", 120 * pi, SPEED),
        ("3600 1/min", 60.0, FREQUENCY),
        ("3600/min", 60.0, FREQUENCY),
        ("3600 min^-1", 60.0, FREQUENCY),
        ("3600 min⁻¹", 60.0, FREQUENCY),
        ("0,5 mm", 5e-4, LENGTH),
        ("12,75 mm", 0.01275, LENGTH),
        ("0,125 mm", 1.25e-4, LENGTH),
        (",5 mm", 5e-4, LENGTH),
        ("3,4e8 N/m", 3.4e8, STIFFNESS),
        ("3,4·10⁸ N/m", 3.4e8, STIFFNESS),
        ("1.234,5 mm", 1.2345, LENGTH),
        ("1,234.5 mm", 1.2345, LENGTH),
        ("1.234.567 N/m", 1234567.0, STIFFNESS),
        ("1,234,567 N/m", 1234567.0, STIFFNESS),
        ("４２００ rpm", 140 * pi, SPEED),
        ('1.25"', 0.03175, LENGTH),
        ("1.25″", 0.03175, LENGTH),
        ("1.25''", 0.03175, LENGTH),
        ('1 1/4"', 0.03175, LENGTH),
        ("1-1/4 in", 0.03175, LENGTH),
        ("1¼ IN", 0.03175, LENGTH),
        ('3/8"', 0.009525, LENGTH),
        ("4 mil", 1.016e-4, LENGTH),
        ("4 thou", 1.016e-4, LENGTH),
        ("14 1/2°", 29 * pi / 360, ANGLE),
        ("14½ DEG", 29 * pi / 360, ANGLE),
        ("20º", pi / 9, ANGLE),
        ("4200 RPM", 140 * pi, SPEED),
        ("4200 tr/min", 140 * pi, SPEED),
        ("10 kgcm2", 0.001, INERTIA),
        ("150 Nmm", 0.15, TORQUE),
        ("150 daNm", 1500.0, TORQUE),
        ("1 kgfm", 9.80665, TORQUE),
        ("1680 s⁻¹", 1680.0, FREQUENCY),
    ],
)
def test_what_engineers_type_works(text, value, dimension):
    number, unit = read(text)
    assert unit.dimension == dimension
    assert unit.convert(number) == pytest.approx(value, rel=2e-16, abs=0.0)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "nothing"),
        ("   ", "nothing"),
        ("nan mm", "not a finite number"),
        ("-inf mm", "not a finite number"),
        ("1e999 mm", "too large"),
        ("4 mm;", "no unit"),
        ("4 mm)", "no unit"),
        ("4 (mm)", "no unit"),
        ("3,600 rpm", r"write 3\.600 or 3600"),
        ("12,500 N", r"write 12\.500 or 12500"),
        ("4,5,6 mm", "several commas"),
        ("4.5,6 mm", "no unit|several commas"),
        ("3 600 rpm", "digits are written without anything between them"),
        ("3\u202f600 rpm", "digits are written without anything between them"),
        ("3'600 rpm", "digits are written without anything between them"),
        ("3.4·10 8 N/m", "a power of ten is written 3.4e8"),
        ("3.4 10^8 N/m", "a power of ten is written 3.4e8"),
        ("×10^8 N/m", "start with a number"),
        ("10^99999 N/m", "too large"),
        ("5±1 mm", "no unit"),
        ("4 / mm", "a unit is missing"),
        ("4 mm/", "a unit is missing"),
        ("4 mm**2", "a unit is missing"),
        ("4 mm^1.5", "no unit"),
        ("4 mm^99", "no unit"),
        ("mm", "start with a number"),
        ("four mm", "start with a number"),
        ("0x10 mm", "no unit"),
        ("1_000 mm", "no unit"),
        ("4 furlongish", "'furlongish' is no unit"),
        ("4 kG m", "no unit"),
        ("4 Rpms", "no unit"),
        ("4 kelvin", "no unit"),
        ("4 pi", "no unit"),
        ("4 m_e", "no unit"),
        ("4 ‰", "no unit"),
        ("٤ mm", "start with a number"),
        ("4 mm\x00", "no unit"),
    ],
)
def test_what_looks_right_and_is_not_is_refused(text, why):
    with pytest.raises(UnitError, match=why):
        read(text)


IN_PINT = {"mil": "thou", "PS": "metric_horsepower"}


@pytest.mark.parametrize(
    "word", [w for w in units.UNIT_WORDS if w not in ("%", "ppm", "rev", "U", "r", "degC", "DP")]
)
def test_every_known_word_is_what_pint_makes_of_it(word):
    found = units.ask_pint(IN_PINT.get(word, word))
    assert found is not None
    assert found.dimension == units.UNIT_WORDS[word].dimension
    assert float(found.ratio) == pytest.approx(units.UNIT_WORDS[word].convert(Fraction(1)), rel=1e-15)


@pytest.mark.parametrize(
    "text",
    [
        "11.5e-6 1/K", "11.5e-6/K", "11.5e-6 K^-1", "11,5·10⁻⁶ 1/K", "11.5×10⁻⁶ K⁻¹", "11.5 µm/(m·K)",
        "11.5 µm/m·K", "11.5 um/m/K", "11.5 µm/m-K", "11.5 ppm/K", "11.5 ppm/°C", "11.5 µm/m°C",
        "6.3888888889 µin/in·°F",
        "6.3888888889e-6 in/in/°F",
    ],
)  # fmt: skip
def test_thermal_expansion_as_data_sheets_have_it(text: str):
    """A degree of a difference is as large in K as in °C, and 9/5 °F."""
    number, unit = read(text)
    assert unit.dimension == units.EXPANSION
    assert unit.convert(number) == pytest.approx(11.5e-6, rel=1e-9)


@pytest.mark.parametrize("text", ["333 K", "140 °F", "11.5 K", "11.5 m*K"])
def test_a_degree_that_stands_above_the_stroke_is_no_unit(text: str):
    with pytest.raises(UnitError, match="no unit"):
        read(text)


@pytest.mark.parametrize("text", ["60 °C", "60 degC", "60℃", "60° C"])
def test_temperatures_are_read_off_a_thermometer_and_no_angles(text):
    number, unit = read(text)
    assert (number, unit.dimension) == (60, units.TEMPERATURE)
    assert read("60°")[1].dimension == units.ANGLE


@pytest.mark.parametrize(
    ("text", "dimension", "pint_text"),
    [
        ("10 lb ft", TORQUE, "10 lbf*ft"),
        ("10 ft-lb", TORQUE, "10 lbf*ft"),
        ("10 ftlb", TORQUE, "10 lbf*ft"),
        ("10 LB-IN", TORQUE, "10 lbf*inch"),
        ("10 in-lbs", TORQUE, "10 lbf*inch"),
        ("10 lb.in", TORQUE, "10 lbf*inch"),
        ("10 oz in", TORQUE, "10 ozf*inch"),
        ("1e6 lb/in", STIFFNESS, "1e6 lbf/inch"),
        ("10 lb in s^2", INERTIA, "10 lbf*inch*s^2"),
        ("10 lb in^2", INERTIA, "10 lb*inch^2"),
        ("10 lb", MASS, "10 lb"),
        ("20 hp", units.POWER, "20 horsepower"),
        ("20 BHP", units.POWER, "20 horsepower"),
        ("20 PS", units.POWER, "20 metric_horsepower"),
        ("8 DP", units.PITCH, "8 / inch"),
        ("20 N/(mm·µm)", units.PRESSURE, "20 N/mm/um"),
    ],
)
def test_pounds_weigh_where_only_that_fits(text: str, dimension: units.Dimension, pint_text: str):
    import pint

    number, unit = read(text, dimension)
    assert unit.dimension == dimension
    pint_value = pint.UnitRegistry()(pint_text).to_base_units().magnitude
    assert unit.convert(number) == pytest.approx(pint_value, rel=1e-12)


def test_rev_is_a_turn():
    turn = units.ask_pint("turn")
    assert turn is not None
    assert units.unit("rev").convert(Fraction(1)) == pytest.approx(float(turn.ratio), rel=1e-15)


@given(st.sampled_from(sorted(units.UNIT_WORDS)), st.floats(-1e200, 1e200))
def test_showing_a_value_undoes_reading_it(word, number):
    unit = units.UNIT_WORDS[word]
    assert unit.express(unit.convert(Fraction(number))) == pytest.approx(number, rel=1e-15, abs=1e-300)


@given(st.text(max_size=30))
def test_any_text_is_a_value_or_a_unit_error(text):
    try:
        number, unit = read(text)
    except UnitError:
        return
    assert isfinite(float(number))
    assert unit.ratio > 0


@given(st.from_regex(r"\A[-+]?[0-9]{1,3}(\.[0-9]{0,3})?(e-?[0-9]{1,9})? ?[a-zA-Z%*/^ 0-9]{0,12}\Z"))
def test_texts_near_to_values_never_crash(text):
    try:
        read(text)
    except UnitError as error:
        assert str(error)  # noqa: PT017 - either outcome is right; a refusal must say why


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("15°30'", 15.5),
        ("15° 30′", 15.5),
        ("-15°6'36\"", -15.11),
        ("0°30′", 0.5),
        ("15 deg 30'", 15.5),
        ("-15°6'36''", -15.11),
    ],
)
def test_degrees_and_minutes_of_a_drawing(text: str, degrees: float):
    number, unit = read(text)
    assert unit.dimension == units.ANGLE
    assert unit.express(unit.convert(number)) == pytest.approx(degrees, rel=1e-14)


@pytest.mark.parametrize("text", ["15°60'", "15°30", "15.5°30'", "15°30'\"", "15'30°"])
def test_what_is_no_angle_in_minutes_is_refused(text: str):
    with pytest.raises(UnitError):
        read(text)
