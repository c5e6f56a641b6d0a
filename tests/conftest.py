"""What every test process starts with."""

from __future__ import annotations

import os

from hypothesis import settings

os.environ.setdefault("MPLBACKEND", "Agg")

# Examples are drawn the same way in every run; none fails for being slow, as the first one compiles kernels.
settings.register_profile("gearlash", deadline=None, derandomize=True)
settings.load_profile("gearlash")
