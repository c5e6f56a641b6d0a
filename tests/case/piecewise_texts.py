"""A small piecewise-linear case file that tests start from: every table and every form is in it."""

TEXT = """
kind = "piecewise-linear"
name = "two masses"
states = ["x", "x'", "y", "y'"]
cycles = 2

[parameters]
omega = 0.9
zeta = { value = 0.05, lower = 0.0, upper = 1.0, description = "damping ratio" }
gap = { value = 0.3, provenance = "assumed", reason = "a guess" }
F = 1.5
phase = 0.25

[definitions]
c = "2*zeta"
half = "c/2"

[matrix]
x = { "x'" = 1 }
"x'" = { x = -2, "x'" = "-c", y = 1 }
y = { "y'" = 1.0 }
"y'" = { x = "half/zeta", y = "-(1 + 0)", "y'" = "-half" }

[forcing]
"x'" = { mean = "F/3", cos = [0, "F"], sin = [0.5] }
"y'" = { amplitudes = ["F"], phases = ["phase"], orders = [4] }

[initial]
x = "gap + F"

[[clearance]]
name = "stop"
h = { x = 1, y = -1 }
g = [0, -1, 0, "1"]
gap_plus = "gap"
gap_minus = 2
stiffness_plus = { mean = 3, amplitudes = ["F/10", 0.25] }
stiffness_minus = 0
damping = "zeta"
damping_minus = 0.0
offset = { sin = ["gap/10"], orders = [2] }
contact = "in-contact"

[[clearance]]
name = "wall"
h = [1, 0, 0, 0]
g = { "x'" = -1 }
gap_plus = 5
gap_minus = "gap*2"
stiffness_plus = 1
stiffness_minus = "F"
contact = "no-tension"
"""


def dense() -> str:
    """The same case with its matrix, forcing and vectors as arrays."""
    head, _, rest = TEXT.partition("[parameters]")
    body, _, clearances = rest.partition("[[clearance]]")
    tables = body.partition("[matrix]")[0]
    arrays = """
matrix = [[0, 1, 0, 0], [-2, "-c", 1, 0], [0, 0, 0, 1], ["half/zeta", 0, "-(1 + 0)", "-half"]]
initial = ["gap + F", 0, 0, 0]
forcing = [
  0,
  { mean = "F/3", cos = [0, "F"], sin = [0.5] },
  0.0,
  { amplitudes = ["F"], phases = ["phase"], orders = [4] },
]
"""
    both = clearances.replace("h = { x = 1, y = -1 }", "h = [1, 0, -1, 0]")
    both = both.replace('g = { "x\'" = -1 }', "g = [0, -1, 0, 0]")
    return f"{head}{arrays}[parameters]{tables}[[clearance]]{both}"
