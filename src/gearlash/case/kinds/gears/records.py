"""What is computed of a gear pair: its body, its numbers, and single numbers that follow."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeAlias

from gearlash.case.scales import Scales
from gearlash.gears import CylindricalGear, CylindricalPair, HelicalPair, LineOfAction, ToothGeometry
from gearlash.gears.basic_rack import ISO53_A
from gearlash.gears.excitation import Excitation
from gearlash.gears.mesh_stiffness import Rim
from gearlash.system import ContactRule

Both: TypeAlias = tuple[float, float]
"""Of pinion and gear."""


@dataclass(frozen=True)
class Body:
    """The physical pair behind the numbers; what a case does not know is None. The ``teeth`` are known where
    something was estimated from them; ``meshing`` are the same at the centre distance at work, ``rims`` those
    of their bodies."""

    geometry: ToothGeometry | None
    line: LineOfAction | None
    inertias: Both | None
    face_width: float | None
    teeth: CylindricalPair | None = None
    meshing: CylindricalPair | None = None
    rims: tuple[Rim | None, Rim | None] = (None, None)

    @property
    def drawn(self) -> CylindricalPair | None:
        """The pair to be drawn: its teeth, or standard ones where no more than their module is known."""
        plain = self.geometry
        if self.teeth is not None or plain is None:
            return self.teeth
        rack = replace(ISO53_A, pressure_angle=plain.pressure_angle, addendum=plain.addendum)
        gears = [CylindricalGear(z, plain.normal_module, plain.helix_angle, rack=rack) for z in plain.teeth]
        return CylindricalPair(gears[0], gears[1], face_width=self.face_width or 0.0)


@dataclass(frozen=True)
class Numbers:
    """Family parameters by short name, the fixed numbers of a helical pair, contact rule, scales, body, and
    the curves and run-out that excite the mesh; what the backlash has more at work than at 20 °C and nominal
    centre distance, m."""

    parameters: dict[str, float]
    pair: HelicalPair | None
    contact: ContactRule
    scales: Scales
    body: Body
    excitation: Excitation
    play_added: float = 0.0


@dataclass(frozen=True)
class Derived:
    """A number computed from others: ``inputs`` are keys or paths of what went into it."""

    path: str
    value: float
    unit: str
    formula: str
    inputs: tuple[str, ...]
    description: str = ""
    short: str | None = None
