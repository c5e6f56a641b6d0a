"""Newton's method along a parameter that has a range, and members that cannot be built: never a raise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash.branches import locate_grazing, locate_multiplier
from gearlash.orbits import grazing_checks
from gearlash.system import Family, GearlashError, Status
from oracles import closed_forms
from orbits.members import one_dof, orbit

ZETA = 0.1


def narrowed(family: Family, name: str, lower: float, upper: float) -> Family:
    """The same family with a smaller range of one parameter."""
    parameters = tuple(
        replace(p, lower=lower, upper=upper, default=min(max(p.default, lower), upper))
        if p.name == name
        else p
        for p in family.parameters
    )
    return replace(family, parameters=parameters)


def unbuildable(family: Family, name: str, upper: float, error: Exception) -> Family:
    """The same family, where members beyond a value raise when they are built."""

    def build(values):
        if values[name] > upper:
            raise error
        return family.build(values)

    return replace(family, build=build)


@pytest.mark.parametrize("omega", [0.4, 0.7, 1.4, 2.0])
@pytest.mark.parametrize("name", ["mesh_damping", "error", "D"])
def test_no_touch_in_the_range(omega, name):
    """A load twice as large as any amplitude that this parameter can make: no touch anywhere."""
    load = 2.0 * closed_forms.spur_grazing_load(omega, 0.1, 0.0)
    values = {"omega": omega, "load": load, "error": 0.1, "mesh_damping": ZETA / 2}
    family = narrowed(one_dof(), "error", 0.0, 0.15) if name == "error" else one_dof()
    for check in grazing_checks(found := orbit(family, **values)):
        point = locate_grazing(family, name, found, check, values=family.complete(values))
        assert point.status in (Status.NOT_CONVERGED, Status.NOT_ADMISSIBLE)
        family.complete({name: point.value})  # in the range, or it raises


@pytest.mark.parametrize("share", [0.5, 1.0 - 1e-7, 1.0, 1.0 + 1e-7, 1.5])
def test_the_end_of_the_range_beside_the_touch(share):
    """The touch is found wherever it lies in the closed range, up to its very end, and never outside."""
    exact = closed_forms.spur_grazing_load(0.7, 0.1, ZETA)
    family = narrowed(one_dof(), "load", share * exact, 1.0)
    values = {"omega": 0.7, "load": 1.6 * exact, "error": 0.1, "mesh_damping": ZETA / 2}
    found = orbit(family, **values)
    point = locate_grazing(family, "load", found, grazing_checks(found)[0], values=family.complete(values))
    assert point.value >= share * exact
    if share < 1.0:
        assert point.status is Status.OK
        assert point.value == pytest.approx(exact, rel=1e-12)
    elif share > 1.0:
        assert point.status is Status.NOT_CONVERGED
    else:  # below it there is nothing to read a label from
        assert point.value == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize(
    "error", [GearlashError("too stiff"), np.linalg.LinAlgError("singular")], ids=["own", "linear algebra"]
)
@pytest.mark.parametrize("multiplier", [None, 1, -1])
def test_members_that_cannot_be_built(error, multiplier):
    """The touch lies beyond what can be built: not converged. No multiplier is ±1: the same."""
    load, start = 0.1, 0.02
    touch = load / closed_forms.spur_grazing_load(0.7, 1.0, ZETA)
    last = 0.5 * (start + touch)
    values = {"omega": 0.7, "load": load, "error": start, "mesh_damping": ZETA / 2}
    family = unbuildable(one_dof(), "error", last, error)
    found = orbit(family, **values)
    if multiplier is None:
        check = grazing_checks(found)[0]
        assert locate_grazing(one_dof(), "error", found, check, values=family.complete(values)).status.ok
        point = locate_grazing(family, "error", found, check, values=family.complete(values))
    else:
        point = locate_multiplier(family, "error", found, multiplier, values=family.complete(values))
    assert point.status is Status.NOT_CONVERGED
    assert point.value <= last


@pytest.mark.parametrize("multiplier", [1, -1])
@pytest.mark.parametrize("name", ["omega", "mesh_damping", "load", "error", "D", "ripple"])
def test_no_multiplier_of_this_kind(name, multiplier):
    """Constant stiffness in contact: the multipliers do not depend on load, error and gap, and are not ±1;
    whatever else is varied, what is returned is a member of the family."""
    values = {"omega": 0.4, "load": 1.0, "error": 0.02, "mesh_damping": ZETA / 2}
    found = orbit(one_dof(), **values)
    point = locate_multiplier(one_dof(), name, found, multiplier, values=one_dof().complete(values))
    one_dof().complete({name: point.value})
    if name in ("load", "error", "D"):
        assert point.status is Status.NOT_CONVERGED
