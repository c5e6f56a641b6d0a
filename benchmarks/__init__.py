"""gearlash and its peers on the same work, in one run: times, ratios, errors, and what limits them.

Everybody takes turns (see `timing`), errors are against 80-bit Taylor integration where heyoka is installed,
and a peer that is missing is a row that says so. `run.benchmark` does all of it; what is exported here is its
result, which can be described without the engine.
"""

from .results import OWN, Bar, Benchmark, Curve, Limit, Machine, Row

__all__ = ["OWN", "Bar", "Benchmark", "Curve", "Limit", "Machine", "Row"]
