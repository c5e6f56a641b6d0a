"""gearlash check"""

from __future__ import annotations

from gearlash.cli.exits import ExitCode, command, delivery
from gearlash.cli.options import AsJson, CaseArgument, Settings


@command
def check(case: CaseArgument, settings: Settings = None, as_json: AsJson = False) -> ExitCode:
    """What does this case say? Every value with unit, provenance and reason, and what follows from it.

    Stated values, defaults, then derived numbers: equivalent mass, ω_n, D_c, natural frequencies, and the
    physical or dimensionless counterpart of everything. Remarks name stated values that conflict with what is
    known otherwise. A file with problems has all of them listed, and exit code 2.
    """
    from gearlash.cli.answers.check import check_answer
    from gearlash.cli.frame import show_answer
    from gearlash.cli.inputs import read_case

    answer = check_answer(read_case(case, settings))
    with delivery():
        show_answer(answer, as_json)
    return ExitCode.OK
