"""The page about results, made from the answers, the datasets and the statuses themselves."""

from __future__ import annotations

import inspect
import re
import types
from collections.abc import Iterator
from dataclasses import is_dataclass
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from gearlash.cli.exits import MEANINGS
from gearlash.cli.kinds import ANSWER_KINDS, answer_kind
from gearlash.cli.schemas import SIMPLE, described_fields
from gearlash.system import Status

SECTION = re.compile(r"\n\n\w[\w ]*\n-{4,}\n")
"""The heading of a section of a docstring: the page has the text before the first one."""
HEAD = """\
# Results

Made from the program by `python -m tools.reference docs`; do not edit.

## JSON

With `--json` a command prints one JSON object (UTF-8, or ASCII with escapes where the terminal is not
UTF-8); `--out DIR` writes the same object into a file. `gearlash schema --result KIND` prints its JSON
Schema. A number that is not finite is `null`. Numbers are dimensionless unless their name or their record
says a unit; lengths are over D_c, forces over k_m D_c, times over 1/ω_n. Every amplitude says whether it
is a peak, peak-to-peak or rms. `rests_on` names assumed values behind a physical number; in a terminal
such a number carries †.

Input that cannot be used gives a `problem` object and exit code 2; a wrong option is reported on standard
error only.
"""
FOLDER = """\
## The folder of --out

| command | files |
|---|---|
| run | `run.json`, `history.nc`, `spectrum.nc`, `portrait.svg`, `portrait.pdf`, `history.svg`, \
`history.pdf` |
| sweep | `sweep.json`, `sweep.nc`, and of a complete sweep `sweep.svg`, `sweep.pdf` |
| map | `map.json`, `map.nc`, and of a complete map `map.svg`, `map.pdf` |
| branch | `branch.json`, `special.csv`, `branch.svg`, `branch.pdf`, and of every branch N \
`branch-N.json` (for `--resume`), `branch-N.nc`, `branch-N.csv` |
| curve | `curve.json`, `special.csv`, `curve.svg`, `curve.pdf`, the branch begun at as `branch-1.json`, and \
of every curve N `curve-N.json` (for `--resume`), `curve-N.nc`, `curve-N.csv` |
| atlas | `atlas.nc`, `atlas.json`, `atlas.svg`, `atlas.pdf`, and of every curve N `curve-N.json` |
| graze | `graze.json` |
| zones | `zones.json`, `zones.nc`, and of complete sweeps `zones.svg`, `zones.pdf`; \
of two axes `zone.json`, the boundary as `zone.csv`, `zone.svg`, `zone.pdf` |
| tolerance | `tolerance.json`, `tolerance.csv`, `tolerance.svg`, `tolerance.pdf` |
| compare | `compare.json`, `compare.csv`, and of complete work `compare.svg`, `compare.pdf` |
| verify | `verify.json`, and of complete work, each as SVG and PDF, `force` (over time beside the lumped \
model), `orders` (order spectra, 0 dB is the mean force), `lines` (of contact on a tooth as wide as the case \
says, under its torque), `frames` (of the motion as planned whose teeth are apart for the longest) |
| report | `report.html`, `report.json`, `verdict.json`, `figures/`, and as data `speed.csv`, `speed.nc` (a \
row for every point of both sweeps), `history-nominal.csv`, `history-nominal.nc`, `spectrum-nominal.csv`, \
`spectrum-nominal.nc` (the motion at the present speed), `history-hardest.csv`, `history-hardest.nc`, \
`spectrum-hardest.csv`, `spectrum-hardest.nc` (the one with the highest mesh force) |
| reproduce | `report.html`, `report.json`, `reproduce.json`, `figures/`, \
`sweep-omega.nc`, `sweep-omega.json`, `sweep-D.nc`, `sweep-D.json` |

`.gearlash.json` lists the names that gearlash wrote or was about to write there. Before anything is
computed, a command stops with exit code 2 if one of its files is already there and is not listed.

The question of an answer is the command with its options, what the case says (comments, white space and the
order of names say nothing), and the content of other files that options name. The same question writes over
its own answer, but what ends early is not kept where the folder has more of the answer: that stays, and the
command says so. Answers to other questions, and those whose files have changed since a command left them,
are moved into `earlier-1`, each whole.

Columns of the data of `report` have their units in their names (`mesh_force_largest_N`); levels are those
of rms values, in dB over what stands in the name (1 µN and 1 pm, ISO 1683). CSV has commas and decimal
points, NetCDF the same columns with the case as attributes.

`report.json` of `reproduce` holds every number of its report: `format` (1), `case`, `frequency` and
`backlash` (the two sweeps with what was located along them), `events`, `zones`, `window`, `table2`,
`claims`, `checks`, `run`, `rules` (the small study under each contact rule), `scans` (both sweeps as
branches of periodic orbits: special points and ends whole, all other orbits in columns).
Its records have the fields of `gearlash.article.reproduction`; curves are thinned, and complex
numbers are `{"re", "im"}`.
"""
CSV = """\
## Tables as CSV

With `--csv` a command prints its main table, and nothing else, on standard output; with `--out DIR` it
writes all of its tables into the folder instead.

| command | tables, the main one first |
|---|---|
| run | `history.csv` (a row a sample), `spectrum.csv` (a row a line of the order spectrum), `events.csv` |
| sweep | `sweep.csv` (a row a point and direction; bearing forces of a pair), `regimes.csv` |
| map | `map.csv` (a row a pixel) |
| branch | `branch-1.csv` … (a row an orbit), `special.csv` |
| curve | `curve-1.csv` … (a row an orbit), `special.csv` |
| atlas | `curves.csv` (a row an orbit of every curve), `points.csv`, `map.csv` |
| graze | `graze.csv` |
| zones | `zones.csv`, `residents.csv` (motions in them), `sweep.csv`; of two axes `zone.csv` |
| tolerance | `tolerance.csv`, `profile.csv` (between solved ends), `bands.csv`, `inputs.csv` |
| compare | `compare.csv`, `jumps.csv` |
| verify | `verify.csv` (a row a motion of either model), `forces.csv` (over time), `orders.csv`, \
`window.csv`, `breathing.csv` (of the centre distance), `meshes.csv` |
| report | those of its folder |
| check | `check.csv` (a row a value, with unit, origin and range), `notes.csv` |
| reproduce | `claims.csv`, `parts.csv` (of claims that say several things), `checks.csv`, in its folder |

Files are UTF-8, with a line end after every row. The first line has names, with units in brackets in ASCII
(`mesh_force [N]`, `gap [um]`); a name without a unit is dimensionless, and the same quantity may stand in
both. A varied parameter stands first, in the unit that was typed before all others. Numbers have every
digit (converted values of a varied parameter 15), truth values are 1 and 0, an empty cell has no number.
Columns are parted by commas, decimals by points; with `--decimal-comma` by semicolons and commas, and files
begin with the mark of UTF-8: so Excel opens them by a double click where decimals have commas. `gearlash
compare` and `[curves]` of a case read both.
Spreadsheets take some labels (`1-1-0`) for dates: import these columns as text, or use `period`, `drive`
and `back`. What is several numbers a point (states, points on sections) is in the NetCDF files only.

`history.nc` and `spectrum.nc` have the columns of `history.csv` and `spectrum.csv` as variables of one
dimension with `units` and `long_name`. `gap` and `X` are the displacement of the flanks from the middle of
the backlash (half of it is where they touch), `transmission_error` the rotation of both gears along the line
of action. A history is one period of an orbit, or 64 mesh cycles of another
motion, in 256 equal steps a mesh cycle (fewer where a period is longer than 256). Of an orbit the lines of a
spectrum are its Fourier series; of another motion a Hann window is taken. `rms` is that of a line (of order
0 the modulus of the mean), levels are 20 lg of it over what stands in brackets (1 uN, 1 pm, 1 nm/s; of
dimensionless numbers 1).

| reader | |
|---|---|
| pandas | `pd.read_csv("sweep.csv")`; with decimal commas `pd.read_csv("sweep.csv", sep=";", decimal=",")` |
| xarray | `xr.open_dataset("history.nc")` |
| MATLAB | `readtable("sweep.csv", VariableNamingRule="preserve")`; `ncread("history.nc", "mesh_force")` |
| Octave | `pkg load netcdf`; `ncread("history.nc", "mesh_force")` |
| Excel, Calc | open the file; where decimals have commas (German, French, …) that of `--decimal-comma` |
| Excel there, with the other file | Data, From Text/CSV: comma as delimiter, English as locale |
"""
NETCDF = """\
## NetCDF

`sweep.nc` and `zones.nc` are NetCDF 4 files; `gearlash.load_dataset(path)` or any NetCDF reader opens them.
Dimensions are `direction` (cold, up, down), the swept parameter, and for what is several numbers a point
one more, padded with NaN. The root group of a file has what is one number a point, so that
`xarray.open_dataset("sweep.nc").to_dataframe()` is a table (pandas) with a row a point; every further
dimension is a group of its name, with the variables along it: `open_dataset("sweep.nc", group="strobe")`.
`gearlash.load_dataset` puts all of them into one dataset, of which `gearlash.table` makes that table. A
parameter with the name of a variable has `_parameter` behind it. Coordinates: the parameter, dimensionless,
and where the case has scales its physical counterparts (`pinion_speed` in rpm, `mesh_frequency` in Hz,
`backlash` in µm, `torque` in N·m). Every variable has `long_name` and `units`; with scales also
`physical_units` and `physical_factor`. F has the article's sign, F = −Φ. Attributes: `case_json` (the whole
case), `case_hash`, `parameters`, `not_given`, `complete` (0 for a sweep that was stopped; what is missing
has the status `not-computed`), `message`, and the versions of gearlash, numpy, numba and Python.

No file holds types that readers do not share: numbers are of 8, 16, 32 or 64 bits, truth values are 1 and 0
of 8 bits, texts are characters (NC_CHAR, UTF-8) with a last dimension `…_length`. So Octave and every MATLAB
since R2011a read them whole: after `labels = ncread("sweep.nc", "label")` there `labels(:, :, 1)'` has those
of the first direction, one a row; `ncread("sweep.nc", "/strobe/strobes")` reads from a group. xarray makes
texts of characters by itself.
"""
MAPS = """\
`map.nc` has the dimensions of its two axes, which its attributes `x` and `y` name, and `label_name`, the
labels that occur (in the file a group of that name). `label` is an index into those, -1 without a motion;
`status` and `certificate` are codes, named by their attributes `flag_values` and `flag_meanings`.
Coordinates and attributes are those of a sweep; `reasons` (JSON) lists row, column and reason of every
failed pixel.
"""
BRANCHES = """\
`atlas.nc` is the map behind the atlas (as `map.nc`) with two more dimensions: along `curve_point` lie the
orbits of all curves (`curve` is the number, `curve_x` and `curve_y` are the parameters), along `two` the
points where two things happen at once. `curve-N.json` is what `gearlash.load_curve` reads.

`branch-N.nc` has the dimension `point`, the orbits in their order along the branch: the parameter, a
coordinate, may turn round. Further ones are `state_name`, `strobe`, `multiplier`, and `special` and `end`
for the special points (`special_value`, `special_kind` …) and both ends. `branch-N.csv` is the table of its
orbits, `special.csv` that of all special points. Coordinates and attributes are those of a sweep;
`unexplained` (JSON) lists steps on which something changed that no special point was found for.
`branch-N.json` keeps every number to its last digit, in a format with a version, for
`gearlash.load_branch` and `--resume`.
"""
CURVES = """\
`curve-N.nc` has the dimension `point`, the orbits in their order along the curve, with both parameters as
coordinates, named by the attributes `x` and `y`; further ones are `state_name`, `multiplier`, `special` (the
points at which two things happen at once: `special_kind`, and of either parameter the value and its error)
and `end`. `curve-N.csv` is the table of its orbits, `special.csv` that of all these points. `curve-N.json`
keeps every number to its last digit, for `gearlash.load_curve` and `--resume`.
"""


