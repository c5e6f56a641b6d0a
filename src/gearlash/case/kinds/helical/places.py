"""Every place of a helical pair: those of all pairs, and bearings, helix and lateral motion."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.kinds.gears import drawn, loaded, play, shared, supports
from gearlash.case.kinds.gears.keys import GEARS, PROJECTION
from gearlash.case.kinds.gears.places import Places
from gearlash.case.kinds.gears.shared import NOMINAL, RIGHT_ANGLE, number, positive, ratio
from gearlash.case.kinds.gears.written import handed_angle
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import ANGLE, STIFFNESS
from gearlash.gears import Projection, YAxis

BEARINGS = ("yp", "zp", "yg", "zg")
MODULE, OTHER_MODULE = "mesh.normal_module", "mesh.module"
Y_AXIS = "model.y_axis"
FACTORS = ("y_factor", "z_factor", "mass_ratio_p", "mass_ratio_g")


def _quantities() -> Iterator[Quantity]:
    for gear in GEARS:
        yield from shared.of_gear(gear)
        yield from drawn.of_gear(gear)
        yield from play.of_gear(gear)
        yield supports.added_mass(gear)
        for axis, way in supports.WAYS.items():
            what = f"{way} bearing stiffness of the {gear}"
            yield positive(f"{gear}.bearing_stiffness_{axis}", STIFFNESS, "N/m", "8e8 N/m", what, 1e13)
            yield ratio(f"{gear}.bearing_damping_{axis}", f"{way} bearing damping ratio ξ of the {gear}")
            yield from supports.of_gear(gear, axis)
    yield from shared.of_teeth(MODULE, OTHER_MODULE)
    yield Quantity(
        "mesh.helix_angle",
        ANGLE,
        "deg",
        "18 deg",
        "helix angle β at the pitch cylinder",
        -RIGHT_ANGLE,
        RIGHT_ANGLE,
        reader=handed_angle,
        alone=NOMINAL,
    )
    yield ratio("bearings.damping_ratio", "damping ratio ξ of all four bearing directions")
    yield from shared.of_mesh()
    yield from drawn.of_mesh()
    yield from play.of_mesh()
    yield from loaded.quantities()
    yield from shared.of_operation()
    yield from drawn.of_operation()
    yield from shared.of_numbers()
    yield from _numbers("dimensionless")


def _numbers(table: str) -> Iterator[Quantity]:
    yield ratio(f"{table}.bearing_damping", "damping ratio ξ of all four bearing directions")
    yield number(f"{table}.y_factor", "0.89", "c_y, how lateral motion enters the mesh", -1.0, 1.0)
    yield number(f"{table}.z_factor", "0.29", "c_z, how axial motion enters the mesh", -1.0, 1.0)
    for gear in "pg":
        yield number(f"{table}.mass_ratio_{gear}", "0.43", f"m_e/m_{gear}", 0.0, above=True)
    for bearing in BEARINGS:
        yield ratio(f"{table}.bearing_damping_{bearing}", f"damping ratio ξ of direction {bearing}")
        what = f"κ of direction {bearing}: its frequency over ω_n"
        yield number(f"{table}.bearing_frequency_{bearing}", "1.03", what, 0.0, above=True)


def _choices() -> Iterator[Choice]:
    yield from shared.options()
    yield from drawn.options()
    yield from play.options()
    yield Choice(PROJECTION, tuple(Projection), Projection.PITCH, shared.PROJECTED)
    yield Choice(Y_AXIS, tuple(YAxis), YAxis.PITCH_TANGENT, "direction of the lateral coordinate")


def _ways() -> dict[str, tuple[str, ...]]:
    found = {**shared.ways(), "bearing_damping": ("bearings.damping_ratio",)}
    for bearing in BEARINGS:
        axis, gear = bearing[0], "pinion" if bearing[1] == "p" else "gear"
        found[f"bearing_damping_{bearing}"] = (f"{gear}.bearing_damping_{axis}",)
        found[f"bearing_frequency_{bearing}"] = (f"{gear}.bearing_stiffness_{axis}",)
    return found | dict.fromkeys(FACTORS, ())


PLACES = Places.of(
    _quantities(),
    _choices(),
    _ways(),
    {"bearing_damping": tuple(f"bearing_damping_{bearing}" for bearing in BEARINGS), **drawn.BOTH_WIDTHS},
    {OTHER_MODULE: MODULE, play.AT_WORK: "D"},
)
