"""Independent ways to the same numbers. Nothing here shares code or method with ``gearlash.flow``."""
