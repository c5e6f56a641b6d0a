"""A kind of case of one's own, written and registered here without touching any other file."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from collections.abc import Iterator, Mapping
from functools import partial
from math import sqrt
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from typer.testing import CliRunner

import gearlash as gl
from case.test_piecewise import plain
from cli.schema_check import problems
from gearlash.case import Case, CaseError, loads, schema
from gearlash.case.entries import Entry
from gearlash.case.kinds import Content, Kind, forget, kinds, register
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import LENGTH, NUMBER, SPEED
from gearlash.cli.answers.check import check_answer
from gearlash.cli.app import app
from gearlash.results import content_hash
from gearlash.system import ContactRule, GearlashError, UnknownNameError

GRAVITY = 9.81
PLACES = {
    place.path: place
    for place in (
        Quantity("thread.length", LENGTH, "mm", "250 mm", "length of the thread", 0, 100, True, key="length"),
        Quantity("thread.damping", NUMBER, "", "0.05", "damping ratio", 0, 1, bare=True, key="damping"),
        Quantity("drive.speed", SPEED, "rad/s", "5 rad/s", "of the support", 0, 1e4, True, key="omega"),
        Quantity("drive.stroke", LENGTH, "mm", "10 mm", "of the support", -1, 1, key="stroke"),
        Quantity("stop.gap", LENGTH, "mm", "20 mm", "to the stop", -1, 1, key="gap"),
        Quantity("stop.stiffness", NUMBER, "", "400", "over mass, 1/s²", 0, 1e9, bare=True, key="stiffness"),
        Choice("stop.contact", tuple(ContactRule), ContactRule.ALWAYS, "when the stop damps"),
    )
}


def build(contact: ContactRule, p: Mapping[str, float]) -> gl.System:
    """x″ + 2ζω₀ x′ + ω₀² x = ω₀² s cos(ωt) − Φ, ω₀² = g/l, with a stop at x = gap."""
    own = GRAVITY / p["length"]
    matrix = np.array([[0.0, 1.0], [-own, -2.0 * p["damping"] * sqrt(own)]])
    stop = gl.Clearance(
        h=np.array([1.0, 0.0]),
        g=np.array([0.0, -1.0]),
        gap_plus=p["gap"],
        gap_minus=1.0,
        stiffness_plus=np.array([p["stiffness"]]),
        stiffness_minus=np.array([0.0]),
        damping=0.0,
        contact=contact,
        name="stop",
    )
    forcing = np.array([[0.0, 0.0, 0.0], [0.0, own * p["stroke"], 0.0]])
    return gl.System(p["omega"], matrix, forcing, (stop,))


def at_rest(p: Mapping[str, float]) -> NDArray[np.float64]:
    return np.zeros(2)


class PendulumContent(Content):
    def family(self) -> gl.Family:
        contact = self.entries.get("stop.contact")
        rule = ContactRule.ALWAYS if contact is None else ContactRule(str(contact.value))
        parameters = tuple(
            gl.Parameter(place.key, self.entries[place.key].number, place.description)
            for place in PLACES.values()
            if isinstance(place, Quantity)
        )
        return gl.Family(parameters, ("x", "x'"), partial(build, rule), at_rest)


class Pendulum(Kind):
    name = "pendulum"
    places = PLACES

    def content(self, entries: Mapping[str, Entry], structure: Mapping[str, Any]) -> PendulumContent:
        return PendulumContent(self, entries, structure)


TEXT = """
kind = "pendulum"
name = "clock"

[thread]
length = "250 mm"
damping = { value = 0.05, provenance = "assumed", reason = "a guess" }

[drive]
speed = "6 rad/s"
stroke = "10 mm"

