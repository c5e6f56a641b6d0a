"""The names of the article's room, which are imported when they are first used."""

from __future__ import annotations

import inspect
import subprocess
import sys

import pytest

from gearlash import article


@pytest.mark.parametrize("name", article.__all__)
def test_every_public_name_is_there(name: str):
    value = getattr(article, name)
    assert value is not None
    assert not inspect.ismodule(value), "a function, not the module that holds it"


def test_the_lists_agree():
    assert sorted(name for names in article._WHERE.values() for name in names) == sorted(article.__all__)


def test_an_unknown_name_is_named():
    with pytest.raises(AttributeError, match="nothing_of_it"):
        _ = article.nothing_of_it


def test_the_types_of_table_2_load_no_study():
    """`gearlash graze` asks for them alone."""
    code = (
        "import sys\nfrom gearlash.article import table2_type\n"
        "print(sorted({'gearlash.studies', 'gearlash.plots', 'gearlash.jobs'} & sys.modules.keys()))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
