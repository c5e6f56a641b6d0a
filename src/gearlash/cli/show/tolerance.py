"""Tolerances in the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.text import Text

from gearlash.case.edges import shown_interval
from gearlash.case.units import pretty
from gearlash.cli.answers.tolerance import BandFound, InputFound, ToleranceAnswer, chance_text
from gearlash.results.tolerance import LIMITS_OF_CASE

from .layout import assumed, facts, headline, note, table

SHOWN = 12  # rows of the probability
MOST_OPEN = 24  # more of them where it is neither 0 nor 1
UNKNOWN = 0.5  # error of a share with which nothing of it is known
NOTHING = 1e-9  # share of the variance of a value that the margin does not depend on


def tolerance_view(answer: ToleranceAnswer, width: int) -> Iterator[Text]:
    """Sentence, bands, probability over the range, values with limits, and the worst case."""
    yield from headline(answer.sentence, width)
    rows = [("status", answer.status), ("message", answer.message)] if answer.status != "ok" else []
    rows += [
        ("as it is", _bands(answer, answer.nominal)),
        ("in all tried", _bands(answer, answer.always)),
        ("in none", _bands(answer, answer.never)),
    ]
    yield from facts("Teeth stay in contact", rows, width)
    yield from table(
        "Probability",
        [(answer.unit or answer.axis, "right"), ("probability", "left")],
        list(_probability(answer)),
        width,
    )
    columns = [("value", "left"), ("from", "right"), ("to", "right"), ("worst", "right"), ("alone", "right"),
               ("in all", "right"), ("limits", "left")]  # fmt: skip
    title = (
        "Values with limits, and their share of the variance of least over static compression at the present "
        "value"
    )
    yield from table(title, columns, [_input(one) for one in answer.inputs], width)
    if answer.no_shares:
        yield from note(f"No shares of the variance: {answer.no_shares}.", width)
    if any(_origin(one) == "estimated" for one in answer.inputs):
        yield from note("Where the ranges of what is estimated are from, gearlash check tells.", width)
    settings = " ".join(f"--set '{path}={value}'" for path, value in answer.worst.items())
    yield from facts("The worst combination found, to run", [("", settings)], width)
    yield from note(_examined(answer), width)
    yield from assumed(answer.held, width)


def _examined(answer: ToleranceAnswer) -> str:
    unsolved = f" {answer.unsolved} motions were not solved for." if answer.unsolved else ""
    begin = "Tried:"
    if answer.status != "ok":
        begin = f"The work was stopped when {answer.tried} combinations were done. Planned:"
    return (
        f"{begin} the case itself, {answer.corners} corners of the limits, {answer.replicates} "
        f"independent sets of {answer.samples} samples, each value as likely as any other between its "
        "limits, and a search for the worst combination. That no other combination is worse is not proved. "
        "The motion is the one of teeth that never part, where it exists and is stable: other motions at "
        "the same values are not looked for (gearlash zones, gearlash run). Values that were looked at lie "
        f"no farther apart than 1 %: a narrower gap in contact may have been missed.{unsolved}"
    )


def _origin(one: InputFound) -> str:
    """Where the limits are from."""
    if one.reason == LIMITS_OF_CASE:
        return "case file"
    return "stated" if one.reason == "stated" else "estimated"


def _bands(answer: ToleranceAnswer, bands: Sequence[BandFound]) -> str:
    unit = f" {pretty(answer.unit)}" if answer.unit else ""
    told = (" to ".join(shown_interval(band.lower, band.upper)) for band in bands)
    return ", ".join(f"{text}{unit}" for text in told) or "nowhere in the range"


def _probability(answer: ToleranceAnswer) -> Iterator[list[str]]:
    count = len(answer.values)
    step = max(1, -(-count // SHOWN))
    open_ = [at for at in range(count) if _open(answer.probability[at])]
    few = open_[:: max(1, -(-len(open_) // MOST_OPEN))]
    for at in sorted({*range(0, count, step), count - 1, *few}):
        share, error = answer.probability[at], answer.probability_error[at]
        if share is None or error is None:
            yield [f"{answer.values[at]:.6g}", "-"]
        else:
            told = chance_text(share, error, answer.samples * answer.replicates)
            yield [f"{answer.values[at]:.6g}", told.removeprefix("of ")]


def _open(share: float | None) -> bool:
    """Whether contact is neither kept nor lost for sure: such values are not left out."""
    return share is not None and 0.0 < share < 1.0


def _input(one: InputFound) -> list[str]:
    shares = ("-", "-")
    if one.curve not in ("", one.path) and one.first is not None:
        shares = ("with", one.curve.rpartition(".")[2])
    elif one.first is not None and one.total is not None:
        shares = (_share(one.first, one.first_error), _share(one.total, one.total_error))
    worst = "-" if one.worst is None else f"{one.worst:.6g}"
    worst = "any" if one.total is not None and one.total < NOTHING else worst
    name = f"{one.path} [{pretty(one.unit)}]" if one.unit else one.path
    return [
        name,
        f"{one.lower:.6g}",
        f"{one.upper:.6g}",
        worst,
        *shares,
        _origin(one),
    ]


def _share(share: float, error: float | None) -> str:
    """A share of the variance, where the samples say more of it than that it lies between none and all."""
    off = error or 0.0
    return "not known" if off >= UNKNOWN else f"{round(100.0 * share)} ± {round(100.0 * off)} %"
