"""Memory is known before tables are built; what would take too much is refused, and told what makes it so."""

from __future__ import annotations

import time
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

import gearlash as gl
from gearlash import flow
from gearlash.flow.budget import VARIABLE, allowed, needed, regions_likely
from gearlash.flow.regions import first_guess
from gearlash.system import Clearance, ContactRule, Family, GearlashError, Parameter, System


def stop(
    omega: float = 0.8,
    stiffness: float = 8.0,
    damping: float = 0.0,
    n: int = 2,
    own_damping: float = 0.05,
    contact: ContactRule = ContactRule.ALWAYS,
) -> System:
    """Masses on springs of their own, the first with a stop on one side."""
    matrix, forcing, h, g = np.zeros((n, n)), np.zeros((n, 3)), np.zeros(n), np.zeros(n)
    for i in range(0, n, 2):
        matrix[i, i + 1] = 1.0
        matrix[i + 1, i : i + 2] = -(1.0 + i), -2.0 * own_damping
    forcing[1, 1] = h[0] = 1.0
    g[1] = -1.0
    clearance = Clearance(
        h, g, 0.5, 100.0, np.array([stiffness]), np.zeros(1), damping, contact=contact, name="stop"
    )
    return System(omega, matrix, forcing, (clearance,))


def pair(**overrides: str) -> System:
    return gl.load_case("article", overrides).family()[0].system()


def series(forced: int = 1, moved: int = 1) -> System:
    """A stop whose forcing and stiffness have one high harmonic."""
    system = stop()
    forcing, stiffness = np.zeros((2, 2 * forced + 1)), np.zeros(2 * moved + 1)
    forcing[1, -2], stiffness[0], stiffness[-2] = 1.0, 8.0, 1.0
    changed = replace(system.clearances[0], stiffness_plus=stiffness)
    return replace(system, forcing=forcing, clearances=(changed,))


def drift(omega: float) -> System:
    """A contact that drives a state at a constant speed: no rate tells how far it goes in a period."""
    h, g = np.array([0.0, 1.0]), np.array([-1.0, 0.0])
    clearance = Clearance(h, g, 0.5, 0.5, np.ones(1), np.zeros(1))
    return System(omega, np.zeros((2, 2)), np.eye(2, 3), (clearance,))


def gaps(count: int, omega: float) -> System:
    """Masses on springs of their own, one beside the other, each with a gap to the next."""
    n = 2 * count
    matrix, forcing, found = np.zeros((n, n)), np.zeros((n, 3)), []
    for c in range(count):
        i = 2 * c
        matrix[i, i + 1], matrix[i + 1, i : i + 2] = 1.0, (-1.0 - c, -0.1)
        forcing[i + 1, 1:] = 1.0 + c, c
        h, g = np.zeros(n), np.zeros(n)
        h[i], h[(i + 2) % n], g[i + 1] = 1.0, -0.5, -1.0
        found.append(Clearance(h, g, 0.2, 0.3, np.array([8.0 + c]), np.array([20.0 + c]), name=f"gap {c}"))
    return System(omega, matrix, forcing, tuple(found))


TOO_MUCH = {
    "stiffness": (lambda: stop(stiffness=1e9), "stiffness = 1e+09 of side + of 'stop'", "stiffness smaller"),
    "frequency": (lambda: stop(omega=1e-4), "omega = 0.0001 is slow beside the rate", "raise omega"),
    "contact damping": (
        lambda: stop(stiffness=1e4, damping=2e4),
        "damping = 20000 of 'stop'",
        "damping smaller",
    ),
    "contact damping that comes and goes": (
        lambda: stop(stiffness=1e4, damping=2e4, contact=ContactRule.IN_CONTACT),
        "damping = 20000 of side + of 'stop'",
        "damping smaller",
    ),
    "own damping": (lambda: stop(own_damping=1e4), "which the matrix makes", "fastest rate smaller"),
    "states": (lambda: stop(omega=0.001, n=40), "for 40 states", "raise omega"),
    "cells": (lambda: stop(stiffness=1e12), "more than 200,000: omega = 0.8", "stiffness smaller"),
    "beyond numbers": (lambda: stop(omega=1e-300), "cells a period would be needed", "raise omega"),
    "pair": (lambda: pair(pinion_speed="0.1 rpm"), "for 10 states would take", "raise omega"),
    "harmonics of a forcing": (
        lambda: series(forced=70_000),
        "harmonic 70000 of a forcing",
        "use fewer harmonics",
    ),
    "harmonics of a stiffness": (
        lambda: series(moved=70_000),
        "harmonic 70000 of a stif",
        "use fewer harmonics",
    ),
}


@pytest.mark.parametrize(("make", "cause", "advice"), TOO_MUCH.values(), ids=TOO_MUCH)
def test_what_would_take_too_much_is_refused_at_once_with_its_cause(make, cause: str, advice: str):
    system = make()
    flow.propagators(stop())  # what is loaded with the first one
    tracemalloc.start()
    began = time.monotonic()
    try:
        with pytest.raises(GearlashError) as refused:
            flow.propagators(system)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert cause in str(refused.value)
    assert advice in str(refused.value)
    assert len(str(refused.value)) < 500
    assert peak < 10_000_000
    assert time.monotonic() - began < 5.0


