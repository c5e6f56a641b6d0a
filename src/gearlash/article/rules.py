"""What the contact rule does to the article's window and events: the same study in small, once per rule.

The article prints a force whose damping acts in the gap too (`always`). Each rule gets the two ends of its
window without impacts, the labels at the article's two multibody speeds, and one sweep over D, followed down,
with the back-side grazings along it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import SpecialPoint, walk
from gearlash.case import Case
from gearlash.orbits import orbit_at
from gearlash.results import Axis, Direction, Point
from gearlash.studies.point import point
from gearlash.studies.sweep import sweep
from gearlash.studies.transitions import transitions
from gearlash.system import ContactRule, Family

from .reproduction import RuleEffect, RuleGrazing, RuleLabel
from .rows import STUDY_SETTINGS

MULTIBODY_SPEEDS = (0.942, 1.047)  # ω of the article's multibody runs
REACH = 0.6  # of ω: how far the impact-free orbit is followed to its ends
OPTION = "model.contact"


def effects(
    case: Case, backlash: Sequence[float], fixed: Mapping[str, float], executor: Executor
) -> tuple[RuleEffect, ...]:
    """One effect per rule, that of the case first; none for a case whose rule is not a choice. ``backlash``
    are the values of D, ``fixed`` the frequency of that sweep and the D of everything else."""
    stated = next((str(v.value) for v in case.values() if v.path == OPTION), None)
    if stated is None:
        return ()
    order = sorted(ContactRule, key=lambda rule: rule != stated)
    tasks = [
        executor.submit(effect, case.to_json(), str(rule), stated, tuple(backlash), dict(fixed))
        for rule in order
    ]
    return tuple(task.result() for task in tasks)


def effect(
    case_json: str, rule: str, stated: str, backlash: tuple[float, ...], fixed: Mapping[str, float]
) -> RuleEffect:
    """The study of one rule (a task for a worker)."""
    case = Case.from_json(case_json).with_overrides({OPTION: rule})
    family, _ = case.family()
    at_speeds = [
        point(family, {"D": fixed["D"], "omega": omega}, name="omega", settings=STUDY_SETTINGS)
        for omega in MULTIBODY_SPEEDS
    ]
    quiet = next((p for p in at_speeds if p.impact_free), None)
    ends = (None, None)
    if quiet is not None:
        values = family.complete({"D": fixed["D"]})
        ends = tuple(_end(family, values, quiet, quiet.value + way) for way in (-REACH, REACH))
    along = {"omega": fixed["omega"]}
    down = sweep(
        case,
        Axis("D", np.array(sorted(backlash))),
        values=along,
        direction=Direction.DOWN,
        settings=STUDY_SETTINGS,
    )
    found = transitions(family, "D", down.points, values=along, rising=False)
    return RuleEffect(
        rule=rule,
        stated=rule == stated,
        lower=ends[0],
        upper=ends[1],
        speeds=tuple(_label("omega", p) for p in at_speeds),
        backlash=tuple(_label("D", p) for p in down.points),
        back_side=tuple(
            _touch(family, t.point)
            for t in found
            if t.point is not None and t.point.is_grazing and t.point.touch.boundary < 0
        ),
    )


def _label(name: str, p) -> RuleLabel:
    return RuleLabel(
        name, p.value, p.status if p.label is None else p.label, len(p.back_phase) > 0, p.certificate
    )


def _end(family: Family, values: Mapping[str, float], quiet: Point, to: float) -> RuleGrazing | None:
    """The grazing at the end, on the way to a frequency, of the interval in which an impact-free orbit
    exists."""
    member = {**values, "omega": quiet.value}
    orbit = orbit_at(flow.propagators(family.system(member)), quiet.state, len(quiet.strobes))
    if orbit is None:
        return None
    for met in walk(family, member, "omega", orbit, to):
        if isinstance(met, SpecialPoint) and met.is_grazing:
            return _touch(family, met)
    return None


def _touch(family: Family, point: SpecialPoint) -> RuleGrazing:
    return RuleGrazing(
        point.value,
        point.error,
        point.label_below,
        point.label_above,
        point.touch_kind,
        point.touch.surface,
        point.exponent(family.system(point.values)),
    )
