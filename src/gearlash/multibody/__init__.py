"""An independent model of a gear pair: bodies in space, true flanks, compliance from finite elements.

It exists to be compared with the lumped model, and so knows nothing of it: of `gears` it takes geometry,
materials and bodies. It needs the extra `multibody` (Exudyn and scikit-fem), imported only where it is used.
"""

from .extra import MissingExtraError, require_extra

__all__ = ["MissingExtraError", "require_extra"]
