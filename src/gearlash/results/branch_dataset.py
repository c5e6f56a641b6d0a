"""A branch as one labelled dataset."""

from __future__ import annotations

import json
from collections.abc import Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case
from gearlash.system import Family, given

from .branch_extremes import measured
from .dataset import FORMAT_VERSION, family_of
from .physical import physical_unit, physical_values
from .provenance import held_along, provenance
from .variables import Variable, dimension

if TYPE_CHECKING:
    import xarray as xr

    from gearlash.branches.continuation import Branch, BranchPoint, SpecialPoint


def _same(name: str, long_name: str, dtype: str = "f8", units: str = "1", quantity: str = "") -> Variable:
    return Variable(name, long_name, attrgetter(name), dtype, units, quantity)


POINTWISE = (
    _same("arclength", "from the first orbit, in scaled unknowns"),
    _same("turn", "how fast the parameter changes along the branch, scaled; zero at a fold"),
    Variable("label", "signature P-Q-R (and /Q-R of every further clearance)", lambda p: str(p.label), "U"),
    _same("period", "least period P", "i4", "cycles"),
    Variable("drive", "impacts Q on the drive side per period", lambda p: p.signature.drive, "i4"),
    Variable("back", "impacts R on the back side per period", lambda p: p.signature.back, "i4"),
    Variable(
        "other_impacts",
        "impacts in all further clearances",
        lambda p: sum(map(sum, p.signature.others)),
        "i4",
    ),
    _same("unstable", "multipliers outside the unit circle", "i4"),
    _same("stable", "whether no multiplier lies outside the unit circle", "?"),
    _same("residual", "of the closed orbit, of each state relative to what rounding acts on"),
    _same("error", "estimate of the error of the state"),
    Variable("status", "outcome of the computation", lambda p: str(p.status), "U"),
    Variable("certificate", "certified, uncertain or failed", lambda p: str(p.certificate.verdict), "U"),
    Variable("certificate_reason", "why it is not certified", lambda p: p.certificate.reason, "U"),
)
BOUNDARIES = (
    Variable(
        "boundary_plus",
        "X at the boundary on the drive side; NaN where that side does not act",
        float,
        quantity="length",
    ),
    Variable(
        "boundary_minus",
        "X at the boundary on the back side; NaN where that side does not act",
        float,
        quantity="length",
    ),
)
MEASURED = (
    Variable("minimum", "least X", float, quantity="length"),
    Variable("maximum", "largest X", float, quantity="length"),
    Variable("force_min", "least contact force Φ", float, quantity="force"),
    Variable("force_max", "largest contact force Φ", float, quantity="force"),
    Variable("force_rms", "rms of the contact force Φ", float, quantity="force"),
    Variable("share_without_contact", "share of time without contact, 0 to 1", float),
)
STROBES = Variable("strobes", "X on σ_t", float, quantity="length")
SPECIAL = (
    _same("value", "parameter at the special point"),
    _same("error", "estimate of the error of that value"),
    _same("arclength", "from the first orbit, in scaled unknowns"),
    Variable("kind", "what happens there", lambda s: str(s.kind), "U"),
    _same("note", "the kind in words, of a graze with its boundary", "U"),
    Variable("label_before", "label of the orbit before it", lambda s: str(s.label_before), "U"),
    Variable("label_after", "label of the orbit after it", lambda s: str(s.label_after), "U"),
    _same("unstable_before", "multipliers outside the unit circle before it", "i4"),
    _same("unstable_after", "multipliers outside the unit circle after it", "i4"),
    Variable("from", "parameter of the orbit before it", lambda s: s.interval[0]),
    Variable("to", "parameter of the orbit after it", lambda s: s.interval[1]),
    Variable("clearance", "index of the gap that is touched, -1: none", lambda s: _touched(s)[0], "i4"),
    Variable("boundary", "1: drive side is touched, -1: back side, 0: none", lambda s: _touched(s)[1], "i4"),
)
TAKEN = frozenset(
    [
        *(v.name for v in (*POINTWISE, *BOUNDARIES, *MEASURED)),
        *(f"special_{v.name}" for v in (*SPECIAL, *MEASURED)),
        "point", "special", "end", "state", "state_name", "strobe", "strobes", "multiplier",
        "multiplier_real", "multiplier_imag", "multiplier_modulus", "special_strobes", "end_kind",
        "end_value", "end_note",
    ]
)  # fmt: skip
"""Names in this dataset that no parameter can have there."""


