"""gearlash: where a gear pair with backlash runs quietly, where teeth hit, and where one becomes the other.

    import gearlash as gl

    case = gl.load_case("article", {"pinion_speed": "3600 rpm"})
    family, scales = case.family()
    orbit = gl.attractor(family.system(), family.start())

Everything of `__all__` is imported when it is first used: importing the package itself loads nothing.
"""

from __future__ import annotations

TYPE_CHECKING = False  # not that of `typing`, which loads for longer than it takes to press Ctrl-C

if TYPE_CHECKING:  # the same list for type checkers; a test keeps the two equal
    import typing

    from .article import reproduce as reproduce
    from .branches import (
        BifurcationPoint as BifurcationPoint,
    )
    from .branches import (
        GrazingPoint as GrazingPoint,
    )
    from .branches import (
        locate_grazing as locate_grazing,
    )
    from .branches import (
        locate_multiplier as locate_multiplier,
    )
    from .case import (
        Case as Case,
    )
    from .case import (
        CaseError as CaseError,
    )
    from .case import (
        Scales as Scales,
    )
    from .case import (
        bundled as bundled,
    )
    from .case import (
        load as load_case,  # noqa: F401
    )
    from .flow import (
        Propagators as Propagators,
    )
    from .flow import (
        Trace as Trace,
    )
    from .flow import (
        march as march,
    )
    from .flow import (
        march_many as march_many,
    )
    from .flow import (
        propagators as propagators,
    )
    from .flow import (
        trace as trace,
    )
    from .flow import (
        variational as variational,
    )
    from .jobs import Execution as Execution
    from .orbits import (
        Aperiodic as Aperiodic,
    )
    from .orbits import (
        Neutral as Neutral,
    )
    from .orbits import (
        Orbit as Orbit,
    )
    from .orbits import (
        Settings as Settings,
    )
    from .orbits import (
        Signature as Signature,
    )
    from .orbits import (
        Unresolved as Unresolved,
    )
    from .orbits import (
        attractor as attractor,
    )
    from .orbits import (
        grazing_checks as grazing_checks,
    )
    from .orbits import (
        lyapunov as lyapunov,
    )
    from .orbits import (
        motion_statistics as motion_statistics,
    )
    from .orbits import (
        sections as sections,
    )
    from .results import (
        Axis as Axis,
    )
    from .results import (
        PlaneMap as PlaneMap,
    )
    from .results import (
        Point as Point,
    )
    from .results import (
        Sweep as Sweep,
    )
    from .results import (
        load as load_dataset,  # noqa: F401
    )
    from .results import (
        plane_dataset as plane_dataset,
    )
    from .results import (
        save as save_dataset,  # noqa: F401
    )
    from .results import (
        sweep_dataset as sweep_dataset,
    )
    from .results import (
        table as table,
    )
    from .studies import first_grazing as first_grazing
    from .studies import impact_free_speeds as impact_free_speeds
    from .studies import map_plane as map_plane
    from .studies import open_workers as open_workers
    from .studies import point as point
    from .studies import sweep as sweep
    from .studies import sweeps as sweeps
    from .studies import zones as zones
    from .studies.transitions import transitions as transitions
    from .system import (
        Clearance as Clearance,
    )
    from .system import (
        ContactRule as ContactRule,
    )
    from .system import (
        Family as Family,
    )
    from .system import (
        GearlashError as GearlashError,
    )
    from .system import (
        Parameter as Parameter,
    )
    from .system import (
        Status as Status,
    )
    from .system import (
        System as System,
    )
    from .system import (
        cosines as cosines,
    )

_PUBLIC = {
    # what a system is, and families of one's own
    "gearlash.system": (
        "Clearance",
        "ContactRule",
        "Family",
        "GearlashError",
        "Parameter",
        "Status",
        "System",
        "cosines",
    ),
    # cases: files with units and provenance
    "gearlash.case": ("Case", "CaseError", "Scales", "bundled"),
    # one system: its flow, its attractors
    "gearlash.flow": (
        "Propagators",
        "Trace",
        "march",
        "march_many",
        "propagators",
        "trace",
        "variational",
    ),
    "gearlash.orbits": (
        "Aperiodic",
        "Neutral",
        "Orbit",
        "Settings",
        "Signature",
        "Unresolved",
        "attractor",
        "grazing_checks",
        "lyapunov",
        "motion_statistics",
        "sections",
    ),
    # special points of families
    "gearlash.branches": ("BifurcationPoint", "GrazingPoint", "locate_grazing", "locate_multiplier"),
    "gearlash.jobs": ("Execution",),
    # many attractors at once, and their datasets
    "gearlash.studies": (
        "first_grazing",
        "impact_free_speeds",
        "map_plane",
        "open_workers",
        "point",
        "sweep",
        "sweeps",
        "zones",
    ),
    "gearlash.studies.transitions": ("transitions",),
    "gearlash.article": ("reproduce",),
    "gearlash.results": ("Axis", "PlaneMap", "Point", "Sweep", "plane_dataset", "sweep_dataset", "table"),
}
_RENAMED = {
    "load_case": ("gearlash.case", "load"),
    "load_dataset": ("gearlash.results", "load"),
    "save_dataset": ("gearlash.results", "save"),
}
_WHERE = {name: (room, name) for room, names in _PUBLIC.items() for name in names} | _RENAMED

__all__ = ["__version__", *sorted(_WHERE)]  # pyright: ignore[reportUnsupportedDunderAll]
__version__: str


def __getattr__(name: str) -> typing.Any:
    if name == "__version__":
        return _version()
    if name not in _WHERE:
        raise AttributeError(f"module 'gearlash' has no attribute {name!r}")
    from importlib import import_module

    room, own = _WHERE[name]
    value = getattr(import_module(room), own)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return list(__all__)


def _version() -> str:
    """Of the installed distribution; "unknown" where only the sources are on the path."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("gearlash")
    except PackageNotFoundError:
        return "unknown"
