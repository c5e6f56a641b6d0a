"""When what was fixed: the run was not strictly blind."""

from __future__ import annotations

from gearlash.report.blocks import Bullets, Text

FIXED = (
    (
        "Before anything was computed",
        "flanks, masses, bearings across and along the shafts, torque, error, backlash and damping of the "
        "case; the inputs “stiffness”, “dimensionless” and “absolute”; both speeds; bearings along the line "
        "of centres as stiff as across it, 150 mm between the bearings of a shaft; the settings of bearings, "
        "centre line, phase of the error, damping, step and solver; the notation P-Q-R and its 1 % (how a "
        "motion is read for it was changed later, see below)",
    ),
    (
        "After motions with a rigid gear had been seen",
        "a gear that bends as the planned one; the grid of the window (17 speeds from 0.82 to 1.14 in place "
        "of 29 from 0.80 to 1.15; 128 steps for 160, 30 cycles to settle for 40); 192 steps a mesh cycle for "
        "256; 60 cycles to settle for 80 and 20 read for 24; the setting with the centre distance held; "
        "modified flanks, found by a search for stiffness and harmonics, not for a motion",
    ),
    (
        "After motions with a gear that bends had been seen",
        "finer places on the flanks where compliance is computed",
    ),
    (
        "After the findings of a second reader",
        "that contact which does not repeat counts as the reported 1-0 (before the label alone counted); "
        "bearings that grow with the mesh in “dimensionless” (before they stayed as stated, which now is a "
        "setting beside); modified flanks as stiff as the case says and run at its speeds; the settings "
        "beside with the inputs “absolute”; a pinion that bends; 80 mesh cycles in place of 60 before a "
        "motion is read, and three times the steps while it is; the error that relief makes, for the lumped "
        "model",
    ),
    (
        "After the findings of a third reader",
        "torque, bearings and speeds of “dimensionless” from the stiffness under its own torque; every "
        "setting with each of the inputs that are not modified; error and torque changed by a tenth; up to "
        "2304 steps where the balance of energy needs them",
    ),
    (
        "After the findings of a referee",
        "mesh cycles compared by the mean force of every 1/64 of them (before by the force at 64 places, "
        "with which, in the last data so compared, by the label alone no inputs agreed); more cycles to "
        "settle where a motion does not come back after one and the slowest vibration of bodies has not "
        "faded yet; a label only where every period has as many impacts, and 1-0-0 only where contact was "
        "never lost (before, they were rounded in the mean: with mean forces 1.3 impacts a mesh cycle were "
        "told as one, and “modified” as 1-1-0 at 3600 rpm, in runs whose data are not kept)",
    ),
)


def when_fixed() -> Bullets:
    """What was fixed before what was seen."""
    return Bullets(tuple(Text.of(f"{when}, these were fixed: {what}.") for when, what in FIXED))
