"""What the commands share: the inputs of a study before it begins, and the delivery of an answer.

A command reads its inputs, makes its answer, and delivers it. Imports stand inside the functions: what a
command does not use, it does not load.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from .exits import ExitCode, code_of, delivery

if TYPE_CHECKING:
    from pathlib import Path

    from gearlash.case import Case
    from gearlash.orbits import Settings
    from gearlash.results import Axis
    from gearlash.system import Family

    from .folder import OutFolder
    from .inputs import Over


@dataclass(frozen=True, eq=False)
class StudyInputs:
    """What a study of many points is asked: the case with what was set, its family, the axes as typed, and
    the state to start from by name (None: the cold start)."""

    typed_case: str
    case: Case
    family: Family
    axes: tuple[Over, ...]
    named_start: dict[str, float] | None

    @staticmethod
    def read(
        case: str,
        settings: list[str] | None,
        initial: list[str] | None,
        over: Sequence[str],
        read_axes: Callable[[Case], tuple[Over, ...]],
    ) -> StudyInputs:
        """Reads the case, in which what ``over`` names varies, the axes and then the start. Raises
        `CaseError` for what cannot be used."""
        from .inputs import read_case, read_start

        chosen = read_case(case, settings, over)
        axes = read_axes(chosen)
        family, _ = chosen.family()
        start = read_start(family, family.complete(), initial) if initial else None
        return StudyInputs(case, chosen, family, axes, start)

    @property
    def parameters(self) -> dict[str, float]:
        """Every parameter of the case by short name."""
        return self.family.complete()

    @property
    def start(self) -> list[float] | None:
        """The state to start from; None: the cold start."""
        return None if self.named_start is None else list(self.named_start.values())

    def made_ready(self, out: Path | None, files: Sequence[str]) -> OutFolder | None:
        """The folder of --out with places for these ``files``; then the kernels are there, a slow
        system is told, and what comes is worth keeping."""
        from .folder import claim_if
        from .interrupt import expect_results
        from .notice import load_engine
        from .slow import ends, tell_if_slow

        folder = claim_if(out, files)
        load_engine(data=folder is not None)
        tell_if_slow(self.family, *ends(*self.axes))
        expect_results()
        return folder

    def ranges(self) -> tuple[Axis, ...]:
        """The axes with their values."""
        from gearlash.results import Axis

        return tuple(Axis(axis.short, axis.values) for axis in self.axes)

    def search(self, periods: int | None, max_period: int | None) -> Settings:
        """How far the search for each attractor goes."""
        from .settings import search_settings

        return search_settings(self.family, periods, max_period, self.typed_case)


def deliver(
    answer: Any,
    as_json: bool,
    folder: OutFolder | None = None,
    keep: Callable[[OutFolder], object] | None = None,
    printed: Callable[[], object] | None = None,
) -> ExitCode:
    """Lets a command ``keep`` its answer in the folder of --out, if there is one, without an answer to the
    same question that is worth more. Shows it: as JSON, by the view of its command, or as what is ``printed``
    in place of that. Returns the exit code of its status."""
    with delivery():
        try:
            if folder is not None and keep is not None:
                from .worth import keep_answer

                keep_answer(folder, answer, partial(keep, folder))
        finally:  # an answer that took long is shown even if it cannot be kept
            if printed is None:
                show_answer(answer, as_json)
            else:
                printed()
    return code_of(answer.status)


def show_answer(answer: Any, as_json: bool) -> None:
    """Prints an answer: as JSON, or by the view of its command (``show/<command>.py``)."""
    if as_json:
        from .jsonio import write_stdout

        write_stdout(answer)
        return
    from importlib import import_module

    from .terminal import show

    view = getattr(import_module(f"gearlash.cli.show.{answer.result}"), f"{answer.result}_view")
    show(view, answer)
