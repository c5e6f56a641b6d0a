"""Labels of motions are data, and are text in files only; advice is told beside a message, not in it."""

from __future__ import annotations

import pickle
import re
from pathlib import Path

import pytest

import gearlash as gl
from gearlash.results import Axis, Direction, Sweep
from gearlash.results.point import blank
from gearlash.system import MotionKind, Signature, Status, label_text, read_label

SOURCES = {path: path.read_text(encoding="utf-8") for path in (Path(gl.__file__).parent).rglob("*.py")}


@pytest.mark.parametrize("text", ["1-1-0", "6-6-1", "3-2-0/1-1", "aperiodic", "neutral", "none"])
def test_a_label_is_equal_to_its_text(text: str):
    label = read_label(text)
    assert label == text
    assert hash(label) == hash(text)
    assert {label: 1}[text] == 1  # pyright: ignore[reportArgumentType]
    assert str(label) == repr(label) == f"{label}" == label_text(label) == text
    assert pickle.loads(pickle.dumps(label)) == label


def test_signatures_are_compared_by_their_counts():
    assert Signature(1, 1) == Signature(1, 1, 0)
    assert Signature(1, 1) != Signature(1, 1, 0, ((0, 0),))
    assert Signature(1, 1) != "1-1"
    assert f"{Signature(1, 1):>8}" == "   1-1-0"


def test_no_motion_has_no_label():
    assert read_label("") is read_label(None) is None
    assert label_text(None) == ""
    for wrong in ("1-", "chaos", "1-1-0-0"):
        with pytest.raises(gl.GearlashError):
            read_label(wrong)


def test_points_hold_labels_and_statuses_whatever_they_are_made_of():
    text: dict = {"status": "ok", "label": "2-1-0"}
    points = (gl.Point(1.0, message="", **text), blank(2.0, Status.FAILED, "no system"))
    assert points[0].label == Signature(2, 1)
    assert isinstance(points[0].label, Signature)
    assert points[0].status is Status.OK
    assert points[1].label is None
    assert not points[1].computed
    sweep = Sweep(Axis.even("omega", 1.0, 2.0, 2), Direction.COLD, points)
    assert sweep.runs() == [(0, 0, Signature(2, 1)), (1, 1, Status.FAILED)]
    assert sweep.shares == {Signature(2, 1): 1}
    assert MotionKind.APERIODIC not in sweep.shares


def test_no_program_text_reads_meaning_back_out_of_a_label_or_takes_advice_off_a_message():
    """Texts become labels where files are read, and where the article's own printed labels are."""
    parsing = {path.name for path, text in SOURCES.items() if re.search(r"Signature\.parse\(", text)}
    assert parsing <= {"label.py", "signature.py", "branch_file.py", "curve_file.py", "judge.py"}
    splitting = {path.name for path, text in SOURCES.items() if '.split("-")' in text}
    assert splitting <= {"signature.py"}
    assert not [path for path, text in SOURCES.items() if re.search(r"removesuffix\(.*advice", text)]


@pytest.mark.parametrize("name", ["class Touch", "class Zone", "class Mark", "class Motion", "def plain"])
def test_a_name_is_one_thing(name: str):
    found = [path for path, text in SOURCES.items() if re.search(rf"^{name}\b", text, re.MULTILINE)]
    assert len(found) <= 1
