"""Words of the plain sentence."""

from __future__ import annotations

import pytest

from cli.conftest import Gearlash
from gearlash.cli.answers.sentence import coexisting, rate
from gearlash.results.beside import Beside, BesideMotion
from gearlash.system import Label, MotionKind, Signature, Status, read_label

RATES = {
    ((0.3,), 1): "once per mesh cycle",
    ((0.3, 0.7), 1): "twice per mesh cycle",
    (tuple(n + 0.1 * (n % 2) for n in range(6)), 6): "once per mesh cycle",
    ((0.95, 1.05), 2): "twice in 2 mesh cycles",
    ((0.0, 0.1, 0.2, 0.3), 2): "4 times in 2 mesh cycles",
    ((0.999, 1.0, 2.999, 3.0), 4): "4 times in 4 mesh cycles",
    ((0.3,), 6): "once in 6 mesh cycles",
    ((0.1, 0.2, 1.3), 2): "3 times in 2 mesh cycles",
    (tuple(n + 0.5 for n in range(150)), 200): "0.75 times per mesh cycle on average",
    (tuple(n + 0.5 for n in range(200)), 200): "about once per mesh cycle on average",
}


@pytest.mark.parametrize(("counts", "words"), RATES.items())
def test_rates(counts: tuple[tuple[float, ...], int], words: str):
    assert rate(*counts) == words


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        (
            ["omega=1.05"],
            "4010.97 rpm: 1-0, teeth stay in contact; this motion is impact-free from 3715 rpm to 4247 rpm, "
            "looked at in steps of 1 %; 11 other starts lead to the same motion",
        ),
        (
            ["omega=0.78", "D=0.384"],
            "2979.58 rpm: 6-6-1, teeth hit the drive side once per mesh cycle and the back side once in 6 "
            "mesh cycles; nearest impact-free motion found at 3715 rpm †; 12 other starts lead to the same "
            "motion",
        ),
    ],
)
def test_whole_sentences(settings: list[str], sentence: str, gearlash: Gearlash):
    options = [part for setting in settings for part in ("--set", setting)]
    assert gearlash("run", "article", *options, "--json").answer["sentence"] == sentence


def _label(text: str) -> Label:
    found = read_label(text)
    assert found is not None
    return found


def motion(label: str, starts: int, impacts: bool = True) -> BesideMotion:
    return BesideMotion(_label(label), Status.OK, starts, impacts, {})


@pytest.mark.parametrize(
    ("beside", "words"),
    [
        (None, "motions that may coexist were not looked for"),
        (Beside(5, 5, 0, ()), "5 other starts lead to the same motion"),
        (Beside(1, 1, 0, ()), "1 other start leads to the same motion"),
        (
            Beside(5, 3, 0, (motion("aperiodic", 2),)),
            "2 of 5 other starts lead to another motion: aperiodic",
        ),
        (
            Beside(5, 1, 1, (motion("2-1-0", 2), motion("1-0-0", 1, False))),
            "3 of 5 other starts lead to other motions: 2-1, 1-0, without impacts, 1 settled to nothing in "
            "the time given",
        ),
        (
            Beside(5, 4, 0, (motion("3-3-0", 1),)),
            "1 of 5 other starts leads to another motion: a different 3-3",
        ),
        (Beside(5, 3, 2, ()), "2 of 5 other starts settled to nothing in the time given"),
    ],
)
def test_what_coexists_is_told_or_said_not_to_be_known(beside: Beside | None, words: str):
    assert coexisting(beside, Signature(3, 3)) == words


def test_two_aperiodic_motions_are_not_said_to_be_one():
    assert (
        coexisting(Beside(6, 6, 0, ()), MotionKind.APERIODIC)
        == "6 other starts lead to aperiodic motion, too"
    )


def test_a_force_without_contact_is_explained_by_the_rule_of_contact(gearlash: Gearlash):
    told = "The contact damping acts in the gap too"
    hits = gearlash("run", "kahraman-singh", "--set", "omega=0.85", "--json").answer["numbers"]
    assert hits["share_without_contact"] > 0.0
    assert hits["contact"] == "always"
    there = ("run", "kahraman-singh", "--set", "omega=0.85")
    assert told in gearlash(*there).out
    assert told not in gearlash(*there, "--set", "contact=no-tension").out


def test_in_coast_the_force_on_the_back_side_is_no_pull_and_its_largest_value_is_the_largest(
    gearlash: Gearlash,
):
    """Teeth that press the back side all the time: what drive says, with the other sign."""
    told = "The contact damping acts in the gap too"
    said = {}
    for load in ("0.1", "-0.1"):
        asked = ("run", "kahraman-singh", "--set", f"load={load}", "--set", "omega=0.4")
        ran = gearlash(*asked)
        assert told not in ran.out
        rows = [row.split() for row in ran.out.splitlines() if "contact force, " in row]
        said[load] = {" ".join(row[2:-1]): float(row[-1]) for row in rows}
        assert gearlash(*asked, "--json").answer["numbers"]["share_without_contact"] == 0.0
    drive, coast = said.values()
    for name in ("largest (peak)", "least (peak)", "mean"):
        assert coast[name] == pytest.approx(-drive[name], rel=1e-4)
    assert abs(coast["largest (peak)"]) > abs(coast["mean"]) > abs(coast["least (peak)"])