CERTIFICATES = """\
## Certificates

Every attractor and every point of a sweep carries one, with its reasons; a pixel of a map has the verdict.

| certificate | what it means |
|---|---|
| `certified` | see below |
| `uncertain` | something of it does not hold; the reason has the numbers. Or the motion is unresolved |
| `failed` | the system could not be built or solved, the orbit does not close, or the motion ran away |

A periodic orbit is certified if its residual is at most 1e-11, its period least, no contact undecided, no
extremum within the error of a boundary that it could touch, and its leading multiplier farther from modulus
1 than its own error. An aperiodic motion is certified if no contact was undecided in the transient and the
stretch that is kept, and its exponent is farther from zero than its error bar.

A certificate vouches for the motion of the model as given: that this orbit exists, with this signature and
this stability. It says nothing about values of the case that are inferred or assumed, about other
attractors that may coexist, about whether the model describes a real pair, nor (of aperiodic motion) that
it is no transient longer than what was computed. What it rests on is in [theory.md](theory.md).
"""


def results_page() -> str:
    """The whole page, Markdown."""
    parts = [HEAD]
    seen: set[type] = set()
    for kind in ANSWER_KINDS:
        parts.append("\n".join(_answer(kind, answer_kind(kind), seen)))
    parts += [
        FOLDER,
        CSV,
        NETCDF,
        "\n".join(_variables()),
        MAPS,
        "\n".join(_map_variables()),
        BRANCHES,
        "\n".join(_branch_variables()),
        CURVES,
        "\n".join(_curve_variables()),
        "\n".join(_statuses()),
        CERTIFICATES,
        "\n".join(exit_codes()),
    ]
    return "\n\n".join(part.strip() for part in parts) + "\n"


