"""The types of bifurcation in the article's Table 2."""

from __future__ import annotations

from gearlash.branches import BifurcationPoint, GrazingPoint
from gearlash.branches.continuation import SpecialPoint

STANDARD = "standard grazing"
CODIMENSION_TWO = "co-dimension-2 grazing"
SMOOTH = "smooth"
CRITICAL = 1e-3  # |λ ± 1| below which a grazing point counts as coincident with a doubling or a fold


def table2_type(point: GrazingPoint | BifurcationPoint | SpecialPoint, critical: float = CRITICAL) -> str:
    """The type of a located point by Table 2.

    Parameters
    ----------
    point
        A grazing, a doubling or a fold that was solved for.
    critical
        Distance |λ ± 1| of a multiplier below which a grazing coincides with a doubling or a fold.

    Returns
    -------
    str
        ``"smooth"`` for a doubling or a fold. For a grazing ``"co-dimension-2 grazing"`` where a multiplier
        is at ±1 within ``critical`` (the largest exponent is then about zero), else ``"standard grazing"``:
        the period stays and only the impacts change.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.article import table2_type
    >>> family, _ = gl.load_case("article").family()
    >>> orbit = gl.attractor(family.system({"omega": 1.05}), family.start({"omega": 1.05}))
    >>> check = gl.grazing_checks(orbit)[0]
    >>> table2_type(gl.locate_grazing(family, "omega", orbit, check, values={"omega": 1.05}))
    'standard grazing'
    """
    if isinstance(point, BifurcationPoint) or (isinstance(point, SpecialPoint) and not point.is_grazing):
        return SMOOTH
    return CODIMENSION_TWO if min(point.to_doubling, point.to_fold) < critical else STANDARD
