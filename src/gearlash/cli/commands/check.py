"""gearlash check"""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearlash.cli.exits import ExitCode, command, delivery
from gearlash.cli.options import AsCsv, AsJson, CaseArgument, DecimalComma, Out, Settings

if TYPE_CHECKING:
    from gearlash.cli.tables import Tables


@command
def check(
    case: CaseArgument,
    settings: Settings = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """What does this case say? Every value with unit, provenance and reason, and what follows from it.

    Stated values, defaults, then derived numbers: equivalent mass, ω_n, D_c, natural frequencies, and the
    physical or dimensionless counterpart of everything. Remarks name stated values that conflict with what is
    known otherwise. A file with problems has all of them listed, and exit code 2. --out writes check.json
    and, of a gear pair whose teeth are known, a drawing of them in mesh as SVG and PDF.
    """
    from gearlash.cli.answers.check import check_answer
    from gearlash.cli.frame import show_answer
    from gearlash.cli.inputs import read_case
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    chosen = read_case(case, settings)
    answer = check_answer(chosen)

    def tables() -> Tables:
        from gearlash.cli.record_tables import check_tables

        return check_tables(answer)

    printed = csv.printing(tables)
    with delivery():
        if out is not None:
            from gearlash.cli.check_files import write_check

            write_check(out, chosen, answer, csv, tables)
        if printed is None:
            show_answer(answer, as_json)
        else:
            printed()
    return ExitCode.OK
