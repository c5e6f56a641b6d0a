"""What an independent model of the article's pair found, computed beforehand.

`make verified` renews it. It belongs to one state of the case, whose hash it carries: with other values it
is not shown.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from gearlash.case import Case

REPORTED = ("1-1-0", "1-0-0")
"""What the article reports of its own multibody model at the two speeds, rising."""


@dataclass(frozen=True)
class VerifiedPoint:
    """One speed in one way to hold the inputs.

    Attributes
    ----------
    speed : float
        rpm.
    omega : float
        Mesh frequency over that of the mesh of real teeth.
    label, rigid : str
        P-Q-R with a gear that bends, and with a rigid one.
    apart, least, peak : float
        Share of time without contact; least and greatest force over the mean one.
    lumped : dict
        Label of the lumped model at the same inputs by contact rule.
    phase, force, lumped_phase, lumped_force : tuple of float
        Mesh cycles and forces over the mean one.
    """

    speed: float
    omega: float
    label: str
    rigid: str
    apart: float
    least: float
    peak: float
    lumped: dict[str, str]
    phase: tuple[float, ...]
    force: tuple[float, ...]
    lumped_phase: tuple[float, ...]
    lumped_force: tuple[float, ...]


@dataclass(frozen=True)
class VerifiedWay:
    """One way to hold the inputs of both models against each other.

    Attributes
    ----------
    name, held : str
    face_width, stiffness, torque, error : float
        mm, N/m, N·m, µm.
    ripples : tuple of float
        Of the mesh orders 1, 2, 3 of the stiffness.
    points : tuple of VerifiedPoint
    beside : tuple of (str, float, str, float)
        Setting, speed, label, share of time without contact.
    up, down : str
        Speeds in contact, speed rising and falling; empty where they were not computed.
    lumped_up, lumped_down : dict
        The same of the lumped model by contact rule.
    """

    name: str
    held: str
    face_width: float
    stiffness: float
    torque: float
    error: float
    ripples: tuple[float, ...]
    points: tuple[VerifiedPoint, ...]
    beside: tuple[tuple[str, float, str, float], ...]
    up: str
    down: str
    lumped_up: dict[str, str]
    lumped_down: dict[str, str]


@dataclass(frozen=True)
class Verified:
    """All of it.

    Attributes
    ----------
    case : str
        Hash of the case.
    gearlash : str
        Version of the program that computed it.
    settings : tuple of dict
        Every setting that was tried.
    ways : tuple of VerifiedWay
    """

    case: str
    gearlash: str
    settings: tuple[dict[str, str], ...]
    ways: tuple[VerifiedWay, ...]


def verified(case: Case) -> Verified | None:
    """What was found for this state of the article's case; None where nothing was.

    Parameters
    ----------
    case : Case

    Returns
    -------
    Verified or None

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.article.verified import verified
    >>> found = verified(gl.load_case("article"))
    >>> found is None or found.ways[0].name
    'stiffness'
    >>> verified(gl.load_case("article", {"backlash": "90 um"})) is None
    True
    """
    found = kept()
    return found if found.case == case.hash else None


@cache
def kept() -> Verified:
    """The file that comes with the package.

    Returns
    -------
    Verified
    """
    data = json.loads(files("gearlash.article").joinpath("verified.json").read_text(encoding="utf-8"))
    return Verified(data["case"], data["gearlash"], tuple(data["settings"]), tuple(map(_way, data["ways"])))


def _way(data: dict[str, Any]) -> VerifiedWay:
    more: dict[str, Any] = {
        "points": tuple(VerifiedPoint(**_with_tuples(point)) for point in data["points"]),
        "beside": tuple(tuple(row) for row in data["beside"]),
    }
    return VerifiedWay(**_with_tuples({**data, **more}))


def _with_tuples(data: dict[str, Any]) -> dict[str, Any]:
    return {name: tuple(each) if isinstance(each, list) else each for name, each in data.items()}
