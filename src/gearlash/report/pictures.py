"""Figures of a report as tasks: what to draw with what, in this process or in others."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from gearlash import plots
from gearlash.results.store import write_whole


@dataclass(frozen=True)
class Picture:
    """A figure that is still to be drawn.

    Parameters
    ----------
    stem : str
        Its files are ``stem.svg`` and ``stem.pdf``.
    draw : callable
        A function that worker processes can import.
    arguments, options
        ``draw(*arguments, **options)`` makes the figure.
    """

    stem: str
    draw: Callable[..., Figure]
    arguments: tuple[Any, ...]
    options: dict[str, Any] = field(default_factory=dict)


def drawn(picture: Picture) -> dict[str, bytes]:
    """The figure in every form (a task for a worker)."""
    figure = picture.draw(*picture.arguments, **picture.options)
    return {form: plots.to_bytes(figure, form) for form in ("svg", "pdf")}


def write(pictures: Sequence[Picture], folder: Path, executor: Executor | None) -> dict[str, bytes]:
    """Draws all, writes every form into ``folder``, and returns the SVG files by stem."""
    folder.mkdir(parents=True, exist_ok=True)
    files = map(drawn, pictures) if executor is None else executor.map(drawn, pictures)
    vector = {}
    for picture, forms in zip(pictures, files, strict=True):
        for form, content in forms.items():
            write_whole(folder / f"{picture.stem}.{form}", content)
        vector[picture.stem] = forms["svg"]
    return vector
