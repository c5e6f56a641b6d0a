"""Zones in planes, borders against known points and orbits at random places, and margins."""

from __future__ import annotations

import threading
from functools import cache

import numpy as np
import pytest

import gearlash as gl
from gearlash.orbits import orbit_at
from gearlash.system import Family
from orbits.members import one_dof

BESIDE = 2e-3  # of the rectangle: places so near to the boundary are asked nothing


@cache
def parametric() -> gl.PlaneZone:
    """The contact-only orbit under a strong ripple: it grazes, or doubles at an amplitude that is none."""
    return gl.plane_zone(
        ripple(), ("omega", "error"), lower=(1.8, 0.06), upper=(1.95, 0.11),
        values={"omega": 1.85, "error": 0.08}, tolerances={"omega": 0.01, "error": 0.005}, lines=1,
    )  # fmt: skip


@cache
def ripple() -> Family:
    return one_dof(error=0.0005, ripple=0.3)


@cache
def physical() -> gl.PlaneZone:
    return gl.plane_zone(
        gl.load_case("article"), ("pinion_speed", "torque"), lower=("3500 rpm", "80 N*m"),
        upper=("4400 rpm", "120 N*m"), tolerances={"pinion_speed": "50 rpm", "torque": "3 N*m"}, lines=1,
    )  # fmt: skip


def held(family: Family, zone: gl.PlaneZone, place: np.ndarray) -> bool:
    """Whether the orbit is there, quiet and stable: looked for from all orbits of the boundary near by."""
    points = [point for part in zone.parts for point in part.points]
    unit = np.subtract(zone.upper, zone.lower)
    points.sort(key=lambda point: float(np.linalg.norm((np.array(point.values) - place) / unit)))
    values = {**zone.values, **dict(zip(zone.names, place.tolist(), strict=True))}
    props = gl.propagators(family.system(values))
    for point in points[:20:5]:
        found = orbit_at(props, point.state, point.period, least=True)
        if found is not None and found.stable and zone.quiet.holds_signature(found.signature):
            return True
    return False


def far_from_boundary(zone: gl.PlaneZone, place: np.ndarray) -> bool:
    unit = np.subtract(zone.upper, zone.lower)
    return bool(np.linalg.norm((zone.outline - place) / unit, axis=1).min() > BESIDE)


@pytest.mark.slow
@pytest.mark.parametrize("which", [parametric, physical])
def test_random_places_inside_and_outside(which):
    zone = which()
    family = ripple() if which is parametric else gl.load_case("article").family()[0]
    draw = np.random.default_rng(15)
    places = zone.lower + draw.random((60, 2)) * np.subtract(zone.upper, zone.lower)
    inside = [zone.contains(*place) for place in places]
    assert 10 < sum(inside) < 50
    for place, expected in zip(places, inside, strict=True):
        if far_from_boundary(zone, place):
            assert held(family, zone, place) is expected, place


def test_where_the_parametric_instability_takes_over_from_the_grazing():
    """Known from another program."""
    zone = parametric()
    assert zone.complete, zone.notes
    assert {str(part.kind) for part in zone.parts} == {"grazing", "doubling"}
    (corner,) = zone.special
    assert corner.values == pytest.approx((1.88314401708371501, 0.0934128021427322), abs=1e-12)
    doubling = next(part for part in zone.parts if str(part.kind) == "doubling")
    assert np.ptp(doubling.values[:, 0]) < 1e-12  # the linear system does not know the error
    assert doubling.values[:, 1].max() == pytest.approx(corner.values[1], abs=1e-9)


@pytest.mark.slow
def test_the_corner_of_the_contact_only_orbit():
    """Known from another program: two grazings cross there, and the zone has a corner."""
    zone = gl.plane_zone(
        one_dof(error=0.09, ripple=0.95), ("omega", "error"), lower=(1.0, 0.07), upper=(1.1, 0.12),
        values={"omega": 1.06, "error": 0.093}, lines=0,
    )  # fmt: skip
    assert zone.complete, zone.notes
    (corner,) = zone.special
    assert corner.values == pytest.approx((1.0219614962, 0.0909609), abs=1e-7)
    assert [str(part.kind) for part in zone.parts] == ["grazing", "grazing"]
    assert zone.contains(1.04, 0.0923)
    assert not zone.contains(1.01, 0.0909)


@pytest.mark.slow
def test_a_zone_without_back_side_ends_at_a_fold_and_then_at_the_back_side():
    """Known from another program: where the fold meets the back side."""
    zone = gl.plane_zone(
        one_dof(error=0.05), ("omega", "D"), lower=(0.68, 0.1), upper=(0.76, 0.25), quiet="drive-side-only",
        values={"omega": 0.74, "D": 0.22}, start=[1.9 - 1.0 + 0.22, 0.3], lines=0,
    )  # fmt: skip
    assert zone.label == "1-1-0"
    assert zone.complete, zone.notes
    (corner,) = zone.special
    assert corner.values == pytest.approx((0.708031618721831, 0.145906154662747), abs=1e-12)
    assert {str(part.kind) for part in zone.parts} == {"fold", "grazing"}


