"""Tables of a command as CSV: on standard output, or in the folder of --out."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gearlash.case import CaseError, Problem

if TYPE_CHECKING:
    from gearlash.results.columns import Column, CsvStyle

    from .folder import OutFolder

Tables = Mapping[str, "Sequence[Column]"]
"""By the name of their files, without ending; the first one is that of standard output."""
ENDING = ".csv"


@dataclass(frozen=True)
class CsvAsked:
    """What --csv and --decimal-comma say.

    Parameters
    ----------
    wanted : bool
    commas : bool
        Semicolons and decimal commas.
    printed : bool
        On standard output, as there is no folder.
    """

    wanted: bool
    commas: bool
    printed: bool

    @staticmethod
    def read(as_csv: bool, decimal_comma: bool, as_json: bool, out: Path | None) -> CsvAsked:
        """Raises `CaseError` where two tables would share standard output."""
        wanted = as_csv or decimal_comma
        if wanted and as_json and out is None:
            expected = "one of --json and --csv on standard output, or --out for the files of --csv"
            raise CaseError("--csv", [Problem("--csv", None, expected)])
        return CsvAsked(wanted, decimal_comma, wanted and out is None)

    @property
    def style(self) -> CsvStyle:
        """Signs of the files."""
        from gearlash.results.columns import COMMAS, POINTS

        return COMMAS if self.commas else POINTS

    def files(self, *names: str) -> list[str]:
        """Files of tables that may be written; without --csv those of before are removed, if they are
        there."""
        return [name + ENDING for name in names] if self.wanted else []

    def text(self, table: Sequence[Column]) -> str:
        """A table as CSV."""
        from gearlash.results.columns import csv_text

        return csv_text(table, self.style)

    def content(self, table: Sequence[Column]) -> bytes:
        """A table as the content of a file."""
        from gearlash.results.columns import csv_bytes

        return csv_bytes(table, self.style)

    def bytes_of(self, tables: Tables) -> dict[str, bytes]:
        """Contents by the names of files."""
        return {name + ENDING: self.content(table) for name, table in tables.items()}

    def keep(self, folder: OutFolder, names: Iterable[str], tables: Callable[[], Tables]) -> None:
        """Writes tables into the folder, in place of those of before, of which there may be more."""
        from gearlash.results.store import write_together

        made = self.bytes_of(tables()) if self.wanted else {}
        gone = [name + ENDING for name in names if name + ENDING not in made]
        contents = {folder.file(name): content for name, content in made.items()}
        write_together(contents, instead_of=[folder.file(name) for name in gone if folder.owns(name)])

    def printing(self, tables: Callable[[], Tables]) -> Callable[[], None] | None:
        """What prints the first table and nothing else, where that was asked for."""
        return (lambda: self._print(tables())) if self.printed else None

    def _print(self, tables: Tables) -> None:
        from .interrupt import showing
        from .jsonio import PART

        written = self.text(next(iter(tables.values()), []))
        with showing() as taken:
            for i in range(0, len(written), PART):
                sys.stdout.write(written[i : i + PART])
                sys.stdout.flush()
                taken()


def table_of(records: Sequence[Any], kind: type[Any]) -> list[Column]:
    """A row a record of a ``kind`` of an answer: its fields, those of records in it behind their names, and
    numbers in physical units with these; lists of records are left out."""
    from gearlash.results.columns import Column

    rows = [dict(_cells(record, "")) for record in records]
    heads = list(dict.fromkeys(head for row in rows for head in row))
    heads = heads or [(field.name, "") for field in fields(kind)]
    parts = {name for name, _ in heads if any(other.startswith(f"{name}_") for other, _ in heads)}
    empty = {head for head in heads if head[0] in parts and all(row.get(head) is None for row in rows)}
    heads = [head for head in heads if head not in empty]  # records that are there in other rows only
    return [Column(name, [row.get((name, unit)) for row in rows], unit) for name, unit in heads]


def _cells(record: Any, before: str) -> Iterable[tuple[tuple[str, str], Any]]:
    """Name, unit and value of every cell."""
    for field in fields(record):
        value, name = getattr(record, field.name), before + field.name
        if isinstance(value, Mapping):
            yield from (
                ((f"{name}_{str(key).replace(chr(39), '_rate')}", ""), _plain(item))
                for key, item in value.items()
                if _scalar(item)
            )
        elif _scalar(value):
            yield (name, ""), _plain(value)
        elif is_dataclass(value):
            yield from _cells(value, f"{name}_")
        elif isinstance(value, Sequence) and value:
            yield from _several(value, name, before)


def _several(values: Sequence[Any], name: str, before: str) -> Iterable[tuple[tuple[str, str], Any]]:
    from .answers.parts import PhysicalValue

    if all(isinstance(each, PhysicalValue) for each in values):
        leaf = name.removesuffix("physical")
        yield from (((leaf + each.name, each.unit), each.value) for each in values)
    elif all(isinstance(each, str) for each in values):
        yield (name, ""), " ".join(map(str, values))
    elif all(_scalar(each) for each in values) and len(values) <= 3:
        yield from (((f"{name}_{i}", ""), _plain(each)) for i, each in enumerate(values, 1))


def _scalar(value: Any) -> bool:
    from gearlash.system import Signature

    return value is None or isinstance(value, str | int | float | bool | Enum | Signature)


def _plain(value: Any) -> Any:
    return value if value is None or isinstance(value, bool | int | float) else str(value)
