"""What a report is built of: sections with paragraphs, tables, figures and notes. Plain data; templates
show it.

Every text in here is plain text and is escaped when it is shown; the only markup taken as such is a drawn
figure.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

from gearlash.system import GearlashError


@dataclass(frozen=True)
class Badge:
    """A verdict or status: a sign and a word, so that it is not told by colour alone.

    ``kind`` is ``good``, ``fair``, ``bad``, ``doubt`` or ``plain``.
    """

    text: str
    kind: str = "plain"

    @property
    def sign(self) -> str:
        return {"good": "✓", "fair": "≈", "bad": "✗", "doubt": "?"}.get(self.kind, "•")


@dataclass(frozen=True)
class Marked:
    """A number that rests on an assumed value."""

    text: str


@dataclass(frozen=True)
class Strong:
    """Words to be seen first."""

    text: str


@dataclass(frozen=True)
class Ref:
    """A mention of a figure, table or section by its id; printed as "Figure 3"."""

    id: str


Inline: TypeAlias = str | Badge | Marked | Strong | Ref


@dataclass(frozen=True)
class Text:
    """A paragraph."""

    parts: tuple[Inline, ...]

    @staticmethod
    def of(*parts: Inline) -> Text:
        return Text(parts)


@dataclass(frozen=True)
class Bullets:
    """A list of paragraphs."""

    items: tuple[Text, ...]


@dataclass(frozen=True)
class Note:
    """A remark set apart."""

    text: Text
    title: str = "Note"


Cell: TypeAlias = Inline | tuple[Inline, ...] | list[Inline | tuple[Inline, ...]]
"""One thing, several in a row, or several lines (a list)."""


@dataclass(frozen=True)
class Table:
    """A numbered table.

    ``numeric`` are the columns set flush right. One with ``widths`` (per cent) takes the whole width in
    small type.
    """

    id: str
    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    numeric: frozenset[int] = frozenset()
    widths: tuple[int, ...] = ()

    @property
    def headed(self) -> bool:
        """Do its columns have titles?"""
        return any(self.head)


@dataclass(frozen=True)
class Figure:
    """A numbered figure: ``stem`` of its files, caption, and words for those who cannot see it.

    ``assumed``: one of its scales rests on an assumed value.
    """

    id: str
    caption: Text
    alternative: str
    stem: str
    assumed: bool = False


Block: TypeAlias = Text | Bullets | Note | Table | Figure


@dataclass(frozen=True)
class Section:
    """A heading with what belongs under it."""

    id: str
    title: str
    blocks: tuple[Block, ...]
    sections: tuple[Section, ...] = ()
    badge: Badge | None = None

    def walk(self) -> Iterator[Section]:
        """This section and those inside it, in the order they are read."""
        yield self
        for section in self.sections:
            yield from section.walk()


@dataclass(frozen=True)
class Page:
    """A whole report."""

    title: str
    subtitle: str
    sections: tuple[Section, ...]
    footer: str = ""
    language: str = "en"
    names: dict[str, str] = field(init=False, default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        self.names.update(_numbered(self.sections))


def _numbered(sections: tuple[Section, ...]) -> dict[str, str]:
    """How each figure, table and section is called. Raises `ValueError` where an id is used twice."""
    names: dict[str, str] = {}
    counts = {"Figure": 0, "Table": 0}

    def add(identifier: str, name: str) -> None:
        if identifier in names:
            raise GearlashError(f"two parts of a report have the id {identifier!r}")
        names[identifier] = name

    for i, top in enumerate(sections, start=1):
        for j, section in enumerate(top.walk()):
            add(section.id, f"Section {i}" if j == 0 else f"Section {i}.{j}")
            for block in section.blocks:
                if isinstance(block, Figure | Table):
                    kind = type(block).__name__
                    counts[kind] += 1
                    add(block.id, f"{kind} {counts[kind]}")
    return names