def exit_codes() -> Iterator[str]:
    """The table of exit codes."""
    yield "## Exit codes"
    yield ""
    yield "| code | meaning |"
    yield "|---|---|"
    for code, meaning in MEANINGS.items():
        yield f"| {int(code)} | {meaning} |"


def _answer(kind: str, answer: type, seen: set[type]) -> Iterator[str]:
    """An answer and every record in it that was not described before."""
    yield from _record(f"### `{kind}`: {_first(answer)}", answer)
    for record in _nested(answer):
        if record not in seen:
            seen.add(record)
            yield ""
            yield from _record(f"#### {record.__name__}", record, _first(record))


def _record(title: str, record: type, about: str = "") -> Iterator[str]:
    yield title
    yield ""
    if about:
        yield f"{about}."
        yield ""
    yield "| field | type | |"
    yield "|---|---|---|"
    for name, kind, text in described_fields(record):
        yield f"| `{name}` | {_type(kind)} | {_cell(text)} |"


def _first(record: type) -> str:
    text = SECTION.split(inspect.cleandoc(record.__doc__ or ""))[0]
    doc = " ".join(text.split())
    return _cell(doc.rstrip("."))


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _nested(record: type) -> Iterator[type]:
    """Records inside a record, depth first, each once."""
    found: dict[type, None] = {}

    def look(kind: Any) -> None:
        if kind in SIMPLE:
            return
        if isinstance(kind, type) and is_dataclass(kind) and kind not in found:
            found[kind] = None
            for _, inner, _ in described_fields(kind):
                look(inner)
        for inner in get_args(kind):
            look(inner)

    for _, kind, _ in described_fields(record):
        look(kind)
    yield from found


