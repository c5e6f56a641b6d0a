"""Print the worst errors of the flow: ``cd tests && python -m oracles.measure [SETS] [GRAZES]``.

The tests assert bounds; this shows how far below them the flow is. Spans are short, so that motions hardly
part: 2 mesh cycles, a fifth of one where it is slow (ω < 0.1). Longer ones would measure chaos instead.
"""

from __future__ import annotations

import sys
from functools import lru_cache

import numpy as np

from gearlash import flow
from gearlash.system import ContactRule, Status

from . import region_oracle
from .compare import Distance, distance
from .dense import random_dense
from .grazes import grazes
from .heyoka_oracle import Oracle
from .matches import match
from .members import RULES, random_member
from .pairs import KINDS, random_system
from .touches import touches

HEADER = f"{'':28}{'sets':>7}{'bad':>5}{'unsure':>7}{'state':>10}{'time/bar':>10}{'X-D':>10}{'extremum':>10}"


def _line(name: str, found: list[tuple[Distance, Status]]) -> str:
    """Bad: crossings or extrema differ although the status is ok."""
    unsure = sum(status is not Status.OK for _, status in found)
    bad = sum(status is Status.OK and not (far.same_crossings and far.same_extrema) for far, status in found)
    worst = [
        max(getattr(far, key) for far, _ in found)
        for key in ("state", "event_time", "on_boundary", "extremum_displacement")
    ]
    return f"{name:28}{len(found):7}{bad:5}{unsure:7}" + "".join(f"{value:10.1e}" for value in worst)


def _random(pair: str, oracle: Oracle, sets: int):
    rng = np.random.default_rng(2024)
    for index in range(sets):
        kind = KINDS[index % len(KINDS)]
        system, state = random_system(rng, pair, kind)
        cycles, phase = 0.2 if kind == "slow" else 2.0, float(rng.uniform(0.0, 1.0))
        trace = flow.trace(flow.propagators(system), state, cycles, phase)
        yield distance(system, trace, oracle.run(system, state, cycles, phase)), trace.status


def _derivative(pair: str, oracle: Oracle, sets: int) -> str:
    rng, worst = np.random.default_rng(2025), 0.0
    for index in range(sets):
        kind = KINDS[index % len(KINDS)]
        system, state = random_system(rng, pair, kind)
        cycles = 0.2 if kind == "slow" else 2.0
        truth = oracle.run(system, state, cycles).jacobian
        found = flow.variational(flow.propagators(system), state, cycles).jacobian
        worst = max(worst, float(np.abs(found - truth).max() / max(1.0, np.abs(truth).max())))
    return f"{pair + ', derivative':28}{sets:7}{'':12}{worst:10.1e}"


def _dense(sets: int):
    rng = np.random.default_rng(2026)
    for size in (2, 4, 7):
        draws = [random_dense(rng, size) for _ in range(sets)]
        oracle = Oracle([system for system, _ in draws])
        for system, state in draws:
            trace = flow.trace(flow.propagators(system), state, 2.0, 0.4)
            yield distance(system, trace, oracle.run(system, state, 2.0, 0.4)), trace.status


def _grazes(pair: str, oracle: Oracle, count: int):
    propagators = lru_cache(maxsize=1)(flow.propagators)
    for graze in grazes(2027, count, pair, oracle):
        trace = flow.trace(propagators(graze.system), graze.start, graze.span, graze.phase)
        yield distance(graze.system, trace, graze.truth), trace.status


def _class(rule: ContactRule | None, sets: int) -> str:
    """Random members with 1 to 3 clearances and 1 to 12 states, and the derivative of the small ones."""
    rng, worst, bad, unsure, derivative = np.random.default_rng(2028), [0.0, 0.0], 0, 0, 0.0
    for index in range(sets):
        size, rules = 1 + index % 12, RULES if rule is None else (rule,)
        system, state = random_member(rng, size, 1 + index % 3, rules)
        phase, props = float(rng.uniform(0.0, 2.0)), flow.propagators(system)
        truth = region_oracle.run(system, state, 2.0, phase, variational=size <= 6)
        trace = flow.trace(props, state, 2.0, phase)
        far = match(system, trace, truth)
        unsure += trace.status is not Status.OK
        bad += trace.status is Status.OK and not far.same_events
        worst = [max(worst[0], far.state), max(worst[1], far.event_time)]
        if truth.jacobian is not None:
            apart = np.abs(flow.variational(props, state, 2.0, phase).jacobian - truth.jacobian).max()
            derivative = max(derivative, float(apart / max(1.0, np.abs(truth.jacobian).max())))
    name = f"class, {'mixed' if rule is None else rule.value}"
    figures = "".join(f"{value:10.1e}" for value in worst)
    return f"{name:28}{sets:7}{bad:5}{unsure:7}{figures}   derivative {derivative:.1e}"


def _touches(count: int) -> str:
    """Near-touches of every surface. Bad: an event too many or too few although the status is ok."""
    worst, bad, unsure = [0.0, 0.0], 0, 0
    propagators = lru_cache(maxsize=1)(flow.propagators)
    for touch in touches(2029, count):
        trace = flow.trace(propagators(touch.system), touch.start, touch.span, touch.phase)
        far = match(touch.system, trace, touch.truth)
        unsure += trace.status is not Status.OK
        wrong = touch.events is not None and touch.near(trace.events) != touch.events
        bad += trace.status is Status.OK and (wrong or not far.same_events)
        worst = [max(worst[0], far.state), max(worst[1], far.event_time)]
    return f"{'class, grazes':28}{count:7}{bad:5}{unsure:7}" + "".join(f"{value:10.1e}" for value in worst)


def main(sets: int = 208, count: int = 2000) -> None:
    print(HEADER)
    examples = np.random.default_rng(0)
    for pair in ("spur", "helical"):
        shapes = [random_system(examples, pair, kind)[0] for kind in KINDS]
        oracle = Oracle(shapes)
        print(_line(pair, list(_random(pair, oracle, sets))))
        print(_derivative(pair, Oracle(shapes, variational=True), min(sets, 208)))
        print(_line(f"{pair}, grazes", list(_grazes(pair, oracle, count // 2))))
    print(_line("dense, 2, 4, 7 states", list(_dense(min(sets, 60)))))
    for rule in (*RULES, None):
        print(_class(rule, sets))
    print(_touches(count // 5))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
