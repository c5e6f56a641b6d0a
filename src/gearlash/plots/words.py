"""What parameters are called in figures: those of a gear pair in words of gears, those of any other system by
their own names, however they are spelt."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import xarray as xr

from gearlash.case.kinds import is_between_teeth

from .units import Units, literal


@dataclass(frozen=True)
class Words:
    """Axis labels and symbols by short name; a parameter that has none is called by that."""

    names: Mapping[str, str]
    symbols: Mapping[str, str]

    def name(self, parameter: str) -> str:
        """Axis label: words and symbol; all are numbers of one unless the label says rad."""
        return self.names.get(parameter, literal(parameter.replace("_", " ")))

    def symbol(self, parameter: str) -> str:
        """For a heading."""
        return drawn(self.symbols[parameter]) if parameter in self.symbols else literal(parameter)


def drawn(text: str) -> str:
    """A text in which symbols of gears, as f_m, are set with their index below."""
    return re.sub(r"\b(f|ξ)_(m|b)\b", r"$\1_\2$", literal(text))


GEARS = Words(
    {
        "omega": r"mesh frequency  $\omega$",
        "D": r"half-backlash  $D$",
        "load": r"load  $f_m$",
        "ripple": r"stiffness ripple  $\varepsilon_1$",
        "ripple_phase": r"ripple phase  $\varphi_1$  [rad]",
        "error": r"transmission error  $E_1$",
        "error_phase": r"error phase  $\psi_1$  [rad]",
        "mesh_damping": r"mesh damping  $\xi_m$",
        "bearing_damping": r"bearing damping  $\xi_b$",
    },
    {"omega": "ω", "D": "D", "load": "f_m", "ripple": "ε₁", "error": "E₁", "error_phase": "ψ₁"}
    | {"ripple_2": "ε₂", "bearing_damping": "ξ_b", "mesh_damping": "ξ_m"},
)
ANY = Words({"omega": r"frequency  $\omega$"}, {"omega": "ω"})


def words(dataset: xr.Dataset | None, units: Units | None) -> Words:
    """Of gears, where the dataset is of a case whose first clearance is between teeth, or ``units`` are."""
    kind = "" if dataset is None else str(dataset.attrs.get("case_kind", ""))
    teeth = is_between_teeth(kind) or (units is not None and units.teeth)
    return GEARS if teeth else ANY