def _type(kind: Any) -> str:
    """A type in words."""
    if kind in SIMPLE:
        return SIMPLE[kind]
    if isinstance(kind, type) and is_dataclass(kind):
        return f"[{kind.__name__}](#{kind.__name__.lower()})"
    origin, inside = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _type(inside[0])
    if origin is Literal:
        return " or ".join(f"`{value}`" for value in inside)
    if origin in (Union, types.UnionType):
        return " or ".join(_type(one) for one in inside)
    if origin is tuple and inside[-1] is Ellipsis:
        return f"list of {_type(inside[0])}"
    if origin is tuple:
        return "[" + ", ".join(_type(one) for one in inside) + "]"
    return f"object of {_type(inside[1])}"


def _variables() -> Iterator[str]:
    from gearlash.results.variables import PADDED, SCALARS

    yield "| variable | dimensions beyond (direction, parameter) | unit | |"
    yield "|---|---|---|---|"
    for variable in SCALARS:
        yield f"| `{variable.name}` | | {variable.units} | {_cell(variable.long_name)} |"
    for variable, dimension in PADDED:
        yield f"| `{variable.name}` | `{dimension}` | {variable.units} | {_cell(variable.long_name)} |"


def _map_variables() -> Iterator[str]:
    from gearlash.results.plane_dataset import VARIABLES

    yield "| variable of a map | unit | |"
    yield "|---|---|---|"
    for variable in VARIABLES.values():
        yield f"| `{variable.name}` | {variable.units} | {_cell(variable.long_name)} |"


def _branch_variables() -> Iterator[str]:
    from gearlash.results.branch_dataset import BOUNDARIES, MEASURED, POINTWISE, SPECIAL

    yield "| variable of a branch | dimension | unit | |"
    yield "|---|---|---|---|"
    for variable in (*POINTWISE, *BOUNDARIES, *MEASURED):
        yield f"| `{variable.name}` | `point` | {variable.units} | {_cell(variable.long_name)} |"
    for variable in SPECIAL:
        yield f"| `special_{variable.name}` | `special` | {variable.units} | {_cell(variable.long_name)} |"


def _curve_variables() -> Iterator[str]:
    from gearlash.results.curve_dataset import POINTWISE, SPECIAL

    yield "| variable of a curve | dimension | unit | |"
    yield "|---|---|---|---|"
    for variable in POINTWISE:
        yield f"| `{variable.name}` | `point` | {variable.units} | {_cell(variable.long_name)} |"
    for variable in SPECIAL:
        yield f"| `special_{variable.name}` | `special` | {variable.units} | {_cell(variable.long_name)} |"


def _statuses() -> Iterator[str]:
    yield "## Statuses"
    yield ""
    yield "Of attractors, points and located values; only `ok` is a result to rely on without reading on."
    yield "Only points of sweeps and maps are `failed` (the message says why) or `not-computed` (stopped"
    yield "before). A run and a study as a whole are `not-excited` where nothing in the system varies with"
    yield "time, or nothing that varies moves it: then nothing was asked (give ripple or error). A study as a"
    yield "whole is `incomplete` if it was stopped, `failed` if no point is ok, `partly-failed` if a point"
    yield "has no motion or most are not ok: its sentence counts them and gives the first reason."
    yield ""
    yield "| status | what to do |"
    yield "|---|---|"
    for status in Status:
        yield f"| `{status}` | {_cell(status.advice)} |"
