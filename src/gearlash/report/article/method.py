"""How it was computed, and how well: method, bounds measured in this run, statuses, certificates,
versions, time."""

from __future__ import annotations

from gearlash.report.blocks import Note, Section, Table, Text
from gearlash.studies.article import Reproduction

from .words import plural, yes_or_no

METHOD = (
    "Inside one contact state the equations are linear with periodic coefficients. They are not stepped: "
    "over each cell of a phase grid the affine map of the state is computed once, to rounding, and a mesh "
    "cycle is a handful of small matrix products. Contacts and extrema are roots of the polynomial of the "
    "gap in its cell; that a cell holds none is proved by bounds, not sampled.",
    "Periodic motions are solutions of the closed orbit by Newton’s method with the exact monodromy "
    "matrix; the period is proved least. On them the largest exponent is that of the largest Floquet "
    "multiplier and has no error bar. Aperiodic motions get an average with its error bar, and no period. "
    "A grazing is solved for together with orbit and time of the touch.",
)


def section(done: Reproduction) -> Section:
    """Method and accuracy."""
    run = done.run
    checks = tuple((c.what, c.value, c.bound, yes_or_no(c.holds)) for c in done.checks)
    time = tuple((stage, f"{seconds:.1f} s") for stage, seconds in run.seconds.items())
    statuses = tuple((status, str(count)) for status, count in run.statuses.items())
    certificates = tuple((verdict, str(count)) for verdict, count in run.certificates.items())
    versions = tuple(
        (name.replace("_version", "").replace("_", " "), text) for name, text in run.versions.items()
    )
    blocks = [
        *(Text.of(text) for text in METHOD),
        Table(
            "table-checks",
            "Bounds measured in this run.",
            ("what", "measured", "bound", "holds"),
            checks,
            frozenset({1, 2}),
        ),
        Table(
            "table-statuses",
            "Points of all sweeps by status.",
            ("status", "points"),
            statuses,
            frozenset({1}),
        ),
        Table(
            "table-certificates",
            "Points of all sweeps by certificate. Certified: the orbit closes to 1e-11, its period is least, "
            "no contact was undecided, and neither its impact counts nor its stability can change within its "
            "error. Aperiodic motion is certified where its exponent stands beyond its error bar.",
            ("certificate", "points"),
            certificates,
            frozenset({1}),
        ),
        Table(
            "table-time",
            f"Time of this run, with {plural(run.workers, 'worker')} on {plural(run.cores, 'core')}.",
            ("stage", "time"),
            time,
            frozenset({1}),
        ),
        Table("table-versions", "Versions that computed this report.", ("package", "version"), versions),
        Text.of("The case has the hash ", done.case.hash, " (SHA-256 of all values that decide a result)."),
    ]
    if not run.complete:
        blocks.insert(
            0, Note(Text.of("The run was stopped early; what is missing is left out."), "Incomplete")
        )
    return Section("method", "Method and accuracy", tuple(blocks))
