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

    from .article import (
        reproduce as reproduce,
    )
    from .branches import (
        BifurcationPoint as BifurcationPoint,
        GrazingPoint as GrazingPoint,
        locate_grazing as locate_grazing,
        locate_multiplier as locate_multiplier,
    )
    from .branches.continuation import (
        Branch as Branch,
        BranchPoint as BranchPoint,
        ContinuationSettings as ContinuationSettings,
        DerivativeKind as DerivativeKind,
        EndKind as EndKind,
        EndOfBranch as EndOfBranch,
        Extremum as Extremum,
        GrazingLaw as GrazingLaw,
        SpecialKind as SpecialKind,
        SpecialPoint as SpecialPoint,
    )
    from .branches.curves import (
        CodimTwoKind as CodimTwoKind,
        CodimTwoPoint as CodimTwoPoint,
        Curve as Curve,
        CurveEndKind as CurveEndKind,
        CurvePoint as CurvePoint,
        EndOfCurve as EndOfCurve,
    )
    from .case import (
        Case as Case,
        CaseError as CaseError,
        Entry as Entry,
        Note as Note,
        Problem as Problem,
        Provenance as Provenance,
        Scales as Scales,
        Value as Value,
        bundled as bundled,
        schema as case_schema,
        load as load_case,
    )
    from .case.measurement import (
        Measurement as Measurement,
        load_measurement as load_measurement,
        measurement as measurement,
    )
    from .case.kinds import (
        Excitation as Excitation,
        Content as CaseContent,
        Kind as CaseKind,
        register as register_kind,
    )
    from .flow import (
        Carried as Carried,
        Events as Events,
        Extrema as Extrema,
        Hold as Hold,
        ManyStrobes as ManyStrobes,
        Propagators as Propagators,
        Samples as Samples,
        Strobes as Strobes,
        Trace as Trace,
        march as march,
        march_many as march_many,
        propagators as propagators,
        trace as trace,
        variational as variational,
    )
    from .jobs import (
        Cancel as Cancel,
        Execution as Execution,
        NoWorkersError as NoWorkersError,
        Progress as Progress,
        UnfinishedError as UnfinishedError,
    )
    from .orbits import (
        Aperiodic as Aperiodic,
        Attractor as Attractor,
        Certificate as Certificate,
        Exponents as Exponents,
        ForceStatistics as ForceStatistics,
        GrazingCheck as GrazingCheck,
        GrazingConditions as GrazingConditions,
        MotionStatistics as MotionStatistics,
        Neutral as Neutral,
        Orbit as Orbit,
        Section as Section,
        Sections as Sections,
        Settings as Settings,
        Shot as Shot,
        Unresolved as Unresolved,
        Verdict as Verdict,
        attractor as attractor,
        grazing_checks as grazing_checks,
        lyapunov as lyapunov,
        motion_statistics as motion_statistics,
        multipliers as multipliers,
        orbit_at as orbit_at,
        sections as sections,
        shoot as shoot,
    )
    from .orbits.grazing import (
        Surface as Surface,
    )
    from .report.pair import (
        PairReport as PairReport,
        pair_report as pair_report,
    )
    from .results import (
        Axis as Axis,
        Direction as Direction,
        PlaneMap as PlaneMap,
        Point as Point,
        Sweep as Sweep,
        coexisting as coexisting,
        content_hash as content_hash,
        plane_dataset as plane_dataset,
        same_motion as same_motion,
        sweep_dataset as sweep_dataset,
        table as table,
        load as load_dataset,
        save as save_dataset,
    )
    from .results.atlas import (
        Atlas as Atlas,
        AtlasCurve as AtlasCurve,
        AtlasPoint as AtlasPoint,
        LabelChange as LabelChange,
        LabelChangeKind as LabelChangeKind,
        StraightPiece as StraightPiece,
        Undone as Undone,
    )
    from .results.atlas_dataset import (
        atlas_dataset as atlas_dataset,
    )
    from .results.branch_dataset import (
        branch_dataset as branch_dataset,
    )
    from .results.branch_file import (
        load_branch as load_branch,
        save_branch as save_branch,
    )
    from .results.curve_dataset import (
        curve_dataset as curve_dataset,
    )
    from .results.curve_file import (
        load_curve as load_curve,
        save_curve as save_curve,
    )
    from .results.beside import (
        Beside as Beside,
        BesideMotion as BesideMotion,
    )
    from .results.followed import (
        FollowedPath as FollowedPath,
        PassedBifurcation as PassedBifurcation,
    )
    from .results.impact_free import (
        Ending as Ending,
        ImpactFree as ImpactFree,
    )
    from .results.tolerance import (
        Influence as Influence,
        Profile as Profile,
        Tolerance as Tolerance,
        ToleranceInput as ToleranceInput,
        ToleranceMember as ToleranceMember,
    )
    from .studies import (
        Interval as Interval,
        Model as Model,
        Quiet as Quiet,
        Zone as Zone,
        ZoneEnd as ZoneEnd,
        ZoneMotion as ZoneMotion,
        Zones as Zones,
        continue_branch as continue_branch,
        continue_curve as continue_curve,
        first_grazing as first_grazing,
        grazing_law as grazing_law,
        impact_free_speeds as impact_free_speeds,
        map_plane as map_plane,
        open_workers as open_workers,
        point as point,
        sweep as sweep,
        sweeps as sweeps,
        switch_branch as switch_branch,
        zones as zones,
    )
    from .studies.atlas import (
        atlas as atlas,
    )
    from .studies.beside import (
        motions_beside as motions_beside,
    )
    from .studies.comparison import (
        Comparison as Comparison,
        compare as compare,
    )
    from .studies.measured_jumps import MeasuredJump as MeasuredJump
    from .studies.tolerances import (
        tolerance as tolerance,
    )
    from .studies.motion import (
        Motion as Motion,
        Touch as Touch,
        motion as motion,
    )
    from .studies.plane_zone import (
        AxisMargin as AxisMargin,
        BoundaryPart as BoundaryPart,
        PlaneZone as PlaneZone,
        ToleranceMargin as ToleranceMargin,
    )
    from .studies.plane_zones import (
        plane_zone as plane_zone,
    )
    from .studies.transition import (
        Sampled as Sampled,
        Transition as Transition,
    )
    from .studies.transitions import (
        transitions as transitions,
    )
    from .studies.zone import Physical as Physical
    from .studies.zone_end import Margin as Margin
    from .system import (
        BuildError as BuildError,
        Clearance as Clearance,
        ContactRule as ContactRule,
        Family as Family,
        Fourier as Fourier,
        GearlashError as GearlashError,
        MotionKind as MotionKind,
        HasFamily as HasFamily,
        Parameter as Parameter,
        Signature as Signature,
        Status as Status,
        System as System,
        UnknownNameError as UnknownNameError,
        cosines as cosines,
    )

