"""How it was computed, and how well: method, bounds measured in this run, statuses, certificates,
versions, time."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.report.blocks import Note, Section, Table, Text

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


RULES = (
    (
        "an event (value, labels, boundary)",
        "the nearest located grazing of these labels on this boundary: reproduced within 0.5 %, shifted "
        "within "
        "10 %",
        "the same",
    ),
    (
        "the co-dimension-2 event",
        "a grazing whose own orbit has a multiplier at −1 (|λ + 1| ≤ 10⁻³)",
        "two things, each judged, the verdict is the worse: the value of the doubling and the labels on "
        "the far "
        "sides of doubling and grazing, as any event; and the coincidence: reproduced where both lie "
        "within one "
        "unit of the last printed digit",
    ),
    (
        "a sign of an exponent",
        "the sign, and the verdict of the event it belongs to",
        "the sign alone (about zero: |λ₁| ≤ 10⁻³); at the co-dimension-2 event that of the doubling",
    ),
    (
        "a zone",
        "the interval in which at least one attractor found is quiet, both ends within 0.5 % or 10 %",
        "each reading is compared by itself, with the same limits: cold, up, down, every attractor found, "
        "and "
        "three simple starts. The verdict is that of the reading nearest to the article, which is named "
        "with it; "
        "choosing among seven readings makes agreement more likely, so all are shown",
    ),
    (
        "less sensitive; routes to chaos; the motion at one speed",
        "X − D moves by at most 1 %; a doubling and aperiodic motion with a positive exponent are found; the "
        "label from the cold start",
        "the same",
    ),
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
            "table-rules-of-verdicts",
            "The rule of each verdict: as it was until the bundled case had the values it has now, and as "
            "it is.",
            ("claim about", "rule before", "rule now"),
            RULES,
            widths=(18, 36, 46),
        ),
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
