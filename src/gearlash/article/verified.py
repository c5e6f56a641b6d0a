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
    impacts, back_impacts : float
        Beginnings of contact a mesh cycle, of the drive side and of the back side.
    energy_residual : float
        What is missing in the balance of energy, over what dampers take.
    returns : float
        How far the mean forces of every 1/64 of a mesh cycle miss themselves after its period, or at the
        least after 1 to 8 mesh cycles, over the range of these means.
    lumped, lumped_apart, lumped_peak : dict
        Label of the lumped model at the same inputs by contact rule; share of time without contact, None
        where it has no orbit; greatest force over the mean one.
    phase, force, lumped_phase, lumped_force : tuple of float
        Mesh cycles and forces over the mean one.
    orders : tuple of float
        Amplitudes of the force of real teeth over the mean one, at the mesh orders 1/2, 1, 3/2, …, 8.
    lumped_orders, lumped_amplitudes : tuple of float
        Orders and amplitudes of the lumped model; empty for a motion without a period.
    frames : tuple of tuple of float
        Phase of the mesh cycle, turns of pinion and gear in rad, forces of drive side and back side in N.
    """

    speed: float
    omega: float
    label: str
    rigid: str
    apart: float
    least: float
    peak: float
    lumped: dict[str, str]
    lumped_apart: dict[str, float | None]
    lumped_peak: dict[str, float]
    phase: tuple[float, ...]
    force: tuple[float, ...]
    lumped_phase: tuple[float, ...]
    lumped_force: tuple[float, ...]
    orders: tuple[float, ...]
    lumped_orders: tuple[float, ...]
    lumped_amplitudes: tuple[float, ...]
    frames: tuple[tuple[float, ...], ...]
    impacts: float
    back_impacts: float
    energy_residual: float
    returns: float


@dataclass(frozen=True)
class VerifiedBreathing:
    """What the centre distance does at one speed: least and greatest over time.

    Attributes
    ----------
    centre_distance, contact_ratio, backlash : tuple of float
        Change in µm, transverse, and normal in µm.
    label_held : str
        With the centre distance held.
    peak_share : float or None
        Greatest force less that with the centre distance held, over the latter.
    """

    centre_distance: tuple[float, ...]
    contact_ratio: tuple[float, ...]
    backlash: tuple[float, ...]
    label_held: str
    peak_share: float | None


@dataclass(frozen=True)
class VerifiedLines:
    """Lines of contact of perfect flanks turned slowly through a mesh cycle.

    Attributes
    ----------
    torque : float
        On the pinion, N·m.
    slices, phase : tuple of float
        Middles along the face, m, and phases of the mesh.
    shape : tuple of int
        Phases, pairs, slices.
    rolls, loads : tuple of float
        Roll lengths of the pinion, m, and forces, N, of that shape in C order.
    """

    torque: float
    slices: tuple[float, ...]
    phase: tuple[float, ...]
    shape: tuple[int, ...]
    rolls: tuple[float, ...]
    loads: tuple[float, ...]


@dataclass(frozen=True)
class VerifiedWay:
    """One way to hold the inputs of both models against each other.

    Attributes
    ----------
    name, held : str
    face_width, stiffness, torque, error : float
        mm, N/m, N·m, µm.
    numbers : dict of str to float
        Dimensionless, that are held or not.
    ripples : tuple of float
        Of the mesh orders 1, 2, 3 of the stiffness.
    errors_under_load : tuple of float
        What the flanks themselves make beside that stiffness: amplitudes of the same orders, µm.
    points : tuple of VerifiedPoint
    beside : tuple of (str, float, str, float)
        Setting, speed, label, share of time without contact.
    settled : tuple of (str, float, int)
        Setting, speed, mesh cycles before those that were read; of the plan and of every setting beside.
    breathing : tuple of VerifiedBreathing
        At each speed.
    up, down : str
        Speeds in contact, speed rising and falling; empty where they were not computed.
    lumped_up, lumped_down : dict
        The same of the lumped model by contact rule.
    apart_differs : dict
        By contact rule, speeds rising and falling, rpm, at which one model keeps teeth in contact and the
        other does not.
    window : dict
        The grid of speeds, ``speed`` in rpm ascending, and the label at each: ``up`` and ``down`` of real
        teeth, ``lumped_up`` and ``lumped_down`` by contact rule; empty where it was not computed.
    """

    name: str
    held: str
    face_width: float
    stiffness: float
    torque: float
    error: float
    numbers: dict[str, float]
    ripples: tuple[float, ...]
    errors_under_load: tuple[float, ...]
    points: tuple[VerifiedPoint, ...]
    beside: tuple[tuple[str, float, str, float], ...]
    settled: tuple[tuple[str, float, int], ...]
    breathing: tuple[VerifiedBreathing, ...]
    up: str
    down: str
    lumped_up: dict[str, str]
    lumped_down: dict[str, str]
    apart_differs: dict[str, list[list[float]]]
    window: dict[str, Any]


@dataclass(frozen=True)
class Verified:
    """All of it.

    Attributes
    ----------
    case : str
        Hash of the case.
    gearlash : str
        Version of the program that computed it.
    computed : dict of str to str
        ``commit`` and ``day`` of the code that computed it, and the ``command`` that renews it.
    in_run : bool
        Whether this run computed it.
    check : dict of str to float
        Numbers of `gearlash.article.verifying.check_numbers` by that code; empty where none are kept.
    settings : tuple of dict
        Every setting that was tried.
    ways : tuple of VerifiedWay
    pictured : str
        Name of the way of which teeth are drawn.
    lines : VerifiedLines or None
        With its face width; None in a file that has none.
    """

    case: str
    gearlash: str
    computed: dict[str, str]
    in_run: bool
    check: dict[str, float]
    settings: tuple[dict[str, str], ...]
    ways: tuple[VerifiedWay, ...]
    pictured: str
    lines: VerifiedLines | None


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
    return from_data(data)


def from_data(data: dict[str, Any], in_run: bool = False) -> Verified:
    """What such a file holds.

    Parameters
    ----------
    data : dict
    in_run : bool
        Whether this run computed it.

    Returns
    -------
    Verified
    """
    ways, lines = tuple(map(_way, data["ways"])), data.get("lines")
    return Verified(
        data["case"],
        data["gearlash"],
        data.get("computed", {}),
        in_run,
        data.get("check", {}),
        tuple(data["settings"]),
        ways,
        data.get("pictured", ""),
        lines and VerifiedLines(**_with_tuples(lines)),
    )


def _way(data: dict[str, Any]) -> VerifiedWay:
    more: dict[str, Any] = {
        "points": tuple(map(_point, data["points"])),
        "breathing": tuple(VerifiedBreathing(**_with_tuples(each)) for each in data["breathing"]),
        "beside": tuple(tuple(row) for row in data["beside"]),
        "settled": tuple(tuple(row) for row in data["settled"]),
    }
    return VerifiedWay(**_with_tuples({**data, **more}))


def _point(data: dict[str, Any]) -> VerifiedPoint:
    frames = tuple(tuple(frame) for frame in data["frames"])
    return VerifiedPoint(**_with_tuples({**data, "frames": frames}))


def _with_tuples(data: dict[str, Any]) -> dict[str, Any]:
    return {name: tuple(each) if isinstance(each, list) else each for name, each in data.items()}