def test_margins_along_each_axis_are_those_of_the_branch():
    zone, case = physical(), gl.load_case("article")
    branch = gl.continue_branch(case, "pinion_speed", lower="3500 rpm", upper="4400 rpm")
    below = max(s.value for s in branch.special if s.value < zone.at[0])
    above = min(s.value for s in branch.special if s.value > zone.at[0])
    assert [m.value for m in zone.margins[:2]] == pytest.approx([below, above], abs=1e-11)
    assert [m.event.split(",")[0] for m in zone.margins[:2]] == ["grazing", "grazing"]
    speed, cycles = zone.margins[0].physical
    assert (speed[0], speed[2], cycles[2]) == ("pinion_speed", "rpm", "Hz")
    assert speed[1] == pytest.approx(4000.0 * zone.margins[0].percent / 100.0, rel=1e-6)
    assert zone.margins[2].bounded is zone.margins[3].bounded is False
    assert zone.margins[2].physical[0][1] == pytest.approx(16.95, abs=5e-3)


@pytest.mark.parametrize("which", [parametric, physical])
def test_the_nearest_place_in_units_of_tolerances(which):
    """Against all places of the boundary, and against what makes a place nearest."""
    zone = which()
    boundary = np.concatenate([part.values for part in zone.parts])
    away = np.abs(boundary - zone.at) / zone.tolerances
    for margin, sizes in zip(
        zone.tolerance_margins, (away.max(axis=1), np.linalg.norm(away, axis=1)), strict=True
    ):
        assert margin.bounded
        assert margin.multiple <= sizes.min() + 1e-12
        assert margin.multiple == pytest.approx(sizes.min(), rel=0.05)
        own = np.abs(np.subtract(margin.values, zone.at)) / zone.tolerances
        size = own.max() if margin.norm == "box" else np.linalg.norm(own)
        assert margin.multiple == pytest.approx(size, rel=1e-12)
    box, ellipse = zone.tolerance_margins
    assert box.multiple <= ellipse.multiple


@pytest.mark.parametrize("which", [parametric, physical])
def test_the_nearest_place_lies_on_the_boundary(which):
    """On a straight line through it from the operating point the zone ends there."""
    zone = which()
    family = ripple() if which is parametric else gl.load_case("article").family()[0]
    for margin in zone.tolerance_margins:
        way = np.subtract(margin.values, zone.at)
        assert held(family, zone, zone.at + (1.0 - 1e-8) * way)
        assert not held(family, zone, zone.at + (1.0 + 1e-8) * way)


def test_a_zone_that_fills_the_rectangle():
    case = gl.load_case("kahraman-singh")
    zone = gl.plane_zone(
        case, ("omega", "D"), lower=(0.7, 0.9), upper=(0.72, 1.1), values={"omega": 0.71}, lines=0,
        tolerances={"omega": 0.001, "D": 0.05},
    )  # fmt: skip
    assert zone.complete
    assert zone.parts == ()
    assert sorted(map(tuple, zone.outline.tolist())) == [(0.7, 0.9), (0.7, 1.1), (0.72, 0.9), (0.72, 1.1)]
    assert [m.bounded for m in (*zone.margins, *zone.tolerance_margins)] == [False] * 6
    assert zone.tolerance_margins[0].multiple == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"values": {"omega": 1.5}}, "not inside|outside the interval"),
        ({"tolerances": {"omega": 0.1}}, "expected those of omega and D"),
        ({"tolerances": {"omega": 0.1, "D": 0.0}}, "positive"),
        ({"names": ("omega", "omega")}, "one parameter"),
        ({"quiet": "loud"}, "loud"),
        ({"start": [5.0]}, "start"),
        ({"lines": -1}, "lines"),
    ],
)
def test_what_does_not_fit_is_refused(change, said):
    usual = {"lower": (0.7, 0.9), "upper": (0.72, 1.1), "values": {"omega": 0.71}, "lines": 0}
    arguments = {"names": ("omega", "D"), **usual, **change}
    with pytest.raises(gl.GearlashError, match=said):
        gl.plane_zone(gl.load_case("kahraman-singh"), **arguments)


def test_a_motion_that_is_not_quiet_has_no_zone():
    case = gl.load_case("kahraman-singh")
    with pytest.raises(gl.GearlashError, match="1-1-0, which is not impact-free"):
        gl.plane_zone(case, ("omega", "D"), lower=(0.85, 0.9), upper=(0.95, 1.1), values={"omega": 0.9})


@pytest.mark.slow
def test_a_zone_that_lies_over_itself_behind_a_cusp():
    """Two folds leave a cusp: the zone goes round it, and both are told."""
    zone = gl.plane_zone(
        gl.load_case("two-stage"), ("omega", "load"), lower=(0.65, 0.12), upper=(0.75, 0.14),
        quiet="drive-side-only", values={"omega": 0.7, "load": 0.132}, lines=0,
    )  # fmt: skip
    assert zone.complete
    assert [str(part.kind) for part in zone.parts] == ["fold"]
    assert sorted(map(tuple, zone.outline.tolist())) == [
        (0.65, 0.12),
        (0.65, 0.14),
        (0.75, 0.12),
        (0.75, 0.14),
    ]
    assert zone.contains(0.711, 0.1205)
    (note,) = zone.notes
    assert "cusp at omega = 0.717375, load = 0.12553" in note


def test_a_search_that_is_stopped_keeps_what_it_has():
    cancel, orbits = threading.Event(), []

    def hear(progress: gl.Progress) -> None:
        orbits.append(progress.done)
        if progress.done == 6:
            cancel.set()

    zone = gl.plane_zone(
        gl.load_case("kahraman-singh"), ("omega", "D"), lower=(0.78, 0.9), upper=(0.85, 1.1),
        values={"omega": 0.8}, execution=gl.Execution(progress=hear, cancel=cancel),
    )  # fmt: skip
    assert not zone.complete
    assert "stopped" in zone.notes
    assert not all(margin.bounded for margin in zone.margins)
    assert len(orbits) < 12
