"""Curves on disk: JSON with every number to its last digit, a version, and where it comes from."""

from __future__ import annotations

from math import inf, isfinite
from pathlib import Path
from typing import Any

import numpy as np

from gearlash.branches.continuation import Extremum, SpecialKind
from gearlash.branches.curves import (
    CodimTwoKind,
    CodimTwoPoint,
    Curve,
    CurveEndKind,
    CurvePoint,
    EndOfCurve,
)
from gearlash.case import Case
from gearlash.system import Family, Signature, Status, given

from .store import new_file, write_whole
from .versioned_file import VersionedFile

FILE = VersionedFile("curve", version=1)


def save_curve(curve: Curve, path: str | Path, model: Case | Family) -> Path:
    """Writes a curve to a file, with the case it is of; an older file is replaced.

    Parameters
    ----------
    curve : Curve
    path : str or Path
    model : Case or Family
        That of the curve.

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
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[-1]
    >>> curve = gl.continue_curve(case, ("omega", "D"), fold, lower=(0.7, 0.9), upper=(0.8, 1.1))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = gl.save_curve(curve, f"{folder}/curve.json", case)
    ...     again = gl.load_curve(path)
    >>> again.points[3].values == curve.points[3].values
    True
    """
    given.instance("curve", curve, Curve, "a Curve, as from gearlash.continue_curve")
    given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
    path = new_file(path)
    write_whole(path, curve_text(curve, model))
    return path


def curve_text(curve: Curve, model: Case | Family) -> bytes:
    """The content of the file of a curve."""
    return FILE.text(_curve(curve), model)


def load_curve(path: str | Path) -> Curve:
    """The curve of a file; any of its points starts `continue_curve` again.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    Curve

    Raises
    ------
    GearlashError
        For a file that `save_curve` did not write, or of a later version.

    Examples
    --------
    >>> import gearlash as gl, tempfile
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[-1]
    >>> curve = gl.continue_curve(case, ("omega", "D"), fold, lower=(0.7, 0.9), upper=(0.8, 1.1))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     again = gl.load_curve(gl.save_curve(curve, f"{folder}/curve.json", case))
    >>> print(again.points[0].signature)
    1-1-0
    """
    return FILE.read(path, _as_curve)


def _curve(curve: Curve) -> dict[str, Any]:
    return {
        "kind": str(curve.kind),
        "names": list(curve.names),
        "values": dict(curve.values),
        "lower": list(curve.lower),
        "upper": list(curve.upper),
        "points": [_point(point) for point in curve.points],
        "special": [_special(special) for special in curve.special],
        "ends": [{"kind": str(end.kind), "values": list(end.values), "note": end.note} for end in curve.ends],
        "scale": curve.scale.tolist(),
    }


def _as_curve(stored: dict[str, Any]) -> Curve:
    one, two = stored["names"]
    return Curve(
        kind=SpecialKind(stored["kind"]),
        names=(one, two),
        values={name: float(value) for name, value in stored["values"].items()},
        lower=_pair(stored["lower"]),
        upper=_pair(stored["upper"]),
        points=tuple(_as_point(point) for point in stored["points"]),
        special=tuple(_as_special(special) for special in stored["special"]),
        ends=tuple(
            EndOfCurve(CurveEndKind(end["kind"]), _pair(end["values"]), end["note"]) for end in stored["ends"]
        ),
        scale=np.array(stored["scale"], dtype=np.float64),
    )


def _pair(stored: list[float]) -> tuple[float, float]:
    one, two = stored
    return float(one), float(two)


def _point(point: CurvePoint) -> dict[str, Any]:
    return {
        "values": list(point.values),
        "arclength": point.arclength,
        "state": point.state.tolist(),
        "period": point.period,
        "signature": str(point.signature),
        "multipliers": [[value.real, value.imag] for value in point.multipliers.tolist()],
        "touches": [list(extremum) for extremum in point.touches],
        "extrema": [list(extremum) for extremum in point.extrema],
        "residual": point.residual,
        "admissible": point.admissible,
        "status": str(point.status),
    }


def _as_point(stored: dict[str, Any]) -> CurvePoint:
    return CurvePoint(
        values=_pair(stored["values"]),
        arclength=stored["arclength"],
        state=np.array(stored["state"], dtype=np.float64),
        period=stored["period"],
        signature=Signature.parse(stored["signature"]),
        multipliers=np.array([complex(*pair) for pair in stored["multipliers"]]),
        touches=tuple(Extremum(*extremum) for extremum in stored["touches"]),
        extrema=tuple(Extremum(*extremum) for extremum in stored["extrema"]),
        residual=stored["residual"],
        admissible=stored["admissible"],
        status=Status(stored["status"]),
    )


def _special(special: CodimTwoPoint) -> dict[str, Any]:
    return {
        "kind": str(special.kind),
        "values": list(special.values),
        "errors": [error if isfinite(error) else None for error in special.errors],
        "point": _point(special.point),
        "label_before": str(special.label_before),
        "label_after": str(special.label_after),
        "solved": special.solved,
        "note": special.note,
        "status": str(special.status),
    }


def _as_special(stored: dict[str, Any]) -> CodimTwoPoint:
    one, two = (inf if error is None else error for error in stored["errors"])
    return CodimTwoPoint(
        kind=CodimTwoKind(stored["kind"]),
        values=_pair(stored["values"]),
        errors=(one, two),
        point=_as_point(stored["point"]),
        label_before=Signature.parse(stored["label_before"]),
        label_after=Signature.parse(stored["label_after"]),
        solved=stored["solved"],
        note=stored["note"],
        status=Status(stored["status"]),
    )
