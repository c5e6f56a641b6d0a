"""Where numbers come from: case, versions, what was assumed."""

from __future__ import annotations

import json
import platform
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version

import numpy as np

from gearlash.case import Case
from gearlash.system import Family


def provenance(model: Case | Family) -> dict[str, str]:
    """Texts to keep beside a result: case as JSON, its hash and name, every value that was not given (JSON
    list), and the versions that computed. A family of one's own has its parameters instead of a case.
    """
    own = {
        "gearlash_version": package_version(),
        "numpy_version": np.__version__,
        "numba_version": version("numba"),
        "python_version": platform.python_version(),
    }
    if isinstance(model, Family):
        return own | {"case_name": "", "family_defaults": json.dumps(model.defaults)}
    return own | {
        "case_name": model.name,
        "case_kind": model.kind,
        "case_hash": model.hash,
        "case_json": model.to_json(),
        "not_given": json.dumps(not_given(model), ensure_ascii=False),
    }


def held_along(model: Case | Family, names: Iterable[str]) -> dict[str, str]:
    """An attribute ``held`` that says what is taken to be the same wherever these parameters vary, although
    it may not be; none where there is nothing to say."""
    if isinstance(model, Family):
        return {}
    told = dict.fromkeys(filter(None, map(model.held, names)))
    return {"held": "; ".join(told)} if told else {}


def not_given(case: Case) -> list[dict[str, object]]:
    """Every stated value and default that is inferred, assumed or calibrated, with its reason."""
    return [
        {
            "path": v.path,
            "value": v.value,
            "unit": v.unit,
            "provenance": str(v.provenance),
            "reason": v.reason,
        }
        for v in case.values()
        if v.provenance not in ("given", "derived")
    ]


def package_version() -> str:
    """Of gearlash; "unknown" where it runs without having been installed."""
    try:
        return version("gearlash")
    except PackageNotFoundError:
        return "unknown"
