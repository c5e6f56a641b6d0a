"""One row a point: how a dataset lies in a file, so that tables can be made of it.

In memory a dataset has arrays of one number a point beside arrays of several. A table of all of them would
have a row for every combination of those numbers. So in the file the root group has what is one number (or
text) a point, and every further dimension a group of its own, of its name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr

POINTWISE = "label"  # every dataset has it, and it has one a point


def split(dataset: xr.Dataset) -> dict[str, xr.Dataset]:
    """Groups by their path: "/" and one for every dimension beyond those of a point."""
    if POINTWISE not in dataset:
        return {"/": dataset}
    own = set(dataset[POINTWISE].dims)
    others = [dim for dim in dataset.dims if dim not in own]
    found = {"/": dataset.drop_dims(others)}
    for dim in others:
        names = [name for name, variable in dataset.data_vars.items() if dim in variable.dims]
        group = dataset[names] if names else dataset[[dim]]
        group.attrs = {}
        found[f"/{dim}"] = group.drop_vars([n for n in group.coords if n not in group.dims])
    return found


def join(groups: dict[str, xr.Dataset]) -> xr.Dataset:
    """The dataset that was split."""
    root = groups["/"]
    found = root.copy()
    for group in groups.values():
        if group is not root:
            found = found.assign_coords(group.coords).assign(group.data_vars)
    return found
