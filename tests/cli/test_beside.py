"""What coexists with the motion that a run finds, as far as a few other starts show."""

from __future__ import annotations

from pathlib import Path

import gearlash as gl
from cli.conftest import Gearlash

DRIVE = str(Path(__file__).resolve().parents[1] / "cases" / "drive.toml")


def test_a_pair_that_may_rattle_is_not_called_quiet(gearlash: Gearlash):
    """At 6800 rpm the contact that never opens has an aperiodic motion beside it, as a sweep down finds."""
    ran = gearlash("run", DRIVE, "--set", "pinion_speed=6800rpm", "--json")
    answer = ran.answer
    assert answer["label"] == "1-0-0"
    (other,) = answer["beside"]["others"]
    assert (other["label"], other["impacts"]) == ("aperiodic", True)
    assert other["starts"] + answer["beside"]["same"] == answer["beside"]["starts"]
    assert "this motion is impact-free from 4115 rpm" in answer["sentence"]
    assert "other starts lead to another motion: aperiodic" in answer["sentence"]


def test_the_start_that_is_named_leads_there(gearlash: Gearlash):
    answer = gearlash("run", DRIVE, "--set", "pinion_speed=6800rpm", "--json").answer
    start = answer["beside"]["others"][0]["start"]
    case = gl.load_case(DRIVE, {"pinion_speed": "6800 rpm"})
    family, _ = case.family()
    assert list(start) == list(family.states)
    assert gl.attractor(family.system(), list(start.values())).label == "aperiodic"


def test_each_of_two_coexisting_orbits_tells_of_the_other(gearlash: Gearlash):
    here = ("run", "kahraman-singh", "--set", "omega=0.79", "--json")
    free = gearlash(*here).answer
    labels = {m["label"] for m in free["beside"]["others"]}
    assert (free["label"], labels) == ("1-0-0", {"1-1-0"})
    start = free["beside"]["others"][0]["start"]
    initial = [part for name, value in start.items() for part in ("--initial", f"{name}={value!r}")]
    hit = gearlash(*here, *initial).answer
    assert hit["label"] == "1-1-0"
    assert {m["label"] for m in hit["beside"]["others"]} == {"1-0-0"}
    assert "an impact-free motion exists at this speed too" in hit["sentence"]


def test_orbits_of_one_label_are_told_apart(gearlash: Gearlash):
    """Between the grazing at 0.8206 and the fold at 0.8285 there are two motions 1-1-0."""
    sets = ("mesh_damping=0.05", "load=0.1", "error=0.05", "omega=0.825")
    options = [part for text in sets for part in ("--set", text)]
    answer = gearlash("run", "kahraman-singh", *options, "--json").answer
    (other,) = answer["beside"]["others"]
    assert answer["label"] == other["label"] == "1-1-0"
    assert "leads to another motion: a different 1-1" in answer["sentence"]
