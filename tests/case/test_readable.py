"""Physical numbers in the unit that reads best."""

import pytest

from gearlash.case.readable import readable
from gearlash.case.units import read


@pytest.mark.parametrize(
    ("value", "unit", "told", "name"),
    [
        (-12890.0, "µm", -12.89, "mm"),
        (9999.0, "µm", 9999.0, "µm"),
        (4.5e7, "µm", 45.0, "m"),
        (3e15, "µm", 3e9, "m"),
        (0.0021, "µm", 2.1, "nm"),
        (1e-9, "µm", 1e-6, "nm"),
        (0.0, "µm", 0.0, "µm"),
        (25_000.0, "N", 25.0, "kN"),
        (4e7, "N", 40.0, "MN"),
        (5e-4, "N·m", 0.5, "mN·m"),
        (30_000.0, "N·m", 30.0, "kN·m"),
        (5e6, "rpm", 5e6, "rpm"),
    ],
)
def test_a_number_is_neither_long_nor_tiny(value: float, unit: str, told: float, name: str) -> None:
    found, chosen = readable(value, unit)
    assert (pytest.approx(told, rel=1e-12), name) == (found, chosen)


@pytest.mark.parametrize("unit", ["µm", "N", "N·m"])
@pytest.mark.parametrize("value", [3.7e-4, 1.0, 2.5e5, 8.1e8])
def test_it_is_the_same_quantity(value: float, unit: str) -> None:
    """As the units of case files have it."""
    found, chosen = readable(value, unit)
    (number, own), (other, better) = read(f"{value!r} {unit}"), read(f"{found!r} {chosen}")
    assert own.convert(number) == pytest.approx(better.convert(other), rel=1e-12)
