"""A verification in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.cli.answers.verify import ConfigurationCompared, PointComputed, VerifyAnswer
from gearlash.cli.answers.verify_words import KEPT, in_words

from .layout import facts, headline, note, table

LIMITS = (
    "Both models were given the same inputs before anything was computed (--json lists them and every "
    "setting). Each row is one motion, from teeth pressed together on the drive side: others may coexist. "
    "There is no friction in either model. What the multibody model assumes beyond the case (bearings along "
    "the line of centres and against tilt, the phase of the error) is varied under `settings beside`."
)


def verify_view(answer: VerifyAnswer, width: int) -> Iterator[Text]:
    """Sentence, meshes, and each configuration with the lumped model beside it."""
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        yield from facts(
            "", [("status", answer.status), ("message", answer.message), ("what to do", answer.advice)], width
        )
    rows = [
        (
            f"{mesh.face_width:.4g} mm",
            f"{mesh.stiffness:.4g} N/m",
            " ".join(f"{100.0 * ripple:.2g} %" for ripple in mesh.ripples),
            f"{mesh.transmission_error:.3g} µm",
            f"{mesh.transverse_contact_ratio:.3f} + {mesh.overlap_ratio:.3f}",
        )
        for mesh in answer.meshes
    ]
    columns = [("face width", "right"), ("mean stiffness", "right"), ("ripple, orders 1 2 3", "right"),
               ("static error", "right"), ("contact ratio", "right")]  # fmt: skip
    yield from table("The mesh of real teeth", columns, rows, width)
    stated = [(f"ω {p.omega:.4f}", f"{p.label} ({p.rule})") for p in answer.stated]
    if stated:  # nothing stands here before the first motion of the lumped model
        yield from facts("The case as it is", stated, width)
    for one in answer.configurations:
        yield from _configuration(one, width)
    yield from note(LIMITS, width)


def _configuration(one: ConfigurationCompared, width: int) -> Iterator[Text]:
    rules = list(dict.fromkeys(p.rule for p in one.lumped))
    labels = {(p.omega, p.rule): p.label for p in one.lumped}
    columns = [("speed", "right"), ("ω", "right"), ("real teeth", "left"), ("apart", "right"),
               ("least/mean", "right"), ("peak/mean", "right"),
               *((f"lumped, {rule}", "left") for rule in rules)]  # fmt: skip
    rows = [[*_row(p), *(labels.get((p.omega, rule), "") for rule in rules)] for p in one.points]
    yield from table(f"{one.name}: {one.held}", columns, rows, width)
    numbers = ", ".join(f"{name} {value:.4g}" for name, value in one.numbers.items())
    facts_ = [("torque, error", f"{one.torque:.4g} N·m, {one.error:.4g} µm"), ("numbers", numbers)]
    facts_ += [(f"centre distance, {speed:.0f} rpm", said) for speed, said in _breathing(one)]
    if one.window.omega:
        facts_ += [("contact kept", _kept(one))]
    yield from facts("", facts_, width)
    if one.beside:
        beside = [[p.setting, *_row(p)] for p in one.beside]
        yield from table("settings beside", [("setting", "left"), *columns[:6]], beside, width)


def _breathing(one: ConfigurationCompared) -> Iterator[tuple[float, str]]:
    """What its motion makes of contact ratio, backlash and greatest force, at each speed."""
    speeds = {p.omega: p.speed for p in one.points}
    for each in one.breathing:
        change, ratio, play = each.centre_distance, each.contact_ratio, each.backlash
        said = (
            f"breathes by {change[0]:+.1f} to {change[1]:+.1f} µm: contact ratio {ratio[0]:.4f} to "
            f"{ratio[1]:.4f}, backlash {play[0]:.1f} to {play[1]:.1f} µm"
        )
        if each.peak_share is not None:
            less = "higher" if each.peak_share >= 0.0 else "lower"
            share = f"{abs(100.0 * each.peak_share):.1f} % {less}"
            said += f"; greatest force {share} than with it held (there {in_words(each.label_held)})"
        yield speeds[each.omega], said


def _row(p: PointComputed) -> list[str]:
    mean = p.mean_force or 1.0
    return [
        f"{p.speed:.0f} rpm",
        f"{p.omega:.4f}",
        in_words(p.label),
        f"{100.0 * p.apart:.1f} %",
        f"{p.least_force / mean:.2f}",
        f"{p.greatest_force / mean:.2f}",
    ]


def _kept(one: ConfigurationCompared) -> str:
    """Where teeth stay in contact, speed rising and falling."""
    told = []
    for way, labels in (("rising", one.window.up), ("falling", one.window.down)):
        told.append(f"speed {way}: {spans(one.window.speed, labels)}")
    return "; ".join(told)


def stays(label: str) -> bool:
    """Whether teeth stay in contact in a motion of this label."""
    return label.endswith("-0-0") or label == KEPT


def spans(speeds: tuple[float, ...], labels: tuple[str, ...]) -> str:
    """Runs of grid speeds at which teeth stay in contact: ``3700 to 4250 rpm``."""
    runs: list[list[float]] = []
    inside = False
    for speed, label in zip(speeds, labels, strict=True):
        if stays(label) and inside:
            runs[-1][1] = speed
        elif stays(label):
            runs.append([speed, speed])
        inside = stays(label)
    return ", ".join(f"{low:.0f} to {high:.0f} rpm" for low, high in runs) or "nowhere on the grid"
