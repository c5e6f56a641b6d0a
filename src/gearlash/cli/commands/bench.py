"""gearlash bench"""

from __future__ import annotations

from typing import Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import AsJson, Out


@command
def bench(
    quick: Annotated[
        bool,
        typer.Option(
            "--quick", help="Everything once through on small work, half a minute; the times mean little."
        ),
    ] = False,
    as_json: AsJson = False,
    out: Out = None,
) -> ExitCode:
    """How fast is it here, and how exact? gearlash and other solvers on the same work, taking turns.

    Times, ratios and errors against 80-bit integration, cost against size, the limit of this core, start-up.
    Solvers that are not installed are shown as such. Takes about two minutes, on a machine that does nothing
    else. --out writes bench.json, the page benchmarks.md and its figure.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.jsonio import write_file, write_stdout, write_text
    from gearlash.cli.notice import load_engine
    from gearlash.cli.terminal import show

    folder = claim_if(out, ["bench.json", "benchmarks.md", "images"])
    load_engine()

    from gearlash.bench.run import benchmark
    from gearlash.cli.answers.bench import bench_answer
    from gearlash.cli.progress import stage_bar

    with stage_bar() as progress:
        found = benchmark(quick, lambda stage: progress(stage, None))
    answer = bench_answer(found)
    if folder:
        from gearlash import plots
        from gearlash.bench.page import FIGURE, page

        write_file(answer, folder.file("bench.json"))
        picture = folder.file(FIGURE)
        picture.parent.mkdir(exist_ok=True)
        plots.save(plots.cost(found.curves), picture.with_suffix(""), ("png",), dpi=200.0)
        write_text(page(found), folder.file("benchmarks.md"))
    if as_json:
        write_stdout(answer)
    else:
        from gearlash.cli.show.bench import bench_view

        show(bench_view, answer)
    return ExitCode.OK
