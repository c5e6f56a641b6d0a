"""What a report is built of: sections with paragraphs, tables, figures and notes, as plain data.

Every text is plain text, which is escaped when it is shown; the only markup that is shown as it is are drawn
figures.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias

from gearlash.system import GearlashError


@dataclass(frozen=True)
class Badge:
    """A verdict or status: a sign and a word, so that its meaning does not rest on colour alone.

    Parameters
    ----------
    text : str
    kind : {"good", "fair", "bad", "doubt", "plain"}
    """

    text: str
    kind: str = "plain"

    @property
    def sign(self) -> str:
        """What stands before the word."""
        return {"good": "✓", "fair": "≈", "bad": "✗", "doubt": "?"}.get(self.kind, "•")


@dataclass(frozen=True)
class Marked:
    """A number that rests on an assumed value; it is shown with †."""

    text: str


@dataclass(frozen=True)
class Strong:
    """Words set in bold."""

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
        """A paragraph of these parts, one after the other."""
        return Text(parts)


@dataclass(frozen=True)
class Bullets:
    """A list of paragraphs."""

    items: tuple[Text, ...]


@dataclass(frozen=True)
class Note:
    """A remark in a box of its own."""

    text: Text
    title: str = "Note"


Cell: TypeAlias = Inline | tuple[Inline, ...] | list[Inline | tuple[Inline, ...]]
"""What stands in a cell: one thing, several in one line (a tuple), or several lines (a list)."""


@dataclass(frozen=True)
class Table:
    """A numbered table.

    Parameters
    ----------
    id : str
        That a `Ref` mentions it by; one of a kind on the page.
    caption : str
    head : tuple of str
        Titles of the columns.
    rows : tuple of tuple
        Cells: one thing, several in one line (a tuple), or several lines (a list).
    numeric : frozenset of int
        Columns set flush right.
    widths : tuple of int
        Of the columns, in per cent; such a table takes the whole width of the page, in small type.
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
    """A numbered figure.

    Parameters
    ----------
    id : str
        That a `Ref` mentions it by; one of a kind on the page.
    caption : Text
    alternative : str
        Words for those who cannot see it.
    stem : str
        Of its files: that of a `Picture`.
    assumed : bool
        Whether one of its scales rests on an assumed value, which is then said below it.
    """

    id: str
    caption: Text
    alternative: str
    stem: str
    assumed: bool = False


Block: TypeAlias = Text | Bullets | Note | Table | Figure


@dataclass(frozen=True)
class Section:
    """A part of a page under a heading of its own.

    Parameters
    ----------
    id : str
        That a `Ref` mentions it by; one of a kind on the page.
    title : str
    blocks : tuple
        Paragraphs, lists, notes, tables and figures.
    sections : tuple of Section
        Parts inside it, after its own blocks.
    badge : Badge, optional
        A verdict beside the title.
    """

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
    """A whole report.

    Parameters
    ----------
    title, subtitle : str
    sections : tuple of Section
    footer : str
    language : str
        Of the texts, for browsers and screen readers.
    contents_printed : bool
        Whether the table of contents is printed, too.

    Attributes
    ----------
    names : dict of str to str
        What each figure, table and section is called ("Table 3"), by its id.

    Raises
    ------
    GearlashError
        Where two parts have one id.

    Examples
    --------
    >>> from gearlash.report import Page, Section, Table
    >>> table = Table("speeds", "Speeds.", ("rpm", "label"), (("3600", "1-0"),))
    >>> Page("Title", "", (Section("one", "First part", (table,)),)).names
    {'one': 'Section 1', 'speeds': 'Table 1'}
    """

    title: str
    subtitle: str
    sections: tuple[Section, ...]
    footer: str = ""
    language: str = "en"
    contents_printed: bool = True
    names: dict[str, str] = field(init=False, default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        self.names.update(_numbered(self.sections))


def _numbered(sections: tuple[Section, ...]) -> dict[str, str]:
    """What each figure, table and section is called. Raises `GearlashError` where an id is used twice."""
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
