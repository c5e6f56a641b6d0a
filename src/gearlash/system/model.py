"""What functions of a family take: the family itself, or what has one and knows its parameters by other names
and in units, too, as a case does."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol, runtime_checkable

from numpy.typing import ArrayLike

from . import given
from .family import Family
from .status import GearlashError


@runtime_checkable
class HasFamily(Protocol):
    """What has a family, and knows its parameters by other names and in units, too: a `Case`."""

    def family(self) -> tuple[Family, Any]:
        """The systems that this describes.

        Returns
        -------
        family : Family
            With the values of this description as defaults.
        scales : object
            Conversions between dimensionless and physical values.
        """
        ...

    def resolve(self, name: str, value: str | float) -> tuple[str, float]:
        """The parameter that a name and a value mean.

        Parameters
        ----------
        name : str
            Short name, or another one.
        value : str or float
            A text with its unit, or a number for what has no unit.

        Returns
        -------
        name : str
            Short name of the parameter.
        value : float
            Its dimensionless value.
        """
        ...

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, Any, str]]:
        """What values of a parameter mean physically.

        Parameters
        ----------
        short : str
            Short name of the parameter.
        value : array_like
            Dimensionless.

        Returns
        -------
        list of tuple
            Name, values and unit of each quantity.
        """
        ...


def family_of(model: Family | HasFamily) -> Family:
    """The family of a model. Raises `GearlashError` for what has none."""
    given.instance("model", model, (Family, HasFamily), "a case, as from gearlash.load_case, or a Family")
    return model if isinstance(model, Family) else model.family()[0]


def short_name(model: Family | HasFamily, family: Family, name: str) -> str:
    """The short name of a parameter, which may be called by a physical name. Raises `UnknownNameError` for
    what is none."""
    if isinstance(name, str) and name not in family.defaults and isinstance(model, HasFamily):
        for parameter in family.parameters:
            physical = model.physical(parameter.name, parameter.default)
            if any(name in (path, path.rpartition(".")[2]) for path, _, _ in physical):
                return parameter.name
    return given.known("parameter", name, family.defaults)


def plain_values(
    model: Family | HasFamily, family: Family, values: Mapping[str, float | str] | None
) -> dict[str, float]:
    """Values of parameters by short name, dimensionless. Raises `GearlashError` for names and values that do
    not fit, and for one quantity under two names."""
    found: dict[str, float] = {}
    names: dict[str, str] = {}
    for name, value in given.mapping("values", values).items():
        plain = name in family.defaults and not isinstance(value, str)
        if plain or not isinstance(model, HasFamily):
            short, number = given.known("parameter", name, family.defaults), given.number(name, value)
        else:
            short, number = plain_value(model, name, value)
        if short in names:
            raise GearlashError(f"values: {names[short]} and {name} name the same quantity")
        names[short], found[short] = name, number
    return found


def plain_value(model: HasFamily, name: str, value: object) -> tuple[str, float]:
    """Short name and dimensionless value of one parameter, named and stated as in a file."""
    return model.resolve(name, value if isinstance(value, str) else given.number(name, value))
