"""How the lumped model compares with real teeth at the same inputs."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.verified import Verified, VerifiedPoint, VerifiedWay
from gearlash.report.blocks import Block, Text
from gearlash.report.numbers import number

from .seen import HELD, RULES, parts, share

DISTANCE_HELD = "centre distance held"


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


def _parts(point: VerifiedPoint, rule: str) -> bool:
    return parts(point.lumped.get(rule, ""), point.lumped_apart.get(rule))


def _counts(found: Verified) -> str:
    points = [p for way in found.ways for p in way.points]
    parting = ", ".join(f"{same(points, rule)} under “{rule}”" for rule in RULES)
    labels = ", ".join(f"{sum(p.lumped.get(rule) == p.label for p in points)}" for rule in RULES)
    return (
        "The lumped model, given what real teeth have, agrees with them on whether teeth part at so many of "
        f"{len(points)} points: {parting}; on the full label at {labels} (a motion without a label agrees "
        "with "
        "none)."
    )


def _in_contact(found: Verified) -> str:
    """Where neither parts under any rule: by how much the greatest forces differ at most."""
    both = [
        point
        for way in found.ways
        for point in way.points
        if not parts(point.label, point.apart) and not any(_parts(point, rule) for rule in RULES)
    ]
    if not both:
        return ""
    off = max(abs(p.lumped_peak[rule] / p.peak - 1.0) for p in both for rule in RULES)
    return (
        f" At the {len(both)} points at which both stay in contact under every rule the greatest forces "
        "differ "
        f"by at most {100.0 * off:.2g} %."
    )


def _apart(found: Verified) -> str:
    """Where both part: times and forces, under every rule, and those of a held centre distance."""
    rows = []
    for way in found.ways:
        for point in way.points:
            rules = [rule for rule in RULES if parts(point.label, point.apart) and _parts(point, rule)]
            if not rules:
                continue
            lumped = "; ".join(
                f"{_time(point, rule)} and {number(point.lumped_peak[rule], 3)} under “{rule}”"
                for rule in rules
            )
            rows.append(
                f"“{way.name}” at {point.speed:.0f} rpm: with real teeth apart {share(point.apart)} of the "
                f"time{_held(way, point)}, greatest force {number(point.peak, 3)} of the mean; lumped "
                f"{lumped}"
            )
    return f" The same answer is not the same force. {'. '.join(rows)}." if rows else ""


def _time(point: VerifiedPoint, rule: str) -> str:
    apart = point.lumped_apart[rule]
    return "no period" if apart is None else share(apart)


def _held(way: VerifiedWay, point: VerifiedPoint) -> str:
    """The lumped model has no motion along the line of centres, so real teeth without it are told as well."""
    row = next((r for r in way.beside if r[0] == DISTANCE_HELD and round(r[1]) == round(point.speed)), None)
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
        f"ripple, it parts or stays as they do at {like} of {count} "
        "points under every rule."
    )
    turned = [
        f"ω {number(each.value, 4)}"
        for index, each in enumerate(own.speeds)
        if all(
            _parts(way.points[index], rule) != parts(str(each.label), None) for way in ways for rule in RULES
        )
    ]
    if not turned or like != count:
        return said
    return (
        f"{said} So at {' and '.join(turned)} these, put into the lumped model, are enough to take "
        "away the answer of the case. What bodies in space do with the ripple of the case was not examined."
    )
