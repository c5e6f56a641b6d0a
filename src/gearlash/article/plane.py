"""The window without impacts in the plane of speed and load, around the operating point of the case."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor, Future

from gearlash import PlaneZone, plane_zone
from gearlash.case import Case
from gearlash.system import GearlashError

LOADS = (0.6, 1.6)  # between which multiples of its own value the load is varied


def begun(
    case: Case, speeds: tuple[float, float], fixed: Mapping[str, float], executor: Executor
) -> Future[PlaneZone | None]:
    """Hands it to a worker: between these mesh frequencies, with ``fixed`` values."""
    return executor.submit(window, case.to_json(), speeds, dict(fixed))


def window(case_json: str, speeds: tuple[float, float], fixed: Mapping[str, float]) -> PlaneZone | None:
    """The zone (a task); None where the motion of the case has impacts, or lies outside these speeds."""
    case = Case.from_json(case_json)
    load = case.family()[0].complete(fixed)["load"]
    lower, upper = sorted(part * load for part in LOADS)
    try:
        return plane_zone(
            case, ("omega", "load"), lower=(speeds[0], lower), upper=(speeds[1], upper), values=fixed, lines=0
        )
    except GearlashError:
        return None
