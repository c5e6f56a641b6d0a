"""Branches on disk: JSON with every number to its last digit, a version, and where it comes from."""

from __future__ import annotations

from math import inf, isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np

from gearlash.branches.continuation import (
    Branch,
    BranchPoint,
    DerivativeKind,
    EndKind,
    EndOfBranch,
    Extremum,
    SpecialKind,
    SpecialPoint,
)
from gearlash.case import Case
from gearlash.orbits import Certificate, Signature, Verdict
from gearlash.system import Family, Status, given

from .store import new_file, write_whole
from .versioned_file import VersionedFile

FILE = VersionedFile("branch", version=1)


def save_branch(branch: Branch, path: str | Path, model: Case | Family) -> Path:
    """Writes a branch to a file, with the case it is of; an older file is replaced.

    Parameters
    ----------
    branch : Branch
    path : str or Path
    model : Case or Family
        That of the branch.

    Returns
    -------
    Path
        Of the file.

    Raises
    ------
    OSError
        Where it cannot be written.

    Examples
    --------
    >>> import gearlash as gl, tempfile
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=1.4, upper=1.6, values={"omega": 1.5})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = gl.save_branch(branch, f"{folder}/branch.json", case)
    ...     again = gl.load_branch(path)
    >>> again.points[3].value == branch.points[3].value
    True
    """
    given.instance("branch", branch, Branch, "a Branch, as from gearlash.continue_branch")
    given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
    path = new_file(path)
    write_whole(path, branch_text(branch, model))
    return path


def branch_text(branch: Branch, model: Case | Family) -> bytes:
    """The content of the file of a branch."""
    return FILE.text(_branch(branch), model)


def load_branch(path: str | Path) -> Branch:
    """The branch of a file; any of its points starts `continue_branch` again.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    Branch

    Raises
    ------
    GearlashError
        For a file that `save_branch` did not write, or of a later version.

    Examples
    --------
    >>> import gearlash as gl, tempfile
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=1.4, upper=1.6, values={"omega": 1.5})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     again = gl.load_branch(gl.save_branch(branch, f"{folder}/branch.json", case))
    >>> print(again.points[0].label)
    1-1-0
    """
    return FILE.read(path, _as_branch)


def _branch(branch: Branch) -> dict[str, Any]:
    return {
        "name": branch.name,
        "values": dict(branch.values),
        "lower": branch.lower,
        "upper": branch.upper,
        "scale": branch.scale.tolist(),
        "points": [_point(point) for point in branch.points],
        "special": [_special(special) for special in branch.special],
        "ends": [{"kind": str(end.kind), "value": end.value, "note": end.note} for end in branch.ends],
        "unexplained": list(branch.unexplained),
        "derivative": None if branch.derivative is None else str(branch.derivative),
        "derivative_error": branch.derivative_error if isfinite(branch.derivative_error) else None,
    }


def _as_branch(stored: dict[str, Any]) -> Branch:
    name, values = stored["name"], {each: float(value) for each, value in stored["values"].items()}
    derivative, error = (stored.get(each) for each in ("derivative", "derivative_error"))  # not in old files
    return Branch(
        name=name,
        values=values,
        lower=stored["lower"],
        upper=stored["upper"],
        scale=np.array(stored["scale"], dtype=np.float64),
        points=tuple(_as_point(point) for point in stored["points"]),
        special=tuple(_as_special(special, name, values) for special in stored["special"]),
        ends=tuple(EndOfBranch(EndKind(end["kind"]), end["value"], end["note"]) for end in stored["ends"]),
        unexplained=tuple(stored["unexplained"]),
        derivative=None if derivative is None else DerivativeKind(derivative),
        derivative_error=nan if error is None else error,
    )


def _point(point: BranchPoint) -> dict[str, Any]:
    return {
        "value": point.value,
        "arclength": point.arclength,
        "strobes": point.strobes.tolist(),
        "turn": point.turn,
        "signature": str(point.signature),
        "multipliers": [[value.real, value.imag] for value in point.multipliers.tolist()],
        "extrema": [list(extremum) for extremum in point.extrema],
        "born": list(point.born),
        "died": list(point.died),
        "residual": point.residual,
        "error": point.error if isfinite(point.error) else None,
        "certificate": {
            "verdict": str(point.certificate.verdict),
            "reasons": list(point.certificate.reasons),
        },
        "status": str(point.status),
    }


def _as_point(stored: dict[str, Any]) -> BranchPoint:
    certificate = stored["certificate"]
    strobes = np.array(stored["strobes"], dtype=np.float64)
    return BranchPoint(
        value=stored["value"],
        arclength=stored["arclength"],
        state=strobes[0],
        strobes=strobes,
        turn=stored["turn"],
        signature=Signature.parse(stored["signature"]),
        multipliers=np.array([complex(*pair) for pair in stored["multipliers"]]),
        extrema=tuple(Extremum(*extremum) for extremum in stored["extrema"]),
        born=tuple(stored["born"]),
        died=tuple(stored["died"]),
        residual=stored["residual"],
        error=inf if stored["error"] is None else stored["error"],
        certificate=Certificate(Verdict(certificate["verdict"]), tuple(certificate["reasons"])),
        status=Status(stored["status"]),
    )


def _special(special: SpecialPoint) -> dict[str, Any]:
    return {
        "kind": str(special.kind),
        "value": special.value,
        "error": special.error if isfinite(special.error) else None,
        "interval": list(special.interval),
        "arclengths": list(special.arclengths),
        "point": _point(special.point),
        "label_before": str(special.label_before),
        "label_after": str(special.label_after),
        "unstable_before": special.unstable_before,
        "unstable_after": special.unstable_after,
        "extremum": None if special.extremum is None else list(special.extremum),
        "linear": special.linear,
        "note": special.note,
        "status": str(special.status),
    }


def _as_special(stored: dict[str, Any], name: str, values: dict[str, float]) -> SpecialPoint:
    extremum, error, point = stored["extremum"], stored["error"], _as_point(stored["point"])
    return SpecialPoint(
        kind=SpecialKind(stored["kind"]),
        value=stored["value"],
        error=inf if error is None else error,
        interval=(stored["interval"][0], stored["interval"][1]),
        arclengths=(stored["arclengths"][0], stored["arclengths"][1]),
        point=point,
        label_before=Signature.parse(stored["label_before"]),
        label_after=Signature.parse(stored["label_after"]),
        unstable_before=stored["unstable_before"],
        unstable_after=stored["unstable_after"],
        extremum=None if extremum is None else Extremum(*extremum),
        linear=stored["linear"],
        note=stored["note"],
        status=Status(stored["status"]),
        name=name,
        values={**values, name: point.value},
    )
