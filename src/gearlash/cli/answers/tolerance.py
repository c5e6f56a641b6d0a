"""`gearlash tolerance`: bands that hold in spite of tolerances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor, isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.case.edges import shown_interval
from gearlash.case.readable import readable

from .asked import unit_of
from .parts import CaseUsed, case_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.results.tolerance import Influence, Tolerance, ToleranceMember

MOST_TOLD = 3  # bands in the sentence
NARROW = 0.01
"""Of its own values and of the range: a band that is less wide is no place to run at."""
SURE = 3.0  # standard errors: what an index is above before the sentence tells it


@dataclass(frozen=True)
class BandFound:
    """An interval, in the unit of the axis."""

    lower: float
    upper: float


@dataclass(frozen=True)
class InputFound:
    """A value with limits."""

    path: str
    unit: str
    lower: float
    upper: float
    nominal: Annotated[float | None, "of the case as it is, where it has this quantity in some form"]
    worst: Annotated[float | None, "its value in the worst combination that was tried"]
    reason: Annotated[str, "where the limits are from"]
    first: Annotated[
        float | None,
        "Sobol index of the margin over the static compression: share of its variance by this value alone",
    ]
    first_error: float | None
    total: Annotated[float | None, "the same with all that it makes together with others"]
    total_error: float | None
    curve: Annotated[
        str, "first harmonic of a curve that is estimated as a whole: all its harmonics have this one share"
    ] = ""


@dataclass(frozen=True)
class ProfileFound:
    """A probability in pieces: it is the same all along each."""

    edges: Annotated[tuple[float, ...], "of the pieces, in the unit of the axis"]
    probability: Annotated[tuple[float, ...], "one a piece"]
    error: Annotated[tuple[float, ...], "its standard error"]


@dataclass(frozen=True)
class ToleranceAnswer:
    """Where teeth stay in contact in spite of tolerances (gearlash tolerance)."""

    sentence: str
    status: Annotated[str, "ok, or incomplete where the work was stopped"]
    message: str
    case: CaseUsed
    axis: Annotated[str, "name of the parameter as typed"]
    unit: Annotated[str, "its unit as typed; empty: dimensionless"]
    values: tuple[float, ...]
    probability: Annotated[tuple[float | None, ...], "share of the samples with impact-free motion"]
    probability_error: Annotated[tuple[float | None, ...], "its standard error, from independent sets"]
    profile: Annotated[
        ProfileFound | None,
        "the probability between the solved ends of the samples' bands, whatever the axis",
    ]
    present: Annotated[float, "the case's own value of the axis"]
    here: Annotated[float | None, "the probability there"]
    here_error: float | None
    always: Annotated[tuple[BandFound, ...], "where every combination that was tried has the motion"]
    never: Annotated[tuple[BandFound, ...], "where none of them has it"]
    nominal: Annotated[tuple[BandFound, ...], "where the case as it is has it"]
    nominal_margin: Annotated[
        float | None, "least compression at the present value, m (dimensionless: over D_c)"
    ]
    worst_margin: Annotated[float | None, "the same of the worst combination; below 0 teeth part"]
    nominal_share: Annotated[float | None, "least compression over the static one, of the case as it is"]
    worst_share: Annotated[float | None, "the same of the worst combination, which is the one with the least"]
    worst: Annotated[dict[str, str], "the worst combination as settings (--set) of a case to run"]
    inputs: tuple[InputFound, ...]
    tried: Annotated[
        int,
        "combinations with bands: the case itself where it lies within the limits, corners, samples, and the "
        "worst one found",
    ]
    samples: int
    replicates: int
    corners: int
    unsolved: Annotated[int, "motions that were not solved for: they count as not free of impacts"]
    held: Annotated[
        tuple[str, ...],
        "what is taken to be the same wherever the axis and the inputs vary, although it may not",
    ] = ()
    no_shares: Annotated[str, "why no value has a share of the variance; empty where they have"] = ""
    result: Literal["tolerance"] = "tolerance"


def tolerance_answer(case: Case, found: Tolerance) -> ToleranceAnswer:
    """The record of tolerances."""
    return ToleranceAnswer(
        sentence=_sentence(case, found),
        status="ok" if found.complete else "incomplete",
        message=found.message,
        case=case_used(case),
        held=tuple(filter(None, map(case.held, (found.axis.name, *(one.path for one in found.inputs))))),
        axis=found.axis.name,
        unit=found.axis.unit,
        values=tuple(found.axis.values.tolist()),
        probability=tuple(map(_known, found.probability)),
        probability_error=tuple(map(_known, found.probability_error)),
        profile=None if found.profile is None else ProfileFound(**vars(found.profile)),
        present=found.present,
        here=_known(found.here),
        here_error=_known(found.here_error),
        always=_bands(found.always),
        never=_bands(found.never),
        nominal=_bands(found.nominal.bands),
        nominal_margin=_known(found.nominal.compression),
        worst_margin=_known(found.worst.compression),
        nominal_share=_known(found.nominal.share),
        worst_share=_known(found.worst.share),
        worst=dict(found.settings_of_worst),
        inputs=_inputs(found),
        tried=found.tried,
        samples=found.samples,
        replicates=found.replicates,
        corners=found.corners,
        unsolved=found.unsolved,
        no_shares=found.no_influences,
    )


def _known(value: float) -> float | None:
    return value if isfinite(value) else None


def _bands(bands: Sequence[tuple[float, float]]) -> tuple[BandFound, ...]:
    return tuple(BandFound(*band) for band in bands)


def _inputs(found: Tolerance) -> tuple[InputFound, ...]:
    known = {one.path: one for one in found.influences}
    rows = []
    for one, worst in zip(found.inputs, found.worst.inputs, strict=True):
        index = known.get(one.curve or one.path)
        four = (
            (None,) * 4 if index is None else (index.first, index.first_error, index.total, index.total_error)
        )
        rows.append(
            InputFound(
                one.path,
                one.unit,
                one.lower,
                one.upper,
                _known(one.nominal),
                _known(worst),
                one.reason,
                *four,
                curve=one.curve,
            )
        )
    order = [one.path for one in found.influences]
    return tuple(sorted(rows, key=lambda row: order.index(row.curve or row.path) if order else 0))


def _sentence(case: Case, found: Tolerance) -> str:
    """What holds at the present value, then the bands that hold for all and for none."""
    here = f"At {value_text(found, found.present)}: {_here(case, found)}"
    never = f"in none {bands_text(found, found.never)}"
    said = [here, always_text(found), never]
    first = found.influences[0] if found.influences else None
    if first is not None and first.total > SURE * first.total_error:
        name = found.sharing(first.path)
        said.append(
            f"least over static compression depends most on {name} ({variance_text(first)} of its variance)"
        )
    if not found.never:
        said.remove(never)
    if not found.complete:
        said.append(f"{found.message}: only a part of all combinations was tried")
    return "; ".join(said)


def always_text(found: Tolerance) -> str:
    """Bands that hold for all that was tried. One that is narrow is told as such; one at an end of the range
    goes on beyond it for all that is known, and is none of these."""
    if not found.always:
        return "no value of the range holds for all combinations tried"
    said = "teeth stay in contact in all combinations tried"
    low, high = (float(found.axis.values[i]) for i in (0, -1))
    narrow = [band for band in found.always if _is_narrow(band, low, high)]
    wide = [band for band in found.always if band not in narrow]
    less = "less wide than 1 % of the range and of its values"
    if wide:
        more = f", and in {_counted(narrow)} {less}" if narrow else ""
        return f"{said} {bands_text(found, wide)}{more}"
    widest = bands_text(found, [max(narrow, key=_width)])
    which = f"the widest {widest}" if len(narrow) > 1 else widest
    return f"{said} only in {_counted(narrow)} {less}, {which}"


def _counted(bands: Sequence[tuple[float, float]]) -> str:
    return f"{len(bands)} bands" if len(bands) > 1 else "a band"


def _is_narrow(band: tuple[float, float], low: float, high: float) -> bool:
    most = NARROW * min(high - low, max(map(abs, band)))
    return low < band[0] and band[1] < high and _width(band) < most


def _width(band: tuple[float, float]) -> float:
    return band[1] - band[0]


def _here(case: Case, found: Tolerance) -> str:
    nominal = (
        "teeth stay in contact" if found.nominal.margin > 0.0 else "no motion with teeth always in contact"
    )
    text = f"{nominal} as the case is, {margin_text(case, found.nominal)}"
    if isfinite(found.here):
        chance = chance_text(found.here, found.here_error, found.drawn)
        text += f"; with probability {chance} within the limits"
    return text + f"; worst combination found: {margin_text(case, found.worst)}"


def chance_text(share: float, error: float, count: int) -> str:
    """A probability with its error; where all samples agree, what that many samples bound it by (95 %)."""
    from gearlash.results.tolerance import least_chance

    bound = 100.0 * least_chance(count)
    if share >= 1.0:
        return f"of at least {floor(10.0 * bound) / 10.0:.1f} %"
    if share <= 0.0:
        return f"of at most {ceil(10.0 * (100.0 - bound)) / 10.0:.1f} %"
    return f"{100.0 * share:.3g} ± {100.0 * error:.2g} %"


def variance_text(one: Influence) -> str:
    """The whole share of the variance that an input makes, no more than is possible."""
    share, error = round(100.0 * one.total), round(100.0 * one.total_error)
    return f"nearly all, {100 - error} % or more," if share + error > 100 else f"{share} ± {error} %"


def margin_text(case: Case, member: ToleranceMember) -> str:
    """The least compression in words."""
    if not isfinite(member.margin):
        return "that motion is unstable" if member.margin < 0.0 else "that motion was not solved for"
    share = f", {100.0 * member.share:.3g} % of the static one" if member.static > 0.0 else ""
    if member.length is None:
        return f"least compression {member.margin:.4g} D_c{share}"
    size, name = readable(1e6 * member.compression, "µm")
    return f"least compression {size:.4g} {name}{share}"


def _axis_unit(found: Tolerance) -> str:
    """With the shaft, where it is not that of the pinion."""
    return unit_of(found.axis.name, found.axis.unit)


def value_text(found: Tolerance, value: float) -> str:
    """A value of the axis with its unit or its name."""
    if not found.axis.unit:
        return f"{found.axis.name} = {value:.6g}"
    return f"{value:.6g} {_axis_unit(found)}"


def bands_text(found: Tolerance, bands: Sequence[tuple[float, float]]) -> str:
    """Bands rounded into them, with their unit; of many the widest, in their order."""
    unit = f" {_axis_unit(found)}" if found.axis.unit else ""
    name = "" if found.axis.unit else f"{found.axis.name} "
    widest = sorted(sorted(bands, key=_width)[-MOST_TOLD:])
    told = " and ".join(f"{name}{' to '.join(shown_interval(*band))}" for band in widest)
    more = f" and {len(bands) - MOST_TOLD} less wide" if len(bands) > MOST_TOLD else ""
    return f"from {told}{unit}{more}"
