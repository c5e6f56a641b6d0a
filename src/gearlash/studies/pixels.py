"""What a worker does for a map: a stretch of pixels along one of its axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.linalg import LinAlgError

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.jobs import Carry, Part, handing_on, stopping
from gearlash.orbits import Aperiodic, Attractor, Neutral, Orbit, Settings, Unresolved, Verdict, attractor
from gearlash.orbits.results import SAMPLE
from gearlash.results.plane import CERTIFICATES, STATUSES
from gearlash.system import CARRIED, Family, GearlashError, Status

from .model import Source

PERIODIC, APERIODIC, UNRESOLVED, NEUTRAL, NOTHING = range(5)
"""Kinds of a record: a proved orbit, aperiodic, unresolved, neutral, no motion at all."""
MOTION_CODES = {Unresolved: UNRESOLVED, Neutral: NEUTRAL, Aperiodic: APERIODIC}


@dataclass(frozen=True)
class Stretch:
    """Neighbouring pixels on a line of the map: ``along`` takes the ``values``, all else is ``fixed``."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    along: str
    values: tuple[float, ...]
    start: tuple[float, ...] | None
    settings: Settings


class Pixel(NamedTuple):
    """One pixel as it travels: the bytes of a record (`record_kind`), as a million of them lie in memory at
    once; none where it failed, but the reason."""

    record: bytes
    reason: str = ""


def record_kind(clearances: int) -> np.dtype:
    """What is kept of a pixel; ``counts``: (Q, R) of every clearance."""
    return np.dtype(
        [
            ("kind", "u1"),
            ("status", "u1"),
            ("certificate", "u1"),
            ("period", "<i4"),
            ("counts", "<i4", (clearances, 2)),
            ("periods", "<i4"),
            ("exponent", "<f8"),
        ]
    )


def failed_record(kind: np.dtype) -> np.ndarray:
    """The record () of a pixel that failed."""
    record = np.zeros((), kind)
    record["kind"], record["exponent"] = NOTHING, np.nan
    record["status"], record["certificate"] = (
        STATUSES.index(Status.FAILED),
        CERTIFICATES.index(Verdict.FAILED),
    )
    return record


def clearances_of(record: bytes) -> int:
    """How many clearances the system of a record has."""
    return (len(record) - record_kind(0).itemsize) // record_kind(1)["counts"].itemsize


def work(stretch: Stretch, carry: Carry) -> Part:
    """The pixels of a stretch, as far as they go before a stop. Where frequency, stiffness and damping stay,
    the propagators of a pixel are those of the one before with other forced parts."""
    family, found = stretch.source.family(), []
    props: Propagators | None = None
    with handing_on(lambda: Part(tuple(found))):
        for value in stretch.values:
            if stopping():
                break
            pixel, props = _pixel(family, {**dict(stretch.fixed), stretch.along: value}, stretch, props)
            found.append(pixel)
    return Part(tuple(found))


def _pixel(
    family: Family, values: dict[str, float], stretch: Stretch, reuse: Propagators | None
) -> tuple[Pixel, Propagators | None]:
    try:
        values = family.complete(values)
        props = flow.propagators(family.system(values), reuse)
        start = family.start(values) if stretch.start is None else stretch.start
        return Pixel(_record(attractor(props, start, stretch.settings))), props
    except (GearlashError, LinAlgError) as error:
        return Pixel(b"", str(error) or type(error).__name__), reuse


def _record(found: Attractor) -> bytes:
    clearances = len(found.propagators.system.clearances)
    record = np.zeros((), record_kind(clearances))
    if isinstance(found, Orbit):
        record["kind"] = PERIODIC
        record["period"], record["counts"] = found.signature.period, found.signature.counts
        verdict = found.certificate.verdict
    else:
        record["kind"] = next(kind for cls, kind in MOTION_CODES.items() if isinstance(found, cls))
        verdict = _verdict(found)
    record["status"] = STATUSES.index(found.status)
    record["certificate"] = CERTIFICATES.index(verdict)
    record["periods"], record["exponent"] = found.periods_used, found.largest_exponent
    return record.tobytes()


def _verdict(motion: Aperiodic) -> Verdict:
    """The verdict of ``motion.certificate``: undecided contacts of its sample are counted by marching through
    it, which takes a fiftieth of the trace that the certificate makes."""
    if motion.status not in (*CARRIED, Status.UNRESOLVED, Status.NEUTRAL):
        return Verdict.FAILED
    if isinstance(motion, Unresolved | Neutral):
        return Verdict.UNCERTAIN
    doubtful = motion.undecided > 0 or motion.status is Status.UNCERTAIN
    settled = abs(motion.largest_exponent) > motion.exponent_error
    if doubtful or not settled:
        return Verdict.UNCERTAIN
    sample = flow.march(motion.propagators, motion.final_state, SAMPLE)
    return Verdict.UNCERTAIN if sample.undecided else Verdict.CERTIFIED
