"""Materials as drawings call them. Moduli are those of the standards and data sheets named beside them."""

import pytest

from gearlash.case.kinds import kind_named
from gearlash.case.stated import ValueRefusedError, read_stated
from gearlash.gears import materials
from gearlash.gears.material_names import OF_ALUMINIUM
from gearlash.system import GearlashError


@pytest.mark.parametrize(
    ("key", "names"),
    [
        ("steel", (
            "Stahl", "42CrMo4", "42 CrMo 4", "42CrMo4+QT", "42CrMo4V", "18CrNiMo7-6", "C45", "Ck45", "C45E",
            "16MnCr5", "1.7225", "1.6587", "1.0503", "AISI 4140", "SAE 8620H", "4340", "SCM440H", "S45C",
            "SNCM220", "SCr420", "20CrMnTi", "40Cr", "817M40", "E335", "S355J2", "31CrMoV9", "17NiCrMo6-4",
            "case-hardened steel", "20NiCrMo2-2", "9310", "1045",
            "EN36A", "En 24", "En 8", "20CrMnTiH", "20Cr2Ni4A", "18Cr2Ni4WA", "38CrMoAlA", "45#", "AISI 1050",
            "SAE 1060", "5160", "1144",
        )),
        ("cast-steel", ("cast steel", "GS-45", "Stahlguss", "ZG310-570")),
        ("nodular-cast-iron", (
            "nodular iron", "ductile iron", "EN-GJS-400-15", "EN-GJS-700-2", "GGG-40", "GGG70", "FCD450",
            "QT500-7",
        )),
        ("grey-cast-iron", (
            "grey cast iron", "gray iron", "EN-GJL-250", "EN-GJL-300", "GG25", "FC250", "HT250",
        )),
        ("tin-bronze", ("phosphor bronze", "CuSn12", "CuSn12Ni2-C", "CC483K", "G-CuSn12", "PB2")),
        ("brass", ("Messing", "CuZn39Pb3", "CW614N")),
        ("aluminium", ("aluminum", "EN AW-6082", "6061-T6", "7075", "AA 1050", "EN AW-1050A")),
        ("POM", ("Delrin", "acetal", "POM-C", "pom")),
        ("PA66", ("PA 66", "Nylon 66")),
        ("PA66-GF30", ("PA66 GF30",)),
    ],
)  # fmt: skip
def test_names_of_drawings(key: str, names: tuple[str, ...]):
    for name in names:
        assert materials.named(name).name == key, name


@pytest.mark.parametrize(
    ("name", "nearest"),
    [
        ("cast iron", "grey-cast-iron"),
        ("bronze", "tin-bronze"),
        ("aluminium bronze", "tin-bronze"),
        ("nylon", "PA66"),
        ("PA12", "PA66"),
        ("X5CrNi18-10", "steel"),  # austenitic: 200 GPa and below
        ("S30400", None),  # the same in UNS
        ("304", "steel"),
        ("1.4301", "steel"),
        ("EN-GJL-150", "grey-cast-iron"),  # 78 to 103 GPa by EN 1561, below the range of the list
        ("ADI", "nodular-cast-iron"),
        ("stel", "steel"),
        ("unobtainium", None),
        ("25", None),
        ("45", "steel"),
        ("HT200", "grey-cast-iron"),
        ("PB102", "tin-bronze"),  # CuSn5: above the range of the list
        ("12Cr18Ni9", "steel"),  # austenitic
        ("5154", "aluminium"),  # of no grade of SAE
        ("6101", "aluminium"),
        ("1050", None),  # steel or aluminium
        ("1100", "aluminium"),  # of no grade of SAE
        ("", None),
    ],
)
def test_what_has_another_modulus_or_several_is_refused_with_what_is_near(name: str, nearest: str | None):
    with pytest.raises(GearlashError, match="the list has"):
        materials.named(name)
    assert materials.nearest_name(name) == nearest


@pytest.mark.parametrize("number", OF_ALUMINIUM)
def test_a_number_that_steel_and_aluminium_have_says_neither(number: str):
    place = kind_named("helical-pair").places["pinion.material"]
    with pytest.raises(ValueRefusedError, match=f"AISI {number} of steel or AA {number} of aluminium"):
        read_stated(number, place)
    assert materials.named(f"AA {number}").name == "aluminium"
    assert materials.named(f"AISI {number}").name == "steel"


MODULI = {  # GPa, from data sheets whose addresses stand in `materials`; CW608N from its own
    "EN-GJS-400-18": (169, 170),
    "EN-GJS-600-3": (174, 175),
    "EN-GJS-700-2": (175, 176),
    "EN-GJL-250": (103, 118),
    "EN-GJL-300": (108, 137),
    "AISI 1020": (200, 207),
    "AISI 4140": (205, 207),
    "SAE 4340": (205, 207),
    "BS970 817M40": (205, 205),
    "EN24": (205, 205),
    "20CrMnTi": (207, 207),
    "40CrNiMoA": (209, 209),
    "CW608N": (102, 102),
}
EXPANSIONS = {"AISI 1020": 12.0, "AISI 4340": 12.3, "8620": 13.0, "20CrMnTi": 12.6}
"""10⁻⁶/K, likewise."""


@pytest.mark.parametrize("name", MODULI)
def test_the_modulus_of_a_designation_lies_in_the_range_of_its_entry(name: str):
    least, greatest = materials.named(name).youngs_range
    assert least <= 1e9 * MODULI[name][0] <= 1e9 * MODULI[name][1] <= greatest


@pytest.mark.parametrize("name", EXPANSIONS)
def test_the_expansion_of_a_designation_lies_in_the_range_of_its_entry(name: str):
    least, greatest = materials.named(name).expansion_range
    assert least <= 1e-6 * EXPANSIONS[name] <= greatest * (1.0 + 1e-12)


def test_values_of_a_data_sheet_take_the_place_of_those_of_the_list():
    own = materials.with_own(materials.named("tin-bronze"), 110e9, 0.34, 7600.0)
    assert (own.youngs_modulus, own.poisson_ratio, own.density) == (110e9, 0.34, 7600.0)
    assert own.youngs_range == (110e9, 110e9)
    assert own.source.startswith("E, ν, density: stated")
    assert materials.with_own(materials.named("steel")) is materials.named("steel")
