"""A corpus of bad case files: one right file, and in every row one thing made wrong in it.

Each row has a kind, what is replaced by what, and what must be told: the path, the value as it stands there,
words of what is expected, the nearest name if there is one.
"""

from __future__ import annotations

from typing import NamedTuple

HELICAL = """
kind = "helical-pair"
[pinion]
teeth = 28
mass = "5.98 kg"
bearing_stiffness_y = "8.0e8 N/m"
bearing_stiffness_z = "6.8e8 N/m"
[gear]
teeth = 70
mass = "34.72 kg"
bearing_stiffness_y = "4.0e8 N/m"
bearing_stiffness_z = "3.2e8 N/m"
[bearings]
damping_ratio = 0.02
[mesh]
normal_module = "4 mm"
pressure_angle = "20 deg"
helix_angle = "18 deg"
mean_stiffness = "3.2e8 N/m"
damping_ratio = 0.07
backlash = "100 um"
ripple = 0.3
error = "13 um"
[operation]
pinion_speed = "4000 rpm"
torque = "95 N·m"
"""
SPUR = """
kind = "spur-1dof"
[pinion]
teeth = 16
base_radius = "50 mm"
inertia = "0.00115 kg·m²"
[gear]
base_radius = "50 mm"
inertia = "0.00115 kg·m²"
[mesh]
mean_stiffness = "3.8e8 N/m"
damping_ratio = 0.05
backlash = "200 um"
[dimensionless]
omega = 0.5
load = 0.1
"""


class Bad(NamedTuple):
    """One kind of bad input in a file."""

    kind: str
    old: str
    new: str
    path: str
    value: str | None
    expected: str
    nearest: str | None = None
    base: str = HELICAL

    @property
    def text(self) -> str:
        """The file."""
        assert self.old in self.base
        return self.base.replace(self.old, self.new, 1)


MODULE, GAP, STIFF = '"4 mm"', '"100 um"', '"3.2e8 N/m"\ndamp'
RATIO, RIPPLE, SPEED, TORQUE, OP = (
    "damping_ratio = 0.02",
    "ripple = 0.3",
    '"4000 rpm"',
    '"95 N·m"',
    "[operation]",
)
NM, BL, MS, XB = "mesh.normal_module", "mesh.backlash", "mesh.mean_stiffness", "bearings.damping_ratio"
PS, TQ, TP = "operation.pinion_speed", "operation.torque", "pinion.teeth"

