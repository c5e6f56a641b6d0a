"""All that the study computes with workers, in the order in which it is started."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial

from gearlash import PlaneZone
from gearlash.case import Case
from gearlash.results import Axis, Sweep

from . import plane, stages
from .branching import Following
from .centre import centres
from .claims import Claim
from .opening import Beside, coincidences
from .reproduction import Centre, ReportedZone, RuleEffect, Scan
from .rows import Found, Row, distinct, rows
from .rules import effects
from .scope import Scope
from .stages import Stages
from .zoning import article_zones

Keep = Callable[[str, Sequence[Sweep]], None]


@dataclass(frozen=True, eq=False)
class Computed:
    """Mappings are by the short name of the parameter of a scan, ``omega`` and ``D``."""

    rows: Mapping[str, tuple[Row, ...]]
    found: Mapping[str, Sequence[Found]]
    scans: Mapping[str, Scan]
    beside: Mapping[str, Sequence[Beside]]
    zones: tuple[ReportedZone, ...]
    rules: tuple[RuleEffect, ...]
    centres: tuple[Centre, ...]
    window_plane: PlaneZone | None


def compute(
    case: Case,
    scope: Scope,
    claims: Sequence[Claim],
    executor: Executor,
    steps: Stages,
    keep: Keep | None = None,
) -> Computed:
    """Sweeps, zones, contact rules, branches and what is special on them.

    Branches and the window in the plane are handed to the workers before the zones and read after the rules:
    so no worker waits at the end of a stage.
    """
    axes = {name: Axis.even(name, *scope.limits(name)) for name in ("omega", "D")}
    done = {name: _rows(case, axis, scope, executor, steps, keep) for name, axis in axes.items()}
    found = {name: distinct(each) for name, each in done.items()}
    followed = {
        name: Following.begun(case, name, scope.beside(name), each, executor) for name, each in done.items()
    }
    in_plane = plane.begun(case, scope.omega[:2], scope.beside("omega"), executor)
    with steps.stage(stages.ZONES) as told:
        zones = tuple(
            article_zones(case, claim, axes[claim.parameter], done[claim.parameter], executor, told)
            for claim in claims
            if claim.kind == "zone"
        )
    with steps.stage(stages.RULES):
        rules = effects(case, scope.rules_backlash, scope.fixed, executor)
    with steps.stage(stages.BRANCHES):
        scans = {name: each.scan(found[name], executor) for name, each in followed.items()}
        beside = {name: coincidences(case, scan, executor) for name, scan in scans.items()}
        points = tuple(
            point
            for name, scan in scans.items()
            for point in centres(case, claims, scan, beside[name], executor)
        )
        window = in_plane.result()
    return Computed(done, found, scans, beside, zones, rules, points, window)


def _rows(
    case: Case, axis: Axis, scope: Scope, executor: Executor, steps: Stages, keep: Keep | None
) -> tuple[Row, ...]:
    name = stages.SWEEPS_OMEGA if axis.name == "omega" else stages.SWEEPS_BACKLASH
    kept = None if keep is None else partial(keep, axis.name)
    with steps.stage(name) as told:
        return rows(case, axis, scope.beside(axis.name), executor, told, kept)
