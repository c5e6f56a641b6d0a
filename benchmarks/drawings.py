"""Random drawings of gear pairs, as options of `gearlash new`: the same ones for the same seed.

Module 0.5 to 20 mm, 12 to 200 teeth, spur and helix up to 35°, ratios 1 to 8, steel, iron, bronze and
plastics, loaded lightly to heavily, slow to fast; some state profile shifts, a class and bores."""

from __future__ import annotations

import random
from dataclasses import dataclass
from math import cos, pi, radians

MODULES = 0.5, 0.8, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 16.0, 20.0  # mm
METALS = "steel", "steel", "grey-cast-iron", "nodular-cast-iron", "tin-bronze"
PLASTICS = "POM", "PA66", "PA66-GF30", "PEEK"
MOST_TEETH = 200


@dataclass(frozen=True)
class RandomDrawing:
    """Numbers of a drawing: module, widths and bores in mm, helix in degrees, speed in rpm, torque in N·m."""

    seed: int
    teeth: tuple[int, int]
    module: float
    helix_angle: float
    face_width: float
    materials: tuple[str, str]
    speed: float
    torque: float
    shifts: tuple[float, float] | None
    quality: int | None
    bores: tuple[float, float] | None

    @property
    def options(self) -> list[str]:
        """Of `gearlash new FILE`."""
        found = ["--teeth", "{}/{}".format(*self.teeth), "--module", f"{self.module}mm"]
        found += ["--face-width", f"{self.face_width:.1f}mm", "--material", "/".join(self.materials)]
        found += ["--speed", f"{self.speed:.1f}rpm", "--torque", f"{self.torque:.4g}N*m"]
        if self.helix_angle:
            found += ["--helix-angle", f"{self.helix_angle:.1f}deg"]
        if self.shifts is not None:
            found += ["--profile-shift", "{:.2f}/{:.2f}".format(*self.shifts)]
        if self.quality is not None:
            found += ["--quality", str(self.quality)]
        if self.bores is not None:
            found += ["--bore", "{:.3g}mm/{:.3g}mm".format(*self.bores)]
        return found

    def __str__(self) -> str:
        teeth, materials = "{}/{}".format(*self.teeth), "/".join(dict.fromkeys(self.materials))
        pair = f"{teeth}, m {self.module:g}, {self.helix_angle:.0f}°, b {self.face_width:.0f}, {materials}"
        return f"{pair}, {self.speed:.0f} rpm, {self.torque:.3g} N·m"


def random_drawing(seed: int) -> RandomDrawing:
    """The drawing of a seed."""
    draw = random.Random(f"drawing {seed}")
    ratio, module = draw.uniform(1.0, 8.0), draw.choice(MODULES)
    first = draw.randint(12, int(MOST_TEETH / ratio))
    teeth = first, round(first * ratio)
    helix = round(draw.choice([0.0, 0.0, draw.uniform(5.0, 35.0)]), 1)
    width = module * draw.uniform(6.0, 18.0)
    materials = draw.choice(METALS + PLASTICS), draw.choice(METALS + PLASTICS)
    soft = any(one in PLASTICS for one in materials)
    diameter = module * first / cos(radians(helix))
    load = (
        draw.uniform(1.0, 10.0) * module / 3.0 if soft else draw.uniform(5.0, 400.0) * max(module, 1.0) / 3.0
    )
    return RandomDrawing(
        seed, teeth, module, helix, width, materials,
        speed=draw.uniform(0.5, 15.0) / (pi * diameter * 1e-3) * 60.0,
        torque=load * width * diameter / 2.0 * 1e-3,
        shifts=(draw.uniform(0.0, 0.5), draw.uniform(-0.2, 0.3)) if draw.random() < 0.5 else None,
        quality=draw.randint(4, 11) if draw.random() < 0.5 else None,
        bores=(0.3 * diameter, 0.2 * diameter * ratio) if draw.random() < 0.5 else None,
    )  # fmt: skip
