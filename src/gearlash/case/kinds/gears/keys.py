"""Keys of a gear pair that code names."""

GEARS = ("pinion", "gear")
BODY = "model.body"
CONTACT = "model.contact"
PROJECTION = "model.projection"
REFERENCE = "model.reference_length"
EQUIVALENT_MASS = "mesh.equivalent_mass"
