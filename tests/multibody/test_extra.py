"""Without the packages of the extra, the error says how to install them."""

from __future__ import annotations

import sys

import pytest

from gearlash.multibody import MissingExtraError, require_extra


@pytest.mark.parametrize("package", ["exudyn", "skfem"])
def test_a_missing_package_is_named_with_the_way_to_install_it(package: str, monkeypatch: pytest.MonkeyPatch):
    require_extra()
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(MissingExtraError, match=rf"{package}.*gearlash\[multibody\]"):
        require_extra()
