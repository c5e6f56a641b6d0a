"""`gearlash verify` with coarse finite elements and short motions, for tests: also as a program of its own.

What it finds is not settled; that it is found, told and kept is what these tests are about.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import gearlash.multibody.compliance as fem
import gearlash.studies.verification as study
from gearlash.multibody.compliance import SectorSettings
from gearlash.multibody.tooth_section import Fineness

COARSE = SectorSettings(Fineness(flank=2, fillet=1, core=1, rim=1, axial=2), teeth=3)
SHORT = study.Setting(steps=64, finer=1, finest=1, settle=2, read=16, longest=1)
HELD = replace(SHORT, name=study.DISTANCE_HELD.name, held=study.DISTANCE_HELD.held)
compliances, plan = fem.pair_compliances, study.planned


def shorten(patch: Any) -> None:
    """``patch(owner, name, value)`` puts the short parts in place."""
    patch(fem, "pair_compliances", partial(compliances, settings=COARSE, keep=False))
    patch(study, "planned", short_plan)


def short_plan(*asked: Any, **named: Any) -> study.Plan:
    """The plan that is asked for, of short motions."""
    found = plan(*asked, **named)
    short = replace(SHORT, flexible_pinion=found.planned.flexible_pinion)
    return replace(found, planned=short, everywhere=(HELD,), window=replace(SHORT, name="window"))


if __name__ == "__main__":
    import signal

    signal.signal(signal.SIGINT, signal.default_int_handler)  # who started the tests may have ignored it
    shorten(setattr)
    from gearlash.cli import main

    main()
