"""The figure that goes with a result, whatever kind of result that is."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from gearlash.branches.continuation import Branch
from gearlash.case import Case
from gearlash.orbits import Aperiodic, Orbit
from gearlash.results import PlaneMap, Sweep, plane_dataset, sweep_dataset
from gearlash.results.branch_dataset import branch_dataset
from gearlash.studies import Zones
from gearlash.studies.motion import Motion, motion
from gearlash.system import Family, GearlashError, given

from .bifurcation import diagram
from .branch_diagram import branch_diagram
from .plane import plane
from .portraits import portrait
from .units import Units


def draw(result: Any, model: Case | Family | None = None) -> Figure:
    """The figure that goes with a result.

    Parameters
    ----------
    result : Orbit, Aperiodic, Motion, Sweep, Zones, PlaneMap, Branch, or sequence of Sweep or Branch
        A motion is drawn as its phase portrait, sweeps and zones as a bifurcation diagram, a map as a plane,
        branches over their parameter.
    model : Case or Family, optional
        What was asked about. All but motions need it; of a case the figure has axes with units.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For anything else, or where ``model`` is missing.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system(), family.start())
    >>> len(plots.draw(found).axes)
    1
    """
    if model is not None:
        given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
    units = Units.of(model) if isinstance(model, Case) else Units()
    if isinstance(result, (Orbit, Aperiodic)):
        return portrait(motion(result), units)
    if isinstance(result, Motion):
        return portrait(result, units)
    sweeps, branches = _sweeps(result), _branches(result)
    if not (sweeps or branches or isinstance(result, PlaneMap)):
        expected = "an attractor, a Motion, sweeps, Zones, a PlaneMap or branches"
        raise GearlashError(f"nothing to draw: expected {expected}, not {given.kind_of(result)}")
    if model is None:
        raise GearlashError(f"{given.kind_of(result)} is drawn with its case or family: draw(result, case)")
    if isinstance(result, PlaneMap):
        return plane(plane_dataset(model, result), units)
    if branches:
        return branch_diagram([branch_dataset(model, each) for each in branches], units=units)
    return diagram(sweep_dataset(model, sweeps), units=units)


def _sweeps(result: Any) -> tuple[Sweep, ...]:
    """One sweep, several, or those behind zones; else none."""
    if isinstance(result, Sweep):
        return (result,)
    if isinstance(result, Zones):
        return result.sweeps
    several = isinstance(result, (list, tuple)) and all(isinstance(each, Sweep) for each in result)
    return tuple(result) if several else ()


def _branches(result: Any) -> tuple[Branch, ...]:
    """One branch, or several; else none."""
    if isinstance(result, Branch):
        return (result,)
    several = isinstance(result, (list, tuple)) and all(isinstance(each, Branch) for each in result)
    return tuple(result) if several else ()