# fmt: off
VALUES = [
    Bad("a stray semicolon", MODULE, '"4 mm;"', NM, "4 mm;", "'mm;' is no unit", "4 mm"),
    Bad("not a number", MODULE, '"nan mm"', NM, "nan mm", "not a finite number"),
    Bad("infinite", MODULE, '"inf mm"', NM, "inf mm", "not a finite number"),
    Bad("minus infinity as a speed", SPEED, '"-inf rpm"', PS, "-inf rpm", "not a finite number"),
    Bad("overflow", MODULE, '"1e999 mm"', NM, "1e999", "too large to be a number"),
    Bad("underflow", MODULE, '"1e-400 mm"', NM, "1e-400", "double precision"),
    Bad("another dimension", MODULE, '"4 kg"', NM, "4 kg", "a length with its unit"),
    Bad("kg for mm in a mass", '"5.98 kg"', '"5.98 mm"', "pinion.mass", "5.98 mm", "a mass with its unit"),
    Bad("a weight as a mass", '"5.98 kg"', '"58.6 N"', "pinion.mass", "58.6 N", "a mass with its unit"),
    Bad("no unit in a text", MODULE, '"4"', NM, "'4'", "a length with its unit", "4 mm"),
    Bad("no unit at all", MODULE, "4", NM, "4", "a length with its unit"),
    Bad("a NaN of TOML", MODULE, "nan", NM, "nan", "a length with its unit"),
    Bad("a NaN as a ratio", "damping_ratio = 0.07", "damping_ratio = nan", "mesh.damping_ratio", "nan",
        "not finite"),
    Bad("an infinity as a ratio", RIPPLE, "ripple = inf", "mesh.ripple", "inf", "not finite"),
    Bad("an empty text", MODULE, '""', NM, "''", "nothing stands there"),
    Bad("blanks", MODULE, '"   "', NM, "'   '", "nothing stands there"),
    Bad("a boolean", MODULE, "true", NM, "True", "a length with its unit"),
    Bad("a list", MODULE, "[4]", NM, "[4]", "a length with its unit"),
    Bad("a date", MODULE, "1979-05-27", NM, "1979", "a length with its unit"),
    Bad("a time", MODULE, "07:32:00", NM, "time", "a length with its unit"),
    Bad("a comma of two meanings", MODULE, '"4,000 mm"', NM, "4,000", "write 4.000 or 4000"),
    Bad("two commas", MODULE, '"4,0,0 mm"', NM, "4,0,0", "several commas"),
    Bad("a number in words", MODULE, '"four mm"', NM, "four", "does not start with a number"),
    Bad("a tolerance", MODULE, '"4 ± 0.1 mm"', NM, "±", "not two limits: it is nominal", "4 mm"),
    Bad("a range of values", MODULE, '"4-5 mm"', NM, "4-5", "not two limits: it is nominal"),
    Bad("about", MODULE, '"~4 mm"', NM, "~4", "does not start with a number", "4 mm"),
    Bad("a power of ten without its sign", MODULE, '"4·10 -3 m"', NM, "4·10", "a power of ten is written"),
    Bad("a fraction", MODULE, '"1/6 inch"', NM, "1/6", "a unit is missing"),
    Bad("two values in one", MODULE, '"4 mm 5 um"', NM, "4 mm 5 um", "'5' is no unit"),
    Bad("digits in groups", MODULE, '"1_000 um"', NM, "1_000", "no unit"),
    Bad("hexadecimal", MODULE, '"0x10 mm"', NM, "0x10", "no unit"),
    Bad("brackets", MODULE, '"4 (mm)"', NM, "(mm)", "no unit", "4 mm"),
    Bad("a null character", MODULE, '"4 mm\\u0000"', NM, "x00", "a control character"),
    Bad("a terminal sequence", MODULE, '"4 \\u001b[31mmm"', NM, "x1b", "a control character"),
    Bad("an unseen separator", MODULE, '"4 mm\\u001f"', NM, "x1f", "a control character"),
    Bad("the square of a unit", MODULE, '"4 mm²"', NM, "mm²", "a length with its unit"),
    Bad("an unknown unit", MODULE, '"4 furlongish"', NM, "furlongish", "'furlongish' is no unit"),
    Bad("a temperature", '"20 deg"', '"20 degC"', "mesh.pressure_angle", "degC", "an angle with its unit"),
    Bad("beyond the range", MODULE, '"4 m"', NM, "4 m", "up to 200 mm"),
    Bad("a prefix in the wrong case", MODULE, '"4 Mm"', NM, "4 Mm", "up to 200 mm"),
    Bad("a negative length", MODULE, '"-4 mm"', NM, "-4", "above 0 mm"),
    Bad("a Cyrillic letter in a unit", GAP, '"100 мm"', BL, "мm", "'мm' is no unit"),
    Bad("a letter like µ", GAP, '"100 ɥm"', BL, "ɥm", "'ɥm' is no unit"),
    Bad("um in the wrong case", GAP, '"100 uM"', BL, "uM", "'uM' is no unit", "100 um"),
    Bad("a negative backlash", GAP, '"-1 um"', BL, "-1", "from 0 um"),
    Bad("no backlash to measure by", GAP, '"0 um"', "model.reference_length", None,
        "no backlash to take half of"),
    Bad("a negative mass", '"5.98 kg"', '"-5.98 kg"', "pinion.mass", "-5.98", "above 0 kg"),
    Bad("a mass of nothing", '"5.98 kg"', '"0 kg"', "pinion.mass", "0 kg", "above 0 kg"),
    Bad("a capital in kg", '"5.98 kg"', '"5.98 kG"', "pinion.mass", "kG", "a mass", "5.98 kg"),
    Bad("half a tooth", "teeth = 28", "teeth = 28.5", TP, "28.5", "a whole number"),
    Bad("no teeth", "teeth = 28", "teeth = 0", TP, "0", "a whole number from 5"),
    Bad("negative teeth", "teeth = 28", "teeth = -28", TP, "-28", "a whole number from 5"),
    Bad("teeth with a unit", "teeth = 28", 'teeth = "28 mm"', TP, "28 mm", "a whole number"),
    Bad("teeth as true", "teeth = 28", "teeth = true", TP, "True", "a whole number"),
    Bad("an angle without unit", '"20 deg"', "20", "mesh.pressure_angle", "20", "an angle with its unit"),
    Bad("an angle too large", '"20 deg"', '"90 deg"', "mesh.pressure_angle", "90", "up to 89.91 deg"),
    Bad("an angle of nothing", '"20 deg"', '"0 deg"', "mesh.pressure_angle", "0 deg", "above 0 deg"),
    Bad("degrees taken for radians", '"20 deg"', '"20 rad"', "mesh.pressure_angle", "20 rad",
        "up to 89.91 deg"),
    Bad("degrees and minutes", '"18 deg"', '"18 deg 30 min"', "mesh.helix_angle", "30 min",
        "'30' is no unit"),
    Bad("an angle too negative", '"18 deg"', '"-95 deg"', "mesh.helix_angle", "-95", "from -89.91 deg"),
    Bad("a torque as a stiffness", STIFF, '"3.2e8 Nm"\ndamp', MS, "Nm", "that is a torque", "3.2e8 N/m"),
    Bad("a negative stiffness", STIFF, '"-3.2e8 N/m"\ndamp', MS, "-3.2e8", "above 0 N/m"),
    Bad("a slash too many", STIFF, '"320 N/um/um"\ndamp', MS, "N/um/um", "a stiffness with its unit"),
    Bad("a negative damping ratio", "damping_ratio = 0.07", "damping_ratio = -1", "mesh.damping_ratio",
        "-1", "from 0"),
    Bad("a ratio with a unit", RATIO, 'damping_ratio = "7 mm"', XB, "7 mm", "a number without unit"),
    Bad("a frequency as a shaft speed", SPEED, '"60 Hz"', PS, "60 Hz", "a rotational speed"),
    Bad("standstill", SPEED, '"0 rpm"', PS, "0 rpm", "above 0 rpm"),
    Bad("running backwards", SPEED, '"-4000 rpm"', PS, "-4000", "above 0 rpm"),
    Bad("a speed without unit", SPEED, "4000", PS, "4000", "a rotational speed with its unit"),
    Bad("rpm with stops", SPEED, '"4000 r.p.m."', PS, "r.p.m.", "'p' is no unit", "4000 rpm"),
    Bad("a force as a torque", TORQUE, '"95 N"', TQ, "95 N", "a torque with its unit"),
    Bad("mN for Nm", TORQUE, '"95 mN"', TQ, "95 mN", "a torque with its unit"),
    Bad("a torque beyond all", TORQUE, '"1e10 N·m"', TQ, "1e10", "up to 1e+09 N*m"),
    Bad("stiffness negative in the cycle", RIPPLE, "ripple = 1.2", "mesh.ripple", "1.2",
        "stiffness positive"),
    Bad("per cent as a number", RIPPLE, "ripple = 30", "mesh.ripple", "30", "up to 2"),
    Bad("two per cent signs", RIPPLE, 'ripple = "30%%"', "mesh.ripple", "30%%", "'%%' is no unit"),
    Bad("ω of zero", "omega = 0.5", "omega = 0", "dimensionless.omega", "0", "above 0", None, SPUR),
    Bad("ω negative", "omega = 0.5", "omega = -0.5", "dimensionless.omega", "-0.5", "above 0", None, SPUR),
    Bad("an integer beyond floats", "omega = 0.5", "omega = 1" + "0" * 400, "dimensionless.omega", "1000",
        "a number", None, SPUR),
]
NAMES = [
    Bad("a misspelt name", "backlash =", "backlsh =", "mesh.backlsh", "100 um", "a name that exists", BL),
    Bad("a misspelt table", "[mesh]", "[mehs]", "mehs", "{", "a name that exists", "mesh"),
    Bad("a table in capitals", OP, "[OPERATION]", "OPERATION", "{", "a name that exists", "operation"),
    Bad("the wrong table", f"{OP}\n", f"{OP}\nbacklash = '1 um'\n", "operation.backlash", "1 um",
        "exists", BL),
    Bad("a harmonic too high", RIPPLE, "ripple_9 = 0.3", "mesh.ripple_9", "0.3", "a name that exists",
        "mesh.ripple_8"),
    Bad("the first harmonic numbered", RIPPLE, "ripple_1 = 0.3", "mesh.ripple_1", "0.3", "exists",
        "mesh.ripple"),
    Bad("an unknown name", "[pinion]", '[pinion]\ncolour = "red"', "pinion.colour", "red",
        "a name that exists"),
    Bad("a name outside any table", "[pinion]", 'include = "/etc/passwd"\n[pinion]', "include", "passwd",
        "exists"),
    Bad("a word of drawings", "[pinion]", '[pinion]\nweight = "1 kg"', "pinion.weight", "1 kg", "exists",
        "pinion.mass"),
    Bad("a unit for a name", OP, f'{OP}\nrpm = "4200"', "operation.rpm", "4200", "exists",
        "operation.pinion_speed"),
    Bad("a quantity that has no place", OP, f'{OP}\nlosses = "2 kW"', "operation.losses", "2 kW", "exists"),
    Bad("a name with a terminal sequence", "[pinion]", '[pinion]\n"\\u001b[31m" = 1', "pinion.\x1b[31m",
        "1", "exists"),
    Bad("a table in a table", OP, "[operation.x]", "operation.x", "{", "a name that exists"),
    Bad("a value where a table stands", "[pinion]", "model = 0.02\n[pinion]", "model", "0.02",
        "a table [model]"),
    Bad("a list of tables", OP, "[[operation]]", "operation", "[{", "a table [operation]"),
    Bad("a key below a value", "backlash =", "backlash.x =", BL, "{", "without 'x'"),
    Bad("a misspelt kind", '"helical-pair"', '"helical-par"', "kind", "helical-par",
        "one of helical-pair", "helical-pair"),
    Bad("a kind in capitals", '"helical-pair"', '"HELICAL-PAIR"', "kind", "HELICAL",
        "one of helical-pair", "helical-pair"),
    Bad("a kind that is no text", '"helical-pair"', "3", "kind", "3", "one of helical-pair"),
    Bad("an empty kind", '"helical-pair"', '""', "kind", "''", "one of helical-pair"),
    Bad("no kind", 'kind = "helical-pair"', "", "kind", None, "as the first line"),
    Bad("places of another kind", '"helical-pair"', '"spur-1dof"', "mesh.helix_angle", "18 deg",
        "a name that exists"),
    Bad("a value missing", 'mass = "5.98 kg"\n', "", "pinion.mass", None, "a mass with its unit"),
]
PROVENANCE = [
    Bad("a table without value", RATIO, "damping_ratio = {}", XB, "{}", "a table with a value"),
    Bad("a misspelt key", RATIO, 'damping_ratio = { value = 1, provenence = "given" }', XB, "provenence",
        "without 'provenence'", "provenance"),
    Bad("a misspelt provenance", RATIO, 'damping_ratio = { value = 1, provenance = "asumed" }', XB,
        "asumed", "out of given", "assumed"),
    Bad("a provenance that is no text", RATIO, "damping_ratio = { value = 1, provenance = 3 }", XB, "3",
        "a provenance out of"),
    Bad("a reason that is no text", RATIO, "damping_ratio = { value = 1, reason = 3 }", XB, "3",
        "a reason in words"),
    Bad("a reason that steers a terminal", RATIO, 'damping_ratio = { value = 1, reason = "\\u001b[2J" }',
        XB, "x1b", "without control characters"),
    Bad("a value in a value", RATIO, "damping_ratio = { value = { value = 1 } }", XB, "{",
        "a number without unit"),
    Bad("a unit of its own", GAP, '{ value = 100, unit = "um" }', BL, "100", "without 'unit'"),
]
OPTIONS = [
    Bad("a misspelt option", OP, f'[model]\nprojection = "bas"\n{OP}', "model.projection", "bas",
        "one of pitch", "base"),
    Bad("an option that is no text", OP, f"[model]\ncontact = 1\n{OP}", "model.contact", "1",
        "one of always"),
    Bad("a blank for a hyphen", OP, f'[model]\ncontact = "no tension"\n{OP}', "model.contact",
        "no tension", "one of", "no-tension"),
    Bad("an unknown option", OP, f'[model]\nbody = "ring"\n{OP}', "model.body", "ring",
        "one of solid-disc"),
    Bad("a unit of length of nothing", OP, f'[model]\nreference_length = "0 um"\n{OP}',
        "model.reference_length", "0 um", "above 0 um"),
]
TEXTS = [
    Bad("a name that is no text", "[pinion]", "name = 3\n[pinion]", "name", "3", "a text"),
    Bad("a name of two lines", "[pinion]", 'name = "a\\nb"\n[pinion]', "name", "a\\nb",
        "a name in one line"),
    Bad("a name too long", "[pinion]", f'name = "{"n" * 201}"\n[pinion]', "name", "nnn", "at most 200"),
    Bad("a name that steers a terminal", "[pinion]", 'name = "\\u001b]0;x\\u0007"\n[pinion]', "name",
        "x1b", "without control"),
    Bad("a name that runs backwards", "[pinion]", 'name = "\\u202Egpj"\n[pinion]', "name", "u202e",
        "U+202E"),
    Bad("a null in a description", "[pinion]", 'description = "a\\u0000b"\n[pinion]', "description",
        "x00", "U+0000"),
    Bad("a description too long", "[pinion]", f'description = "{"d" * 20_001}"\n[pinion]', "description",
        "ddd", "at most 20,000"),
    Bad("a source that is no table", "[pinion]", 'source = "me"\n[pinion]', "source", "me",
        "a table [source]"),
    Bad("a source with an unknown name", OP, f"[source]\npages = '3'\n{OP}", "source.pages", "3",
        "a name that exists"),
    Bad("a DOI that is no text", OP, f"[source]\ndoi = 3\n{OP}", "source.doi", "3", "a text"),
    Bad("authors that are no list", OP, f'[source]\nauthors = "me"\n{OP}', "source.authors", "me",
        "a list of texts"),
    Bad("an author that is no text", OP, f"[source]\nauthors = [3]\n{OP}", "source.authors.0", "3",
        "a text"),
]
TWICE = [
    Bad("shaft speed and mesh frequency", f"{OP}\n", f'{OP}\nmesh_frequency = "1680 Hz"\n', PS,
        "4000 rpm", "mesh_frequency = '1680 Hz'"),
    Bad("backlash and D", OP, f"[dimensionless]\nD = 0.8\n{OP}", "dimensionless.D", "0.8",
        "mesh.backlash = '100 um'"),
    Bad("torque and load", OP, f"[dimensionless]\nload = 0.1\n{OP}", "dimensionless.load", "0.1",
        "torque = '95 N·m'"),
    Bad("one ripple in two tables", OP, f"[dimensionless]\nripple = 0.1\n{OP}", "dimensionless.ripple",
        "0.1", "mesh.ripple"),
    Bad("all bearings and one of them", "[gear]", "bearing_damping_y = 0.05\n[gear]",
        "pinion.bearing_damping_y", "0.05", XB),
    Bad("what follows from angles", OP, f"[dimensionless]\ny_factor = 0.9\n{OP}",
        "dimensionless.y_factor", "0.9", "follows"),
    Bad("what follows from inertias", "[mesh]", '[mesh]\nequivalent_mass = "0.23 kg"',
        "mesh.equivalent_mass", "0.23 kg", "follows from both", None, SPUR),
]
SYNTAX = [
    Bad("a quote that does not end", TORQUE, '"95 N·m', "line 26", None, "valid TOML"),
    Bad("a table twice", OP, "[mesh]", "line 24", None, "valid TOML"),
    Bad("a name twice", "teeth = 28", "teeth = 28\nteeth = 29", "line 5", None, "valid TOML"),
    Bad("two values on a line", MODULE, '"4 mm" 3', "line 16", None, "valid TOML"),
    Bad("no quotes", MODULE, "4 mm", "line 16", None, "valid TOML"),
    Bad("a table that is a set", RATIO, "damping_ratio = { 0.02 }", "line 14", None, "valid TOML"),
    Bad("a null character in the file", "[pinion]", "\x00[pinion]", "line 3", None, "valid TOML"),
    Bad("a merge mark", "[pinion]", "<<<<<<< mine\n[pinion]", "line 3", None, "valid TOML"),
    Bad("JSON", HELICAL, '{"kind": "helical-pair"}', "line 1", None, "valid TOML"),
    Bad("YAML", HELICAL, "kind: helical-pair\n", "line 1", None, "valid TOML"),
    Bad("nesting without end", "[pinion]", "a = " + "[" * 5000, "file", None, "nested less deeply"),
    Bad("a number of 5000 digits", "[pinion]", "a = " + "9" * 5000, "file", None, "valid TOML"),
]
# fmt: on
BAD_FILES = [*VALUES, *NAMES, *PROVENANCE, *OPTIONS, *TEXTS, *TWICE, *SYNTAX]
