"""The public names: this list, found lazily, known to type checkers."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path
from typing import get_origin

import pytest

import gearlash

SNAPSHOT = [
    "Aperiodic",
    "Atlas",
    "AtlasCurve",
    "AtlasPoint",
    "Attractor",
    "Axis",
    "AxisMargin",
    "Beside",
    "BesideMotion",
    "BifurcationPoint",
    "BoundaryPart",
    "Branch",
    "BranchPoint",
    "BuildError",
    "Cancel",
    "Carried",
    "Case",
    "CaseContent",
    "CaseError",
    "CaseKind",
    "Certificate",
    "Clearance",
    "CodimTwoKind",
    "CodimTwoPoint",
    "Comparison",
    "ContactRule",
    "ContinuationSettings",
    "Curve",
    "CurveEndKind",
    "CurvePoint",
    "DerivativeKind",
    "Direction",
    "EndKind",
    "EndOfBranch",
    "EndOfCurve",
    "Ending",
    "Entry",
    "Events",
    "Excitation",
    "Execution",
    "Exponents",
    "Extrema",
    "Extremum",
    "Family",
    "FollowedPath",
    "ForceStatistics",
    "Fourier",
    "GearlashError",
    "GrazingCheck",
    "GrazingConditions",
    "GrazingLaw",
    "GrazingPoint",
    "HasFamily",
    "Hold",
    "ImpactFree",
    "Influence",
    "Interval",
    "LabelChange",
    "LabelChangeKind",
    "ManyStrobes",
    "Margin",
    "MeasuredJump",
    "Measurement",
    "Model",
    "Motion",
    "MotionKind",
    "MotionStatistics",
    "Neutral",
    "NoWorkersError",
    "Note",
    "Orbit",
    "PairReport",
    "Parameter",
    "PassedBifurcation",
    "Physical",
    "PlaneMap",
    "PlaneZone",
    "Point",
    "Problem",
    "Profile",
    "Progress",
    "Propagators",
    "Provenance",
    "Quiet",
    "Sampled",
    "Samples",
    "Scales",
    "Section",
    "Sections",
    "Settings",
    "Shot",
    "Signature",
    "SpecialKind",
    "SpecialPoint",
    "Status",
    "StraightPiece",
    "Strobes",
    "Surface",
    "Sweep",
    "System",
    "Tolerance",
    "ToleranceInput",
    "ToleranceMargin",
    "ToleranceMember",
    "Touch",
    "Trace",
    "Transition",
    "Undone",
    "UnfinishedError",
    "UnknownNameError",
    "Unresolved",
    "Value",
    "Verdict",
    "Zone",
    "ZoneEnd",
    "ZoneMotion",
    "Zones",
    "__version__",
    "atlas",
    "atlas_dataset",
    "attractor",
    "branch_dataset",
    "bundled",
    "case_schema",
    "coexisting",
    "compare",
    "content_hash",
    "continue_branch",
    "continue_curve",
    "curve_dataset",
    "cosines",
    "first_grazing",
    "grazing_checks",
    "grazing_law",
    "impact_free_speeds",
    "load_branch",
    "load_case",
    "load_curve",
    "load_dataset",
    "load_measurement",
    "locate_grazing",
    "locate_multiplier",
    "lyapunov",
    "map_plane",
    "march",
    "march_many",
    "measurement",
    "motion",
    "motion_statistics",
    "motions_beside",
    "multipliers",
    "open_workers",
    "orbit_at",
    "pair_report",
    "plane_dataset",
    "plane_zone",
    "point",
    "propagators",
    "register_kind",
    "reproduce",
    "same_motion",
    "save_branch",
    "save_curve",
    "save_dataset",
    "sections",
    "shoot",
    "sweep",
    "sweep_dataset",
    "sweeps",
    "switch_branch",
    "table",
    "tolerance",
    "trace",
    "transitions",
    "variational",
    "zones",
]


def test_snapshot():
    assert sorted(gearlash.__all__) == sorted(SNAPSHOT)


@pytest.mark.parametrize("name", SNAPSHOT)
def test_every_name_is_found_and_described(name: str):
    value = getattr(gearlash, name)
    assert name in dir(gearlash)
    assert name == "__version__" or value.__doc__ or get_origin(value) is not None


def test_another_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'atractor'"):
        gearlash.atractor  # noqa: B018  # pyright: ignore[reportAttributeAccessIssue]


def test_type_checkers_see_the_same_list():
    tree = ast.parse(Path(gearlash.__file__).read_text(encoding="utf-8"))
    blocks = (n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING")
    imports = [n for block in blocks for n in block.body if isinstance(n, ast.ImportFrom)]
    seen = {alias.asname: (f"gearlash.{n.module}", alias.name) for n in imports for alias in n.names}
    assert seen == gearlash._WHERE


def test_importing_the_package_loads_nothing_of_it():
    script = "import sys, gearlash; print(sorted(m for m in sys.modules if '.' not in m or 'gearlash' in m))"
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    heavy = {"numba", "numpy", "pint", "matplotlib", "xarray"}
    loaded = set(ast.literal_eval(ran.stdout))
    assert not loaded & heavy
    assert {m for m in loaded if m.startswith("gearlash")} == {"gearlash"}


def test_using_a_case_does_not_load_the_engine():
    script = "import sys, gearlash; gearlash.load_case('article').family(); print('numba' in sys.modules)"
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "False"


def test_a_name_that_does_not_exist_has_a_neighbour():
    """Python itself looks among the names of the module."""
    ran = subprocess.run(
        [sys.executable, "-c", "import gearlash as gl; gl.sweeep"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 1
    assert ran.stderr.rstrip().endswith("has no attribute 'sweeep'. Did you mean: 'sweep'?")