def branch_dataset(model: Case | Family, branch: Branch, *, extremes: bool = True) -> xr.Dataset:
    """A branch as a dataset, with units and provenance.

    Dimensions: ``point`` (the orbits in their order along the branch, so the parameter, a coordinate, may
    turn round), ``state_name``, ``strobe``, ``multiplier``, ``special`` and ``end``.

    Parameters
    ----------
    model : Case or Family
        That of the branch.
    branch : Branch
    extremes : bool
        Whether extremes of X and of the contact force of every orbit, of the first clearance, are computed,
        by the exact flow: some milliseconds for every base period.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    GearlashError
        For a branch of a parameter that the model does not have.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> dataset = gl.branch_dataset(case, branch)
    >>> dataset["special_kind"].values.tolist()
    ['grazing', 'fold', 'fold', 'grazing']
    >>> gl.table(dataset)["stable"].all()
    np.False_
    """
    import xarray as xr

    from gearlash.branches.continuation import Branch

    family = family_of(model)
    given.instance("branch", branch, Branch, "a Branch, as from gearlash.continue_branch")
    given.known("parameter", branch.name, family.defaults)
    extremes = given.truth("extremes", extremes)
    along = ("point",)
    data = _table(model, POINTWISE, branch.points, along)
    data |= _boundaries(model, family, branch)
    data |= _measured(model, family, branch, branch.points, extremes, along)
    data |= _multipliers(branch.points, along)
    about = {"long_name": "state at phase zero", "units": "1"}
    data["state"] = (("point", "state_name"), np.array([point.state for point in branch.points]), about)
    data |= _special(model, family, branch, extremes) | _ends(branch)
    return xr.Dataset(data, _coordinates(model, family, branch), _attributes(model, branch))


def _touched(special: SpecialPoint) -> tuple[int, int]:
    """Clearance and boundary of a graze."""
    extremum = special.extremum
    return (-1, 0) if extremum is None else (extremum.clearance, extremum.boundary)


def _table(
    model: Case | Family,
    variables: Sequence[Variable],
    rows: Sequence[Any],
    dims: tuple[str, ...],
    of: str = "",
) -> dict[str, Any]:
    return {
        f"{of}{each.name}": _array(model, each, dims, np.array([each.read(row) for row in rows], each.dtype))
        for each in variables
    }


def _array(model: Case | Family, variable: Variable, dims: tuple[str, ...], values: np.ndarray):
    about: dict[str, Any] = {"long_name": variable.long_name, "units": variable.units}
    return dims, values, about | physical_unit(model, variable)


def _boundaries(model: Case | Family, family: Family, branch: Branch) -> dict[str, Any]:
    """X at which the motion meets either side of the first clearance, at every point."""
    rows = []
    for value in branch.parameter.tolist():
        gap = family.system({**branch.values, branch.name: value}).clearances[0]
        edges = ((gap.gap_plus, gap.stops(1)), (-gap.gap_minus, gap.stops(-1)))
        rows.append([edge if acts else np.nan for edge, acts in edges])
    table = np.array(rows, dtype=np.float64).reshape(-1, 2).T
    return {
        each.name: _array(model, each, ("point",), column)
        for each, column in zip(BOUNDARIES, table, strict=True)
    }