def test_more_may_be_allowed_and_less(monkeypatch: pytest.MonkeyPatch):
    system = stop(stiffness=1e6)
    monkeypatch.setenv(VARIABLE, "10 MB")
    with pytest.raises(GearlashError, match=rf"more than the 10 MB allowed.*{VARIABLE}=\d+MB"):
        flow.propagators(system)
    monkeypatch.setenv(VARIABLE, "0.2 GiB")
    assert allowed() == pytest.approx(0.2 * 2**30)
    assert flow.propagators(system).cells > 1000


@pytest.mark.parametrize("text", ["much", "-1GB", "1", "1 PB", "9" * 400 + "GB", "1e9", "nanGB"])
def test_a_size_that_is_none(text: str, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv(VARIABLE, text)
    with pytest.raises(GearlashError, match=f"{VARIABLE} = .*expected a size such as 500MB"):
        flow.propagators(stop())


BOTH = np.array([50.0])
MEASURED = [
    stop(stiffness=1e6),
    stop(omega=0.01, n=12),
    replace(
        stop(omega=0.01), clearances=(replace(stop().clearances[0], stiffness_minus=BOTH, gap_minus=0.1),)
    ),
]


@pytest.mark.parametrize("system", MEASURED, ids=["stiff", "many states", "two sides"])
def test_the_estimate_is_what_is_taken(system: System):
    tracemalloc.start()
    try:
        props = flow.propagators(system)
        flow.march(props, np.full(system.size, 0.3), 3)
        taken = tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
    # reserved is room for every side that acts, of which untouched pages take no memory
    stops = sum(system.clearances[0].stops(side) for side in (1, -1))
    assert taken == pytest.approx(needed(props.shape, 1 + stops, len(props.units)), rel=0.1)


def wander(props: flow.Propagators) -> bytes:
    """Motions from here and there."""
    starts = (np.arange(props.system.size) - size for size in range(12))
    return b"".join(flow.march(props, start, 4).states.tobytes() for start in starts)


def test_regions_of_many_gaps_are_held_to_the_budget_as_they_are_met(monkeypatch: pytest.MonkeyPatch):
    """That motions come to all of 3^gaps is not likely; but whatever they come to, it stays below."""
    monkeypatch.setenv(VARIABLE, "20MB")
    props = flow.propagators(gaps(3, 0.4))
    tracemalloc.start()
    try:
        with pytest.raises(GearlashError, match=r"tables of \d\d contact states, .* more than the 20 MB"):
            wander(props)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 20_000_000
    met = len(props.responses)
    assert met > regions_likely(props.system)
    assert 0.8 * 20e6 < needed(props.shape, met, len(props.units)) <= 20e6
    monkeypatch.setenv(VARIABLE, "100MB")  # what was there stays, more is added behind it
    assert wander(props) == wander(flow.propagators(props.system))
    assert len(props.responses) > met


def test_a_grid_is_found_where_rates_say_little(monkeypatch: pytest.MonkeyPatch):
    props = flow.propagators(drift(1e-5))
    assert props.cells > 100 * first_guess(props.system)
    monkeypatch.setenv(VARIABLE, "10MB")
    with pytest.raises(
        GearlashError, match=r"would need 4 cells, but coefficients from 1 to 1 over .*; raise om"
    ):
        flow.propagators(drift(1e-5))


def test_statistics_of_a_motion_of_many_cells_take_less_than_its_tables():
    props = flow.propagators(stop(omega=0.004))
    found = gl.attractor(props, np.zeros(2))
    assert len(found.trace.lengths) > 2_500
    gl.motion_statistics(gl.attractor(flow.propagators(stop()), np.zeros(2)))  # what is loaded with the first
    tracemalloc.start()
    try:
        gl.motion_statistics(found)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < needed(props.shape, 2, len(props.units))


def stiff_family() -> Family:
    parameters = (Parameter("omega", 0.8), Parameter("k", 8.0))
    return Family(parameters, ("x", "v"), lambda p: stop(p["omega"], p["k"]), lambda p: np.zeros(2))


def test_a_point_that_would_take_too_much_fails_alone(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv(VARIABLE, "50MB")
    family = stiff_family()
    axis = gl.Axis("k", np.array([8.0, 1e8, 1e9, 9.0e9]))
    found = gl.sweep(family, axis)
    assert [bool(point.label) for point in found.points] == [True, False, False, False]
    assert "more than the 50 MB allowed" in found.points[1].message
    plane = gl.map_plane(family, axis, gl.Axis("omega", np.array([0.7, 0.8])))
    assert set(plane.reasons) == {(i, j) for i in (0, 1) for j in (1, 2, 3)}
    assert all("allowed" in why or "more than 200,000" in why for why in plane.reasons.values())
    assert gl.point(family, {"k": 1e8}).status == "failed"
    zoned = gl.zones(family, gl.Axis("k", np.array([4.0, 8.0, 1e8])))
    for points in (swept.points for swept in zoned.sweeps):
        assert {point.value: point.status for point in points} == {4.0: "ok", 8.0: "ok", 1e8: "failed"}


def test_what_asks_for_one_system_is_refused(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv(VARIABLE, "50MB")
    family = stiff_family()
    system = family.system({"k": 1e8})
    orbit = gl.attractor(gl.propagators(family.system()), np.zeros(2))
    for ask in (
        lambda: gl.propagators(system),
        lambda: gl.attractor(system, np.zeros(2)),
        lambda: gl.propagators(system, orbit.propagators),
    ):
        with pytest.raises(GearlashError, match="more than the 50 MB allowed"):
            ask()
