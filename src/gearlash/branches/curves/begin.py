"""From a special orbit to the first orbits of a curve, in both directions."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearlash import flow
from gearlash.branches.continuation.equations import scale_of
from gearlash.branches.continuation.extrema import Extremum
from gearlash.branches.continuation.points import SpecialKind, SpecialPoint
from gearlash.system import GearlashError

from .conditions import At, Condition, circle_cosine
from .corner import at_other_end
from .locate import Met
from .motion import CurveOrbit, apart, is_clear
from .newton import correct, tangent
from .node import OPPOSITE, Node, begun_at, node_of, solved, touch_of
from .plane import Array, Plane
from .points import CodimTwoKind, CodimTwoPoint, CurveEndKind, CurvePoint
from .problem import Evaluated, Problem, TouchCondition
from .restart import beyond, clear_side
from .secondary import ALONG
from .touch import Window

OF_KIND = {SpecialKind.FOLD: At.ONE, SpecialKind.DOUBLING: At.MINUS_ONE, SpecialKind.TORUS: At.CIRCLE}
OF_TWO = {
    CodimTwoKind.GRAZING_DOUBLING: At.MINUS_ONE,
    CodimTwoKind.GRAZING_FOLD: At.ONE,
    CodimTwoKind.CORNER: At.ONE,
    CodimTwoKind.GRAZING_TORUS: At.CIRCLE,
}
REAL = {CodimTwoKind.ONE_ONE: 1.0, CodimTwoKind.ONE_TWO: -1.0}  # the double multiplier
ASIDE = 1e-5  # scaled: how far from a double multiplier it is looked which way the two leave it
NEAR_START = 0.05  # scaled: how far the first orbit of a curve may lie from the start
SAME_EXTREMUM = 0.02  # mesh cycles: how far from where it was told the extremum that touches may lie
NEAR_POINT = 0.5  # scaled: how far that orbit may lie from the point
APART = 1e-3  # of the amplitude: how far the other extremum must be from touching, too
SAME_VALUES = 1e-12  # relative
BESIDE = 3e-3  # scaled: how far beside a point of another plane a curve through it is begun
AMPLITUDES = (3e-4, 1e-3, 3e-3, 1e-2)  # scaled: of the doubled orbit with which its curve begins


@dataclass(frozen=True, eq=False)
class Beginning:
    """Orbits with their directions, away from the start; ``met``: where two things happen at the start;
    ``known``: the orbits after the one ahead, as far as they are known already; ``start``: the point itself,
    where the curve passes through it; ``ended``: why there is nothing behind the start."""

    ahead: Node
    behind: Node | None
    met: Met | None = None
    known: tuple[Node, ...] = ()
    start: CodimTwoPoint | None = None
    ended: CurveEndKind | None = None


def beginning(
    plane: Plane,
    start: SpecialPoint | CodimTwoPoint | CurvePoint,
    place: Array,
    kind: SpecialKind | None,
    touch: int = 0,
    doubled: bool = False,
) -> Beginning:
    """Raises `GearlashError` where no curve begins there."""
    if kind is not None and kind is not SpecialKind.GRAZING and kind not in OF_KIND:
        raise GearlashError(f"no curve of this kind is followed: {kind}")
    point = start if isinstance(start, CurvePoint) else start.point
    props = plane.system_at(place)
    period = point.period // props.system.cycles
    if isinstance(start, CodimTwoPoint):
        return _at_two(plane, start, place, period, kind, touch, doubled)
    if doubled:
        raise GearlashError("doubled: only where a grazing orbit has a multiplier -1")
    extrema: tuple[Extremum, ...]
    if isinstance(start, SpecialPoint):
        kind, period, extrema = _kind_of(start, kind, period)
    else:
        extrema = start.touches
        kind = SpecialKind.GRAZING if kind is None and extrema else kind
        if kind is None:
            raise GearlashError("kind: expected fold, doubling or Neimark-Sacker for this point of a curve")
    if kind is SpecialKind.GRAZING:
        if not 0 <= touch < len(extrema):
            raise GearlashError(f"touch = {touch}: {len(extrema)} extrema touch there")
        node = grazing_node(plane, place, point.state, period, extrema[touch])
    else:
        node = condition_node(plane, place, point.state, period, OF_KIND[kind])
    return Beginning(node, node.turned)


def _kind_of(
    start: SpecialPoint, kind: SpecialKind | None, period: int
) -> tuple[SpecialKind, int, tuple[Extremum, ...]]:
    own, extrema = start.kind, ()
    if own is SpecialKind.JOINS:
        own, period = SpecialKind.DOUBLING, period // 2
    elif own is SpecialKind.GRAZING and start.extremum is not None:
        extrema = (start.extremum,)
    elif own not in OF_KIND:
        raise GearlashError(f"no curve of this kind is followed: {own}")
    if kind is not None and kind is not own:
        raise GearlashError(f"kind = {kind}: the special point is a {start.kind}")
    return own, period, extrema


def orbit_alone(plane: Plane, place: Array, state: Array, period: int) -> Evaluated:
    """An orbit from phase zero, with nothing asked of it."""
    props = plane.system_at(place)
    size = scale_of(flow.trace(props, state, float(period * props.system.cycles)))
    problem = Problem(plane, period, size)
    return problem.evaluate(np.concatenate([state / size, place / plane.unit]), props)


def _unbound(here: Evaluated) -> Node:
    """A node without equations but that of closing: to be begun elsewhere, and told its extrema."""
    return Node(here, here.jacobian(), np.zeros(len(here.u)), CurveOrbit.of(here), frozenset())


def grazing_node(plane: Plane, place: Array, state: Array, period: int, extremum: Extremum) -> Node:
    """The orbit as a point of the curve on which an extremum touches."""
    node, touch, phase = _with_touch(plane, place, state, period, extremum)
    n = node.problem.states
    problem = replace(node.problem, touches=(touch,))
    u = np.concatenate([node.u[:n], [phase], node.u[n:]])
    return _on_curve(problem, u)


def _with_touch(
    plane: Plane, place: Array, state: Array, period: int, extremum: Extremum
) -> tuple[Node, TouchCondition, float]:
    """The orbit begun about half of it before an extremum, and that as a touch."""
    here = orbit_alone(plane, place, state, period)
    node = _begun(here, extremum.phase - OPPOSITE * here.cycles)
    window = Window(extremum.clearance, extremum.surface, extremum.boundary, 0.0)
    mine = node.motion.beside(extremum.phase, window)
    if mine is None or apart(mine.phase, extremum.phase, here.cycles) > SAME_EXTREMUM:
        raise GearlashError(
            "the orbit has no extremum there whose boundary could be held: a touch of this kind is not "
            "followed in two parameters"
        )
    touch, phase = touch_of(node, mine)
    return node, touch, phase


def _begun(here: Evaluated, origin: float) -> Node:
    """Begun at another phase; the plain orbit has no direction."""
    return begun_at(_unbound(here), origin)


def condition_node(plane: Plane, place: Array, state: Array, period: int, at: At) -> Node:
    """The orbit as a point of the curve of a condition on its multipliers."""
    here = orbit_alone(plane, place, state, period)
    problem = here.problem.with_condition(at, here)
    return _on_curve(problem, here.u)


def _on_curve(problem: Problem, u: Array) -> Node:
    """The nearest point of the curve, its direction that of rising first parameter. Raises `GearlashError`
    where there is none."""
    try:
        row = tangent(problem.evaluate(u).jacobian(), _first_parameter(u))
    except np.linalg.LinAlgError as error:
        raise GearlashError("no curve passes through the start") from error
    corrected = correct(problem, u, row, float(row @ u))
    if corrected.here is None:
        raise GearlashError(f"the start is no point of a curve: {corrected.failure}")
    if float(np.linalg.norm(corrected.here.u - u)) > NEAR_START:
        raise GearlashError("the start is no special orbit of this kind at these values")
    return node_of(corrected, _first_parameter(u), None)


def _first_parameter(u: Array) -> Array:
    toward = np.zeros(len(u))
    toward[-2:] = 1.0, 1e-6
    return toward


def _at_two(
    plane: Plane,
    start: CodimTwoPoint,
    place: Array,
    period: int,
    kind: SpecialKind | None,
    touch: int,
    doubled: bool,
) -> Beginning:
    """From a point at which two things happen."""
    extrema = start.point.touches
    at = OF_TWO.get(start.kind)
    if doubled:
        if start.kind is not CodimTwoKind.GRAZING_DOUBLING:
            raise GearlashError("doubled: only where a grazing orbit has a multiplier -1")
        met = point_of_two(plane, start, place, period)
        return Beginning(doubled_node(met), None, met, ended=CurveEndKind.HALF_PERIOD)
    if kind is SpecialKind.GRAZING or (kind is None and extrema):
        if start.kind is CodimTwoKind.CORNER and touch == 1:
            node = grazing_node(plane, place, start.point.state, period, extrema[0])
            state, other = at_other_end(node)
            node = grazing_node(plane, place, state, period, other)
            point = replace(start.point, state=state, touches=tuple(node.touched), extrema=node.extrema.all)
            return _through(node, replace(start, point=point), place)
        if not 0 <= touch < len(extrema):
            raise GearlashError(f"touch = {touch}: {len(extrema)} extrema touch there")
        node = grazing_node(plane, place, start.point.state, period, extrema[touch])
        return _through(node, start, place)
    if kind is None:
        raise GearlashError("kind: expected fold, doubling or Neimark-Sacker for this point")
    if at is not None and start.kind is not CodimTwoKind.CORNER and OF_KIND[kind] is at:
        met = point_of_two(plane, start, place, period)
        if _holds_along(met):
            raise GearlashError(
                f"all along the grazing curve through this point {met.here.problem.conditions[0].at}: in "
                "this plane both are one curve (kind grazing)"
            )
        clear, deep = clear_side(met), beyond(met)
        if clear is None or not deep:
            raise GearlashError("the curve could not be begun on both sides of the touch")
        return Beginning(deep[0], clear, met, deep[1:])
    node = condition_node(plane, place, start.point.state, period, OF_KIND[kind])
    if kind is SpecialKind.TORUS and start.kind in REAL:
        known = start if _of_this_plane(start, place) else None
        turned = _where_complex(node, REAL[start.kind])
        return Beginning(turned, None, start=known, ended=CurveEndKind.RESONANCE)
    return _through(node, start, place)


def _through(node: Node, start: CodimTwoPoint, place: Array) -> Beginning:
    """A curve through a point; in another plane than that in which the point was found begun beside it, so
    that it is met and solved for there."""
    if _of_this_plane(start, place):
        return Beginning(node, node.turned, start=start)
    row = node.direction
    beside = solved(node.problem, node.u + BESIDE * row, row, float(row @ node.u) + BESIDE, node)[0]
    begun = node if beside is None or not node.problem.plane.inside(beside.place) else beside
    return Beginning(begun, begun.turned)


def _of_this_plane(start: CodimTwoPoint, place: Array) -> bool:
    return bool(np.allclose(start.values, place, rtol=SAME_VALUES, atol=0.0))


def _holds_along(met: Met) -> bool:
    """Whether the condition of a point holds all along the grazing curve through it."""
    here, condition = met.here, met.here.problem.conditions[0]
    alone = replace(here.problem, conditions=())
    row = tangent(met.jacobian[:-1], np.ones(len(here.u)))
    for way in (-BESIDE, BESIDE):
        found = correct(alone, here.u + way * row, row, float(row @ here.u) + way).here
        if found is None or abs(condition.value(found.scaled_monodromy)) > ALONG:
            return False
    return True


def _where_complex(node: Node, real: float) -> Node:
    """With the direction in which the double multiplier ``real`` becomes a pair on the circle; the other way
    the two are real, and their product is 1."""
    here = node.problem.evaluate(node.u + ASIDE * node.direction)
    cosine = circle_cosine(np.linalg.eigvals(here.monodromy).astype(np.complex128))
    return node if (cosine - real) * real < 0.0 else node.turned


def point_of_two(plane: Plane, start: CodimTwoPoint, place: Array, period: int) -> Met:
    """Solved for again."""
    (extremum,) = start.point.touches
    node, touch, phase = _with_touch(plane, place, start.point.state, period, extremum)
    n = node.problem.states
    problem = replace(node.problem, touches=(touch,))
    u = np.concatenate([node.u[:n], [phase], node.u[n:]])
    problem = problem.with_condition(OF_TWO[start.kind], problem.evaluate(u))
    corrected = correct(problem, u)
    if corrected.here is None:
        raise GearlashError(f"the start is no such point: {corrected.failure}")
    here = Evaluated(problem.near(corrected.here), corrected.here.u, corrected.here.props)
    motion = CurveOrbit.of(here)
    mine = motion.beside(float(here.problem.phases(here.u)[0]), touch.window)
    if mine is None:
        raise GearlashError("the extremum that touches is not there")
    return Met(start.kind, here, here.jacobian(), motion, (mine,))


def doubled_node(met: Met) -> Node:
    """The doubled orbit of small amplitude of which one of the two extrema touches, the other being clear:
    where its own grazing curve begins. Raises `GearlashError` where none was found."""
    here = met.here
    n, cycles = here.problem.states, here.cycles
    condition: Condition = here.problem.conditions[0]
    null = condition.solved(here.scaled_monodromy)[0][:n]
    touch, phase = here.problem.touches[0], float(here.problem.phases(here.u)[0])
    problem = replace(
        here.problem, period=2 * here.problem.period, conditions=(), kept=((phase + cycles, touch.window),)
    )
    row = np.concatenate([null / np.linalg.norm(null), np.zeros(3)])
    for amplitude in AMPLITUDES:
        for sign in (1.0, -1.0):
            away = sign * amplitude
            corrected = correct(problem, here.u + away * row, row, float(row @ here.u) + away)
            if corrected.here is None:
                continue
            node = node_of(corrected, sign * row, None)
            other = node.motion.beside(phase + cycles, touch.window)
            if other is None or other.number in node.touching or not is_clear(other):
                continue
            size = float(here.surface_size(touch.window)[0])
            near = float(np.linalg.norm(node.u - here.u)) <= NEAR_POINT
            if near and abs(other.distance) > APART * amplitude * size:
                return node.along(replace(node.problem, kept=()))
    raise GearlashError("no doubled orbit that touches was found near by")
