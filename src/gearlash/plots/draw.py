"""The figure that goes with a result, whatever kind of result that is."""

from __future__ import annotations

from typing import Any, TypeVar

from matplotlib.figure import Figure

from gearlash.branches.continuation import Branch
from gearlash.branches.curves import Curve
from gearlash.case import Case
from gearlash.orbits import Aperiodic, Orbit
from gearlash.results import PlaneMap, Sweep, plane_dataset, sweep_dataset
from gearlash.results.atlas import Atlas
from gearlash.results.branch_dataset import branch_dataset
from gearlash.studies import Zones
from gearlash.studies.joined import apart_in
from gearlash.studies.motion import Motion, motion
from gearlash.system import Family, GearlashError, given

from .atlas_diagram import atlas_diagram
from .bifurcation import diagram
from .branch_diagram import branch_diagram
from .curve_diagram import curve_diagram
from .plane import plane
from .portraits import portrait
from .units import Units

Thing = TypeVar("Thing")


def draw(result: Any, model: Case | Family | None = None) -> Figure:
    """The figure that goes with a result.

    Parameters
    ----------
    result : Orbit, Aperiodic, Motion, Sweep, Zones, PlaneMap, Branch, Curve, Atlas, or sequence of the like
        A motion is drawn as its phase portrait, sweeps and zones as a bifurcation diagram, a map as a plane,
        branches over their parameter, curves in the plane of theirs. There may be several sweeps, branches or
        curves.
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
    sweeps, branches, curves = _sweeps(result), _several(result, Branch), _several(result, Curve)
    if not (sweeps or branches or curves or isinstance(result, PlaneMap | Atlas)):
        expected = "an attractor, a Motion, sweeps, Zones, a PlaneMap, branches, curves or an Atlas"
        raise GearlashError(f"nothing to draw: expected {expected}, not {given.kind_of(result)}")
    if model is None:
        raise GearlashError(f"{given.kind_of(result)} is drawn with its case or family: draw(result, case)")
    if isinstance(result, PlaneMap):
        return plane(plane_dataset(model, result), units)
    if isinstance(result, Atlas):
        return atlas_diagram(result, model)
    if branches:
        return branch_diagram([branch_dataset(model, each) for each in branches], units=units)
    if curves:
        return curve_diagram(curves, model)
    return diagram(sweep_dataset(model, sweeps), units=units, apart=apart_in(model, sweeps))


def _sweeps(result: Any) -> tuple[Sweep, ...]:
    """One sweep, several, or those behind zones; else none."""
    return result.sweeps if isinstance(result, Zones) else _several(result, Sweep)


def _several(result: Any, kind: type[Thing]) -> tuple[Thing, ...]:
    """One thing of a kind, or several; else none."""
    if isinstance(result, kind):
        return (result,)
    several = isinstance(result, (list, tuple)) and all(isinstance(each, kind) for each in result)
    return tuple(result) if several else ()
