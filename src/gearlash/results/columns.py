"""Tables as named columns with units, and the one writer of them as CSV."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray as xr

PLACES = ("time", "mesh_cycle", "tau", "order")
"""Columns of histories and spectra that say where a row stands."""
ASCII_UNITS = str.maketrans({"µ": "u", "·": "*", "°": "deg", "²": "^2", "₀": "0"})


@dataclass(frozen=True)
class CsvStyle:
    """Signs of a CSV file.

    Parameters
    ----------
    separator, decimal : str
        What parts columns, and the sign of decimals.
    marked : bool
        Whether files begin with the mark of UTF-8.
    """

    separator: str = ","
    decimal: str = "."
    marked: bool = False


POINTS = CsvStyle()
COMMAS = CsvStyle(";", ",", marked=True)
"""As spreadsheets expect it where decimals have commas; without the mark Excel does not see UTF-8."""


@dataclass(frozen=True, eq=False)
class Column:
    """One column.

    Parameters
    ----------
    name : str
        A word that MATLAB and pandas take as a name.
    values : sequence
        Numbers, texts, truth values; None and NaN are empty cells.
    unit : str
        Empty for a number without one.
    description : str
    """

    name: str
    values: Sequence[Any] | NDArray[Any]
    unit: str = ""
    description: str = ""

    @property
    def head(self) -> str:
        """As it stands in the first line: ``force [N]``, in ASCII."""
        return f"{self.name} [{self.ascii_unit}]" if self.unit else self.name

    @property
    def ascii_unit(self) -> str:
        """The unit in ASCII: ``um``, ``N*m``."""
        return self.unit.translate(ASCII_UNITS)


Table = Sequence[Column]


def csv_text(table: Table, style: CsvStyle = POINTS) -> str:
    """A table as CSV: names with units in the first line, every number to its last digit, truth values as 1
    and 0, an empty cell where there is no number."""
    out = StringIO()
    writer = csv.writer(out, delimiter=style.separator, lineterminator="\n")
    writer.writerow([column.head for column in table])
    cells = [[_cell(value, style.decimal) for value in _plain(column.values)] for column in table]
    writer.writerows(zip(*cells, strict=True))
    return out.getvalue()


def csv_bytes(table: Table, style: CsvStyle = POINTS) -> bytes:
    """A table as the content of a file, in UTF-8."""
    return csv_text(table, style).encode("utf-8-sig" if style.marked else "utf-8")


def _plain(values: Sequence[Any] | NDArray[Any]) -> Iterable[Any]:
    return values.tolist() if isinstance(values, np.ndarray) else values


def _cell(value: Any, decimal: str) -> str:
    if value is None:
        return ""
    if isinstance(value, bool | np.bool_):
        return str(int(value))
    if isinstance(value, float | np.floating):
        number = float(value)
        return repr(number).replace(".", decimal) if isfinite(number) else ""
    return str(value)


def table_of_dataset(dataset: xr.Dataset) -> list[Column]:
    """Columns of a dataset of sweeps, a map, a branch or a curve: a row a point, with what stands in a
    physical unit as a further column."""
    from .table import table

    frame = table(dataset).reset_index()
    found: list[Column] = []
    for name in map(str, frame.columns):
        about: Mapping[str, Any] = dataset[name].attrs if name in dataset.variables else {}
        found += columns_of(name, frame[name].to_numpy(), about)
    return found


def columns_of(name: str, values: NDArray[Any], about: Mapping[str, Any]) -> list[Column]:
    """The columns of a variable with these attributes: one, and another in its physical unit where it has a
    factor of that."""
    told = str(about.get("long_name", ""))
    unit = str(about.get("units", ""))
    found = [Column(name, values, "" if unit == "1" else unit, told)]
    if "physical_factor" in about:
        physical = values * float(about["physical_factor"])
        found.append(Column(name, physical, str(about["physical_units"]), told))
    return found


def dataset_of_table(table: Table, dim: str, about: Mapping[str, object]) -> xr.Dataset:
    """A table as a dataset with one dimension; units are attributes, and columns that say when or at which
    order are coordinates."""
    import xarray as xr

    data = {
        column.name: (
            (dim,), np.asarray(column.values),
            {"units": column.ascii_unit or "1", "long_name": column.description},
        )
        for column in table
    }  # fmt: skip
    return xr.Dataset(data, attrs=dict(about)).set_coords([name for name in PLACES if name in data])
