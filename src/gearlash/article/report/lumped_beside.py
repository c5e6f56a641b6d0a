"""How the lumped model compares with real teeth at the same inputs."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.verified import Verified, VerifiedPoint, VerifiedWay
from gearlash.case import Case
from gearlash.report.blocks import Block, Text
from gearlash.report.numbers import fixed, number
from gearlash.studies.verification import DISTANCE_HELD

from . import window
from .seen import HELD, MODIFIED, RULES, parts, share
from .words import joined


def blocks(found: Verified, done: Reproduction) -> list[Block]:
    """Agreement in parting and labels, where both stay in contact, where both part, and what the ripple
    does."""
    said = _counts(found) + _in_contact(found) + _apart(found)
    ripple = _ripple(found, done)
    return [Text.of(said), *([Text.of(ripple)] if ripple else [])]


def same(points: list[VerifiedPoint], rule: str) -> int:
    """How often both models agree on whether teeth part at all."""
    return sum(agree(point, rule) for point in points)


def agree(point: VerifiedPoint, rule: str) -> bool:
    """Whether both part, or neither does."""
    return parts(point.label, point.apart) == _parts(point, rule)


def case_ripple(case: Case) -> float:
    """The second harmonic of the stiffness that the case assumes, over the mean."""
    return case.family()[0].complete()["ripple_2"]


def second(way: VerifiedWay, case: Case) -> str:
    """The second harmonic of the stiffness of a way, and that of the case."""
    return f"{share(way.ripples[1])}, where the case has {share(case_ripple(case))}"


def _parts(point: VerifiedPoint, rule: str) -> bool:
    return parts(point.lumped.get(rule, ""), point.lumped_apart.get(rule))


def _counts(found: Verified) -> str:
    points = [p for way in found.ways for p in way.points]
    parting = ", ".join(f"{same(points, rule)} under “{rule}”" for rule in RULES)
    labels = ", ".join(f"{sum(p.lumped.get(rule) == p.label for p in points)}" for rule in RULES)
    return (
        "The lumped model, given what real teeth have, agrees with them on whether teeth part at so many of "
        f"{len(points)} points: {parting}{_differing(found)}; on the full label at {labels} (a motion "
        "without a label agrees with none)."
    )


def _differing(found: Verified) -> str:
    """Points at which they differ under every rule; where other starts of real teeth agree, that."""
    said = []
    for way in found.ways:
        for point in way.points:
            if any(agree(point, rule) for rule in RULES):
                continue
            other = window.other_motion(way, point)
            also = f", where real teeth begun from the neighbouring speed, {other}, agree" if other else ""
            said.append(f"“{way.name}” at {point.speed:.0f} rpm{also}")
    return f" (not with {'; '.join(said)})" if said else ""


def _in_contact(found: Verified) -> str:
    """Where neither parts under any rule: greatest and least forces."""
    both = [
        point
        for way in found.ways
        for point in way.points
        if not parts(point.label, point.apart) and not any(_parts(point, rule) for rule in RULES)
    ]
    if not both:
        return ""
    off = max(abs(p.lumped_peak[rule] / p.peak - 1.0) for p in both for rule in RULES)
    real = ", ".join(fixed(point.least, 2) for point in both)
    lumped = ", ".join(fixed(_least(point), 2) for point in both)
    return (
        f" At the {len(both)} points at which both stay in contact under every rule the greatest forces "
        f"differ by at most {100.0 * off:.2g} %. The least are {real} of the mean with real teeth and "
        f"{lumped} in the lumped model."
    )


def _least(point: VerifiedPoint) -> float:
    """Force of the lumped model over its mean; under every rule where teeth stay in contact, as the rules
    differ in the gap alone."""
    return min(point.lumped_force)


def _apart(found: Verified) -> str:
    """Where both part: times and forces, under every rule, and those of a held centre distance."""
    rows = []
    for way in found.ways:
        for point in way.points:
            rules = [rule for rule in RULES if parts(point.label, point.apart) and _parts(point, rule)]
            if not rules:
                continue
            lumped = "; ".join(_under(way, point, rule) for rule in rules)
            rows.append(
                f"“{way.name}” at {point.speed:.0f} rpm: with real teeth apart {share(point.apart)} of the "
                f"time{_held(way, point)}, greatest force {number(point.peak, 3)} of the mean; lumped "
                f"{lumped}"
            )
    return f" The same answer is not the same force. {'. '.join(rows)}." if rows else ""


def _under(way: VerifiedWay, point: VerifiedPoint, rule: str) -> str:
    """Time and force of the lumped model under a rule; where its neighbours lead to another motion, that."""
    apart, label = point.lumped_apart[rule], point.lumped[rule]
    time = "no period" if apart is None else share(apart)
    said = f"{time} and {number(point.lumped_peak[rule], 3)} under “{rule}”"
    others = window.lumped_from_neighbours(way, point, rule)
    if not others - {label}:
        return said
    return f"{said} (that is {label}, from a cold start; from its neighbours {joined(sorted(others))})"


def _held(way: VerifiedWay, point: VerifiedPoint) -> str:
    """The lumped model has no motion along the line of centres, so real teeth without it are told as well."""
    rows = (r for r in way.beside if r[0] == DISTANCE_HELD.name and round(r[1]) == round(point.speed))
    row = next(rows, None)
    return "" if row is None else f" ({share(row[3])} with the centre distance held, as in the lumped model)"


def _ripple(found: Verified, done: Reproduction) -> str:
    """Where only the ripple is not that of the case: whether the lumped model, too, does otherwise with
    it."""
    ways = [way for way in found.ways if way.name in HELD]
    own = next((effect for effect in done.rules if effect.stated), None)
    if not ways or own is None:
        return ""
    like = sum(all(agree(p, rule) for rule in RULES) for way in ways for p in way.points)
    count = sum(len(way.points) for way in ways)
    case = " and ".join(f"{each.label} at ω {number(each.value, 4)}" for each in own.speeds)
    said = (
        f"The lumped model of the case itself has {case}. Where its dimensionless numbers are held and it "
        "gets the ripple of these teeth, and the small error that they make under load, in place of its own "
        f"ripple, it parts or stays as they do at {like} of {count} points under every rule."
    )
    turned = [
        index
        for index, each in enumerate(own.speeds)
        if all(
            _parts(way.points[index], rule) != parts(str(each.label), None) for way in ways for rule in RULES
        )
    ]
    if not turned or like != count:
        return said
    where = " and ".join(f"ω {number(own.speeds[index].value, 4)}" for index in turned)
    return (
        f"{said} So at {where} these, put into the lumped model, are enough to take away the answer of the "
        f"case{''.join(_by_little(ways, index) for index in turned)}. What bodies in space do with the "
        f"ripple of the case was not examined{_nearest(found, done.case)}."
    )


def _by_little(ways: list[VerifiedWay], index: int) -> str:
    """Where teeth of the lumped model stay in contact, and part one step of the grid lower under every rule:
    the force that is left, and the labels there."""
    points = [way.points[index] for way in ways]
    lower = {
        label
        for way, point in zip(ways, points, strict=True)
        for rule in RULES
        for label in window.lumped_from_neighbours(way, point, rule, steps=-1)
    }
    stay = not any(_parts(point, rule) for point in points for rule in RULES)
    if not lower or not stay or not all(parts(label, None) for label in lower):
        return ""
    least = joined([fixed(_least(point), 2) for point in points])
    return (
        f", by little: the least force of the lumped model there is {least} of the mean, and one step of the "
        f"grid lower it has {joined(sorted(lower))}"
    )


def _nearest(found: Verified, case: Case) -> str:
    """The way whose second harmonic comes nearest to that of the case."""
    ways = [way for way in found.ways if way.name == MODIFIED]
    return "".join(
        f"; “{way.name}” comes nearest in that harmonic ({second(way, case)}), with other harmonics and an "
        "error that its flanks make under load beside it"
        for way in ways
    )
