"""Every choice of a verification that no case makes, with its value: fixed before anything is computed."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from math import pi

from gearlash.multibody import Solver

CLOSES = 1e-4
"""What may be missing in the balance of energy, over what dampers take."""


@dataclass(frozen=True)
class Setting:
    """How one point of the multibody model is computed, and what is assumed for it.

    Attributes
    ----------
    name : str
        What sets it apart from the first.
    bearing_x : float
        Stiffness along the line of centres over that across it.
    bearings_as_stated : bool
        Whether bearings stay as stated where the inputs are held so that they would grow with the mesh.
    tilt : float
        Stiffness against tilt over that of two bearings as far apart as in the inputs.
    held : {"", "centre distance", "tilts", "centre-line", "lumped"}
        Directions that are held: none; the line of centres; all tilts; both of these; all but rotation.
    error, torque : float
        Over those of the inputs.
    error_turn : float
        Added to the phase of the error, rad.
    contact_damping, bearing_damping : float
        Over what matches ξ_m and ξ_b.
    flexible : bool
        Whether the gear's body bends.
    flexible_pinion : bool
        Whether the pinion's does, with the ends of its shaft.
    steps : int
        Of the integrator, a mesh cycle; a whole number of times as many where fast vibrations ask for them.
    divided : int
        Every step, as short as it then is, is divided by so many.
    finer : int
        So many times the steps in the cycles that are read, so that the balance of energy closes there.
    finest : int
        Up to so many times: twice as many, again and again, while the balance does not close to `CLOSES`.
    settle, read : int
        Mesh cycles before those that are read, and those.
    longest : int
        Up to so many times ``settle`` cycles, and those that were read in between, where a motion does not
        come back after one and the slowest vibration of bodies in their bearings and modes has not faded.
    solver : Solver
    """

    name: str = "as planned"
    bearing_x: float = 1.0
    bearings_as_stated: bool = False
    tilt: float = 1.0
    held: str = ""
    error: float = 1.0
    torque: float = 1.0
    error_turn: float = 0.0
    contact_damping: float = 1.0
    bearing_damping: float = 1.0
    flexible: bool = True
    flexible_pinion: bool = False
    steps: int = 192
    divided: int = 1
    finer: int = 3
    finest: int = 12
    settle: int = 80
    read: int = 20
    longest: int = 12
    solver: Solver = Solver.RK44

    def told(self) -> dict[str, str]:
        """Every choice as text, by name."""
        return {each.name: str(getattr(self, each.name)) for each in fields(self)}


PLANNED = Setting()


def sensitivity(planned: Setting = PLANNED) -> tuple[Setting, ...]:
    """The settings beside the planned one, each with one change.

    Parameters
    ----------
    planned : Setting

    Returns
    -------
    tuple of Setting
    """
    quarter = 0.5 * pi
    other_pinion = "rigid pinion" if planned.flexible_pinion else "flexible pinion"
    changes: tuple[tuple[str, dict[str, object]], ...] = (
        ("bearing x stiffness / 4", {"bearing_x": 0.25}),
        ("bearing x stiffness × 4", {"bearing_x": 4.0}),
        ("tilt stiffness / 4", {"tilt": 0.25}),
        ("tilt stiffness × 4", {"tilt": 4.0}),
        ("centre line and tilts held", {"held": "centre-line"}),
        ("error − 10 %", {"error": 0.9}),
        ("error + 10 %", {"error": 1.1}),
        ("torque − 10 %", {"torque": 0.9}),
        ("torque + 10 %", {"torque": 1.1}),
        ("error phase + 90°", {"error_turn": quarter}),
        ("error phase + 180°", {"error_turn": 2.0 * quarter}),
        ("error phase + 270°", {"error_turn": 3.0 * quarter}),
        ("contact damping / 2", {"contact_damping": 0.5}),
        ("contact damping × 2", {"contact_damping": 2.0}),
        ("bearing damping / 2", {"bearing_damping": 0.5}),
        ("bearing damping × 2", {"bearing_damping": 2.0}),
        (other_pinion, {"flexible_pinion": not planned.flexible_pinion}),
        ("step / 2", {"divided": 2 * planned.divided}),
        ("generalized-α", {"solver": Solver.GENERALIZED_ALPHA}),
    )
    return tuple(replace(planned, name=name, **change) for name, change in changes)  # pyright: ignore[reportArgumentType]