_PUBLIC = {
    # what a system is, and families of one's own
    "gearlash.system": (
        "BuildError",
        "Clearance",
        "ContactRule",
        "Family",
        "Fourier",
        "GearlashError",
        "MotionKind",
        "HasFamily",
        "Parameter",
        "Signature",
        "Status",
        "System",
        "UnknownNameError",
        "cosines",
    ),
    # cases: files with units and provenance
    "gearlash.case": (
        "Case",
        "CaseError",
        "Entry",
        "Note",
        "Problem",
        "Provenance",
        "Scales",
        "Value",
        "bundled",
    ),
    # kinds of case, for one of one's own
    "gearlash.case.kinds": ("Excitation",),
    # one system: its flow, its attractors
    "gearlash.flow": (
        "Carried",
        "Events",
        "Extrema",
        "Hold",
        "ManyStrobes",
        "Propagators",
        "Samples",
        "Strobes",
        "Trace",
        "march",
        "march_many",
        "propagators",
        "trace",
        "variational",
    ),
    "gearlash.orbits": (
        "Aperiodic",
        "Attractor",
        "Certificate",
        "Exponents",
        "ForceStatistics",
        "GrazingCheck",
        "GrazingConditions",
        "MotionStatistics",
        "Neutral",
        "Orbit",
        "Section",
        "Sections",
        "Settings",
        "Shot",
        "Unresolved",
        "Verdict",
        "attractor",
        "grazing_checks",
        "lyapunov",
        "motion_statistics",
        "multipliers",
        "orbit_at",
        "sections",
        "shoot",
    ),
    "gearlash.orbits.grazing": ("Surface",),
    # special points of families
    "gearlash.branches": (
        "BifurcationPoint",
        "GrazingPoint",
        "locate_grazing",
        "locate_multiplier",
    ),
    # branches of periodic orbits
    "gearlash.branches.continuation": (
        "Branch",
        "BranchPoint",
        "ContinuationSettings",
        "DerivativeKind",
        "EndKind",
        "EndOfBranch",
        "Extremum",
        "GrazingLaw",
        "SpecialKind",
        "SpecialPoint",
    ),
    # curves of special orbits in two parameters
    "gearlash.branches.curves": (
        "CodimTwoKind",
        "CodimTwoPoint",
        "Curve",
        "CurveEndKind",
        "CurvePoint",
        "EndOfCurve",
    ),
    # how studies are carried out
    "gearlash.jobs": (
        "Cancel",
        "Execution",
        "NoWorkersError",
        "Progress",
        "UnfinishedError",
    ),
    # many attractors at once, and their datasets
    "gearlash.results": (
        "Axis",
        "Direction",
        "PlaneMap",
        "Point",
        "Sweep",
        "coexisting",
        "content_hash",
        "plane_dataset",
        "same_motion",
        "sweep_dataset",
        "table",
    ),
    "gearlash.results.atlas": (
        "Atlas",
        "AtlasCurve",
        "AtlasPoint",
        "LabelChange",
        "LabelChangeKind",
        "StraightPiece",
        "Undone",
    ),
    "gearlash.results.atlas_dataset": ("atlas_dataset",),
    "gearlash.results.branch_dataset": ("branch_dataset",),
    "gearlash.results.branch_file": ("load_branch", "save_branch"),
    "gearlash.results.curve_dataset": ("curve_dataset",),
    "gearlash.results.curve_file": ("load_curve", "save_curve"),
    "gearlash.results.beside": (
        "Beside",
        "BesideMotion",
    ),
    "gearlash.results.followed": (
        "FollowedPath",
        "PassedBifurcation",
    ),
    "gearlash.results.impact_free": (
        "Ending",
        "ImpactFree",
    ),
    "gearlash.results.tolerance": (
        "Influence",
        "Profile",
        "Tolerance",
        "ToleranceInput",
        "ToleranceMember",
    ),
    "gearlash.studies": (
        "Interval",
        "Model",
        "Quiet",
        "Zone",
        "ZoneEnd",
        "ZoneMotion",
        "Zones",
        "continue_branch",
        "continue_curve",
        "first_grazing",
        "grazing_law",
        "impact_free_speeds",
        "map_plane",
        "open_workers",
        "point",
        "sweep",
        "sweeps",
        "switch_branch",
        "zones",
    ),
    "gearlash.studies.atlas": ("atlas",),
    "gearlash.studies.beside": ("motions_beside",),
    "gearlash.case.measurement": ("Measurement", "load_measurement", "measurement"),
    "gearlash.studies.comparison": ("Comparison", "compare"),
    "gearlash.studies.measured_jumps": ("MeasuredJump",),
    "gearlash.studies.tolerances": ("tolerance",),
    "gearlash.studies.motion": (
        "Motion",
        "Touch",
        "motion",
    ),
    "gearlash.studies.plane_zone": ("AxisMargin", "BoundaryPart", "PlaneZone", "ToleranceMargin"),
    "gearlash.studies.plane_zones": ("plane_zone",),
    "gearlash.studies.transition": ("Sampled", "Transition"),
    "gearlash.studies.transitions": ("transitions",),
    "gearlash.studies.zone": ("Physical",),
    "gearlash.studies.zone_end": ("Margin",),
    # the report of a pair
    "gearlash.report.pair": ("PairReport", "pair_report"),
    # the claims of a publication, judged
    "gearlash.article": ("reproduce",),
}
_RENAMED = {
    "CaseContent": ("gearlash.case.kinds", "Content"),
    "CaseKind": ("gearlash.case.kinds", "Kind"),
    "case_schema": ("gearlash.case", "schema"),
    "load_case": ("gearlash.case", "load"),
    "load_dataset": ("gearlash.results", "load"),
    "register_kind": ("gearlash.case.kinds", "register"),
    "save_dataset": ("gearlash.results", "save"),
}
_WHERE = {name: (room, name) for room, names in _PUBLIC.items() for name in names} | _RENAMED

__all__ = ["__version__", *sorted(_WHERE)]  # pyright: ignore[reportUnsupportedDunderAll]
__version__: str


def __getattr__(name: str) -> typing.Any:
    if name == "__version__":
        return _version()
    if name not in _WHERE:
        import sys

        said = f"module 'gearlash' has no attribute {name!r}"
        raise AttributeError(said, name=name, obj=sys.modules[__name__])  # Python says what is nearest
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
