"""What is known of a pair of gears from its drawing, and what an estimate is."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos

from .cylindrical_pair import CylindricalPair
from .flank_modification import PairModification
from .gear_body import GearBody
from .materials import Material, named
from .mesh_stiffness import Rim

LEAST_LINE_LOAD = 1e3
"""N/m: with less the formulas for the stiffness of teeth would end at none."""
USUAL_GRADE = 8
"""Of ISO 1328-1, where none is stated."""
GRADE_SPREAD = 2
"""Classes finer or coarser that a class may be which nobody stated."""
COARSEST = 12
USUAL_LINE_LOAD = 100e3
"""N/m: where none is stated; the stiffness of teeth depends on it little."""


@dataclass(frozen=True)
class Estimate:
    """A value with its range and origin.

    Parameters
    ----------
    value, least, greatest : float
        In SI units.
    source : str
        Standard or publication, and what was assumed.
    """

    value: float
    least: float
    greatest: float
    source: str


@dataclass(frozen=True)
class Drawing:
    """What is known of a pair of gears.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width. Allowances of its gears count as stated backlash.
    materials : (Material, Material), optional
        Of pinion and gear; steel where nothing is given.
    bodies : (GearBody or None, GearBody or None)
        ``None``: a solid disc without a bore.
    rims : (Rim or None, Rim or None)
        ``None``: not known.
    grades : (int, int), optional
        Flank tolerance classes; class 8, with 6 to 10 as the range, where nothing is given.
    fits : (str, str), optional
        Of DIN 3967, of pinion and gear.
    distance_grade : int or None
        js of the centre distance; None where its deviation is stated.
    torque : float, optional
        Of the pinion, N·m.
    modification : PairModification
        What the flanks lack on purpose.
    at_work : CylindricalPair, optional
        The pair at the centre distance at work; contact, stiffness and error are those of it.
    stated_stiffness : float, optional
        Mean stiffness where it is stated and not to be estimated, N/m.
    assumed_grades : (bool, bool)
        Which of the grades nobody stated: those may be `GRADE_SPREAD` classes finer or coarser.
    shafts : (float or None, float or None)
        Diameters of the shafts in their bearings, m; those of the bores where None.
    spans : (float or None, float or None)
        Distance of the two bearings of a shaft, m; an estimate where None.
    stated_bending : (bool, bool)
        Whether the lateral stiffness of a shaft is stated beside that of its bearings.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.estimates import Drawing, estimates
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> found = estimates(Drawing(pair, torque=150.0))
    >>> round(found["mean_stiffness"].value / 1e8, 2), round(found["backlash"].value * 1e6)
    (4.09, 149)
    """

    pair: CylindricalPair
    materials: tuple[Material, Material] | None = None
    bodies: tuple[GearBody | None, GearBody | None] = (None, None)
    rims: tuple[Rim | None, Rim | None] = (None, None)
    grades: tuple[int, int] | None = None
    fits: tuple[str, str] | None = None
    distance_grade: int | None = 7
    torque: float | None = None
    modification: PairModification = field(default_factory=PairModification)
    at_work: CylindricalPair | None = None
    stated_stiffness: float | None = None
    assumed_grades: tuple[bool, bool] = (False, False)
    shafts: tuple[float | None, float | None] = (None, None)
    spans: tuple[float | None, float | None] = (None, None)
    stated_bending: tuple[bool, bool] = (False, False)

    @property
    def meshing(self) -> CylindricalPair:
        """The pair as it meshes: at work where that is known."""
        return self.pair if self.at_work is None else self.at_work

    @property
    def chosen_materials(self) -> tuple[Material, Material]:
        """Materials, steel where nothing is given."""
        return (named("steel"), named("steel")) if self.materials is None else self.materials

    def grades_apart(self, classes: int) -> tuple[int, int]:
        """Flank tolerance classes with those that nobody stated so many coarser (below 0: finer).

        Parameters
        ----------
        classes : int

        Returns
        -------
        (int, int)
            Of pinion and gear, from 1 to `COARSEST`.
        """
        stated = self.grades or (USUAL_GRADE, USUAL_GRADE)
        assumed = self.assumed_grades if self.grades else (True, True)
        first, second = (
            min(max(grade + classes * open_, 1), COARSEST)
            for grade, open_ in zip(stated, assumed, strict=True)
        )
        return first, second

    @property
    def line_load(self) -> float | None:
        """F_t/b on the reference circle of the pinion, N/m; at least `LEAST_LINE_LOAD`."""
        if self.torque is None or self.pair.face_width == 0.0:
            return None
        load = 2.0 * abs(self.torque) / self.pair.pinion.reference_diameter / self.pair.face_width
        return max(load, LEAST_LINE_LOAD)

    @property
    def normal_force(self) -> float:
        """Of this line load, or of a usual one, N."""
        pinion = self.pair.pinion
        tangential = (self.line_load or USUAL_LINE_LOAD) * (self.pair.face_width or pinion.normal_module)
        return tangential * pinion.reference_diameter / pinion.base_diameter / cos(pinion.base_helix_angle)