def _measured(
    model: Case | Family,
    family: Family,
    branch: Branch,
    points: Sequence[BranchPoint],
    extremes: bool,
    dims: tuple[str, ...],
    of: str = "",
) -> dict[str, Any]:
    """Extremes of motion and force, and X at the strobes, padded with NaN."""
    found = measured(family, branch, points, extremes)
    data = {}
    for each in MEASURED if extremes else ():
        data[f"{of}{each.name}"] = _array(
            model, each, dims, np.array([figures[each.name] for figures, _ in found], "f8")
        )
    strobes = np.full((len(found), max((len(x) for _, x in found), default=1)), np.nan)
    for row, (_, x) in zip(strobes, found, strict=True):
        row[: len(x)] = x
    data[f"{of}strobes"] = _array(model, STROBES, (*dims, f"{of}strobe"), strobes)
    return data


def _special(model: Case | Family, family: Family, branch: Branch, extremes: bool) -> dict[str, Any]:
    """The special points, with the same numbers of their orbits."""
    dims = ("special",)
    data = _table(model, SPECIAL, branch.special, dims, "special_")
    values = np.array([special.value for special in branch.special], dtype=np.float64)
    for name, numbers, unit in physical_values(model, branch.name, values):
        about = {"long_name": f"{name.replace('_', ' ')} at the special point", "units": unit}
        data[dimension(f"special_{name}", TAKEN)] = (dims, numbers, about)
    points = [special.point for special in branch.special]
    data |= _multipliers(points, dims, "special_")
    return data | _measured(model, family, branch, points, extremes, dims, "special_")


def _multipliers(points: Sequence[BranchPoint], dims: tuple[str, ...], of: str = "") -> dict[str, Any]:
    width = max((len(point.multipliers) for point in points), default=1)
    table = np.full((len(points), width), np.nan, dtype=np.complex128)
    for row, point in zip(table, points, strict=True):
        row[:] = point.multipliers
    found = {}
    for part, read in (("real", np.real), ("imag", np.imag), ("modulus", np.abs)):
        about = {"long_name": f"Floquet multipliers, {part}, by modulus, descending", "units": "1"}
        found[f"{of}multiplier_{part}"] = ((*dims, f"{of}multiplier"), read(table), about)
    return found


def _ends(branch: Branch) -> dict[str, Any]:
    ends = branch.ends
    about = {"long_name": "why the branch was not followed farther", "units": "1"}
    return {
        "end_kind": (("end",), [str(end.kind) for end in ends], about),
        "end_value": (("end",), [end.value for end in ends], {"long_name": "parameter there", "units": "1"}),
        "end_note": (("end",), [end.note for end in ends], {"long_name": "evidence in words", "units": "1"}),
    }


def _coordinates(model: Case | Family, family: Family, branch: Branch) -> dict[str, Any]:
    description = next((p.description for p in family.parameters if p.name == branch.name), "")
    about = {"long_name": description or branch.name, "units": "1"}
    own = dimension(branch.name, TAKEN)
    found: dict[str, Any] = {
        own: (("point",), branch.parameter, about),
        "state_name": ("state_name", list(family.states), {"long_name": "names of the states"}),
    }
    for name, values, unit in physical_values(model, branch.name, branch.parameter):
        found[name] = (("point",), values, {"long_name": name.replace("_", " "), "units": unit})
    return found


def _attributes(model: Case | Family, branch: Branch) -> dict[str, Any]:
    fixed = {name: value for name, value in branch.values.items() if name != branch.name}
    return {
        "gearlash_format": FORMAT_VERSION,
        "title": f"branch over {branch.name}",
        "axis": branch.name,
        "lower": branch.lower,
        "upper": branch.upper,
        "parameters": json.dumps(fixed),
        "complete": int(all(str(end.kind) != "cancelled" for end in branch.ends)),
        "unexplained": json.dumps(list(branch.unexplained), ensure_ascii=False),
        **provenance(model),
        **held_along(model, [branch.name]),
    }