[stop]
gap = "20 mm"
stiffness = 400
"""


@pytest.fixture(autouse=True)
def registered() -> Iterator[None]:
    register(Pendulum())
    yield
    forget("pendulum")


def told(text: str, overrides: Mapping[str, object] | None = None) -> dict[str, Any]:
    with pytest.raises(CaseError) as caught:
        loads(text, overrides)
    return {p.path: p for p in caught.value.problems}


def test_a_file_becomes_a_family_and_an_orbit():
    case = loads(TEXT)
    assert (case.name, case.kind) == ("clock", "pendulum")
    family, scales = case.family()
    assert not scales.physical
    assert family.defaults == {
        "length": 0.25, "damping": 0.05, "omega": 6.0, "stroke": 0.01, "gap": 0.02, "stiffness": 400.0
    }  # fmt: skip
    free = gl.attractor(gl.propagators(family.system({"gap": 0.9})), family.start())
    assert isinstance(free, gl.Orbit)
    own = GRAVITY / 0.25  # amplitude of a driven linear oscillator
    exact = 0.01 * own / abs(own - 36.0 + 2j * 0.05 * sqrt(own) * 6.0)
    assert np.abs(free.trace.at(np.linspace(0.0, 1.0, 2001)).state[:, 0]).max() == pytest.approx(
        exact, rel=1e-5
    )
    hit = gl.attractor(gl.propagators(family.system()), family.start())
    assert isinstance(hit, gl.Orbit)
    assert hit.signature.short == "1-1"


def test_values_are_overridden_and_resolved_with_their_units():
    case = loads(TEXT, {"gap": "1.5 cm"})
    assert case.family()[0].defaults["gap"] == 0.015
    other = case.with_overrides({"thread.length": "1 m", "stop.contact": "in-contact"})
    assert other.family()[0].defaults["length"] == 1.0
    assert other.family()[0].system().clearances[0].contact is ContactRule.IN_CONTACT
    assert case.resolve("drive.speed", "60 rpm") == ("omega", pytest.approx(2.0 * np.pi))
    with pytest.raises(UnknownNameError, match="did you mean 'length'"):
        case.resolve("lenght", "1 m")
    with pytest.raises(CaseError, match="a length with its unit"):
        case.resolve("length", "1 kg")


def test_all_that_is_wrong_comes_at_once_with_the_nearest_name():
    text = TEXT.replace("stroke", "strok").replace('"20 mm"', '"20 kg"').replace('"clock"', "3")
    found = told(text, {"lenght": "1 m"})
    assert set(found) == {"name", "drive.strok", "stop.gap", "lenght"}
    assert found["drive.strok"].nearest == "drive.stroke"
    assert "a length with its unit" in found["stop.gap"].expected
    assert found["lenght"].nearest == "length"
    (missing,) = told(TEXT.replace('speed = "6 rad/s"\n', "")).values()
    assert (missing.path, missing.missing) == ("drive.speed", True)
    assert told(TEXT.replace('"pendulum"', '"pendlum"'))["kind"].nearest == "pendulum"


def test_json_gives_it_back_and_the_hash_sees_its_values():
    case = loads(TEXT)
    again = Case.from_json(case.to_json())
    assert again == case
    assert again.hash == case.hash == loads(TEXT.replace("a guess", "guessed")).hash
    assert loads(TEXT.replace("400", "401")).hash != case.hash


def test_check_shows_every_value_and_what_was_not_given():
    answer = check_answer(loads(TEXT))
    shown = {value.path: value for value in answer.values}
    assert (shown["thread.length"].value, shown["thread.length"].unit) == (250.0, "mm")
    assert (shown["thread.damping"].short, shown["thread.damping"].provenance) == ("damping", "assumed")
    assert answer.states == ("x", "x'")


def test_the_schema_has_a_variant_of_it_that_takes_its_files():
    whole = plain(schema())
    assert whole["discriminator"]["mapping"]["pendulum"] == "#/$defs/pendulum"
    variant = whole["$defs"]["pendulum"]
    assert problems(tomllib.loads(TEXT), variant, whole) == []
    assert problems(tomllib.loads(TEXT.replace("stroke", "strok")), variant, whole)


def test_a_command_runs_it_in_words_that_are_true_of_it(tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    path = tmp_path / "clock.toml"
    path.write_text(TEXT, encoding="utf-8")
    ran = CliRunner().invoke(app, ["run", str(path), "--json", "--set", "gap=15 mm"])
    assert ran.exit_code == 0, ran.stderr
    sentence = json.loads(ran.stdout)["sentence"]
    assert "stop met on side + once per cycle" in sentence
    assert "teeth" not in sentence
    still = CliRunner().invoke(app, ["run", str(path), "--json", "--set", "stroke=0 mm"])
    assert "nothing in it varies with time" in json.loads(still.stdout)["sentence"]


AXIS = gl.Axis.even("omega", 5.0, 7.0, 5)


def test_two_workers_give_the_same_bytes():
    case = loads(TEXT)
    alone = gl.sweep(case, AXIS)
    assert {point.label for point in alone.points} >= {"1-1-0"}
    with gl.open_workers(case, 2) as workers:
        together = gl.sweep(case, AXIS, execution=gl.Execution(workers, chunk=2))
    one, other = (content_hash(gl.sweep_dataset(case, [sweep])) for sweep in (alone, together))
    assert one == other


def test_workers_that_cannot_get_the_kind_refuse_it_in_words():
    class Hidden(Pendulum):
        name = "hidden"

    register(Hidden())
    try:
        case = loads(TEXT.replace('"pendulum"', '"hidden"'))
        with pytest.raises(GearlashError, match="this kind of case cannot be sent to worker processes"):
            gl.open_workers(case, 2)
    finally:
        forget("hidden")


def test_a_process_that_does_not_know_the_kind_refuses_its_json_in_words():
    code = "import sys; from gearlash.case import Case; Case.from_json(sys.stdin.read())"
    ran = subprocess.run(
        [sys.executable, "-c", code], input=loads(TEXT).to_json(), capture_output=True, text=True, check=False
    )
    assert ran.returncode == 1
    assert "UnknownNameError: unknown kind of case 'pendulum'" in ran.stderr


def test_names_of_kinds_are_taken_once():
    class Other(Pendulum):
        pass

    register(Pendulum())  # the same again
    with pytest.raises(GearlashError, match="a Kind of gearlash"):
        register("pendulum")  # pyright: ignore[reportArgumentType]
    for taken in (Other, type("Spur", (Pendulum,), {"name": "spur-1dof"})):
        with pytest.raises(GearlashError, match="already"):
            register(taken())
    assert kinds() == ("helical-pair", "spur-1dof", "piecewise-linear", "pendulum")
    with pytest.raises(UnknownNameError):
        forget("spur-1dof")
