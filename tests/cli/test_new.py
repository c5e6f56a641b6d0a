"""`gearlash new`: from a drawing to a file that every command takes."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.case import CaseError, Problem, load
from gearlash.cli import questions
from gearlash.cli.words_of_drawing import WORDS, is_helical, placed
from gearlash.system import GearlashError

HELICAL = (
    "--teeth", "25/57", "--module", "3 mm", "--helix-angle", "15 deg", "--face-width", "40 mm",
    "--backlash", "80 um", "--speed", "4200 rpm", "--torque", "150 N m",
)  # fmt: skip


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)


def test_options_become_a_file_that_says_what_was_stated(gearlash: Gearlash):
    ran = gearlash("new", "pair.toml", *HELICAL, "--bore", "/50mm", "--material", "steel/POM", "--json")
    assert ran.code == 0
    answer = ran.answer
    assert answer["kind"] == "helical-pair"
    assert not answer["example"]
    tables = tomllib.loads(Path("pair.toml").read_text(encoding="utf-8"))
    assert tables["pinion"] == {
        "teeth": 25,
        "face_width": "40 mm",
        "material": "steel",
    }
    assert tables["gear"]["bore"] == "50mm"
    assert tables["gear"]["material"] == "POM"
    estimated = {value["path"]: value for value in answer["estimated"]}
    assert {"mesh.mean_stiffness", "mesh.error", "pinion.mass", "gear.bearing_stiffness_z"} <= set(estimated)
    for value in estimated.values():
        assert value["least"] <= value["value"] <= value["greatest"]
        assert value["provenance"] == "assumed"
        assert value["reason"]
    assert gearlash("check", "pair.toml").code == 0


def test_a_spur_pair_by_power_and_the_speed_of_the_gear(gearlash: Gearlash):
    ran = gearlash(
        "new", "spur.toml", "--teeth", "23/47", "--module", "3mm", "--gear-speed", "3000rpm",
        "--power", "50kW", "--centre-distance", "106mm",
    )  # fmt: skip
    assert ran.code == 0
    case = load("spur.toml")
    assert case.kind == "spur-1dof"
    values = case.family()[0].defaults
    assert case.scales.pinion_rpm(values["omega"]) == pytest.approx(3000 * 47 / 23)
    assert case.scales.torque(values["load"]) == pytest.approx(
        50e3 / (3000 * 47 / 23 * 3.141592653589793 / 30)
    )
    assert "assumed" in ran.out


def test_nothing_stated_is_a_template_that_is_no_case_before_it_is_edited(gearlash: Gearlash):
    ran = gearlash("new", "pair.toml")
    assert ran.code == 0
    assert "with the values of an example as comments; nothing is stated yet" in " ".join(ran.out.split())
    assert "gearlash report pair.toml" in ran.out
    text = Path("pair.toml").read_text(encoding="utf-8")
    assert "A template: nothing is stated yet." in text
    for word in WORDS:
        for path in word.paths:
            assert path.partition(".")[2] in text, path
    for name in ("report", "run", "check"):
        refused = gearlash(name, "pair.toml")
        assert refused.code == 2, name
        assert "pinion.teeth is missing" in refused.err
    edited = [line.removeprefix("# ") if "# example: " in line else line for line in text.splitlines()]
    Path("pair.toml").write_text("\n".join(edited), encoding="utf-8")
    case = load("pair.toml")
    assert case.scales.pinion_rpm(case.family()[0].defaults["omega"]) == pytest.approx(4200.0)


SMALL = (
    "--teeth", "18/41", "--module", "0.5mm", "--face-width", "5mm/4mm", "--gear-speed", "100rpm",
    "--torque", "0.2Nm",
)  # fmt: skip
LARGE = (
    "--teeth", "17/103", "--module", "20mm", "--helix-angle", "-12deg", "--face-width", "300mm",
    "--profile-shift", "0.4/-0.1", "--quality", "6/8", "--speed", "60rpm", "--torque", "40kNm",
)  # fmt: skip
HIGH = (
    "--teeth", "40/60", "--module", "2mm", "--face-width", "20mm", "--addendum", "1.3", "--dedendum", "1.5",
    "--bore", "20mm/30mm", "--backlash", "40um", "--speed", "6000rpm", "--power", "5kW",
)  # fmt: skip
ORIGINS = (
    ", as computed", ", as estimated", ", as assumed", ", as its rack has", ", from the list",
    ", for example", ", by default",
)  # fmt: skip
IN_PLACE_OF = "one of two that name the same quantity"
BESIDE = (
    "the other end of the range",
    "the amount that belongs to",
    "the amplitude that",
    "torque it was found at",
)


@pytest.mark.parametrize("pair", [HELICAL, SMALL, LARGE, HIGH], ids=["helical", "small", "large", "high"])
def test_every_comment_fits_this_pair(pair: tuple[str, ...], gearlash: Gearlash):
    """Taken in alone, each line is read: an example is a size that a pair of this size may have."""
    assert gearlash("new", "pair.toml", *pair).code == 0
    text = Path("pair.toml").read_text(encoding="utf-8")
    alone = [line for line in text.splitlines() if line.startswith("# ") and " = " in line]
    assert len(alone) > 60
    taken = 0
    for line in alone:
        assert line.endswith(ORIGINS), line
        Path("one.toml").write_text(text.replace(line, line.removeprefix("# "), 1), encoding="utf-8")
        try:
            load("one.toml")
            taken += 1
        except CaseError as error:
            for problem in error.problems:
                assert problem.expected.startswith(IN_PLACE_OF) or any(
                    each in problem.expected for each in BESIDE
                ), (line, problem)
    assert taken > 40


@pytest.mark.parametrize("pair", [HELICAL, SMALL, LARGE, HIGH], ids=["helical", "small", "large", "high"])
def test_what_is_computed_changes_nothing_when_it_is_taken_in(pair: tuple[str, ...], gearlash: Gearlash):
    """Words of teeth that say what holds already leave the teeth as they are."""
    gearlash("new", "pair.toml", *pair)
    text = Path("pair.toml").read_text(encoding="utf-8")
    before = load("pair.toml").numbers.body.teeth
    assert before is not None
    for leaf in ("centre_distance", "tip_diameter", "root_diameter", "tooth_thickness", "over_balls", "span"):
        stated = text
        for line in text.splitlines():
            if line.startswith((f"# {leaf} = ", f"# {leaf}_teeth = ", "# ball_diameter = ")):
                stated = stated.replace(line, line.removeprefix("# "), 1)
        Path("one.toml").write_text(stated, encoding="utf-8")
        after = load("one.toml").numbers.body.teeth
        assert after is not None
        for one, other in zip(before.gears, after.gears, strict=True):
            assert other.tip_diameter == pytest.approx(one.tip_diameter, rel=1e-5)
            assert other.normal_thickness() == pytest.approx(one.normal_thickness(), rel=2e-4)


def test_comments_say_where_values_are_from(gearlash: Gearlash):
    gearlash("new", "pair.toml", *HELICAL, "--material", "/POM", "--density", "/1420kg/m^3")
    told = {}
    table = ""
    for line in Path("pair.toml").read_text(encoding="utf-8").splitlines():
        table = line.strip("[]") if line.startswith("[") else table
        if line.startswith("# ") and " = " in line:
            told[f"{table}.{line.split()[1]}"] = line
    for path, end in (
        ("pinion.youngs_modulus", "of steel, from the list"),
        ("gear.youngs_modulus", "of POM, from the list"),
        ("gear.addendum", "as its rack has"),
        ("pinion.quality", "as assumed"),
        ("pinion.ball_diameter", "as assumed"),
        ("mesh.pressure_angle", "as assumed"),
        ("mesh.mean_stiffness", "as estimated"),
        ("mesh.centre_distance", "as computed"),
    ):
        assert told[path].endswith(f", {end}"), told[path]
    assert "gear.density" not in told


def test_a_larger_gear_that_drives_is_entered_as_the_pinion(gearlash: Gearlash):
    """The pair is the same one: its stiffness, and its critical speeds in turns of either gear."""
    gearlash("new", "one.toml", *HELICAL)
    turned = [*HELICAL]
    turned[1], turned[11], turned[13] = "57/25", f"{4200 * 25 / 57} rpm", "342 N m"
    assert gearlash("new", "other.toml", *turned).code == 0
    one, other = ({v.path: v.value for v in load(f"{name}.toml").values()} for name in ("one", "other"))
    assert other["mesh.mean_stiffness"] == pytest.approx(one["mesh.mean_stiffness"], rel=1e-12)
    assert other["derived.transmitted_force"] == pytest.approx(one["derived.transmitted_force"], rel=1e-12)
    for n in range(1, 6):
        path = f"derived.critical_speed_{n}"
        assert float(other[path]) * 57 / 25 == pytest.approx(float(one[path]), rel=1e-9)


def test_every_problem_is_told_at_once_and_nothing_is_written(gearlash: Gearlash):
    ran = gearlash("new", "pair.toml", "--teeth", "25/5x", "--module", "3", "--material", "stel/POM")
    assert ran.code == 2
    for part in (
        "--speed is missing", "--torque is missing", "--gear-torque or --power", "gear.teeth = '5x'",
        "mesh.normal_module = '3': expected a length with its unit", "did you mean 'steel'?",
    ):  # fmt: skip
        assert part in ran.complaint
    assert not Path("pair.toml").exists()
    assert gearlash("new", "pair.toml", *HELICAL, "--centre-distance", "90mm").code == 2
    assert not Path("pair.toml").exists()


def test_it_writes_over_nothing_without_being_told(gearlash: Gearlash):
    Path("pair.toml").write_text("mine", encoding="utf-8")
    ran = gearlash("new", "pair.toml", *HELICAL)
    assert ran.code == 2
    assert "is there already" in ran.complaint
    assert Path("pair.toml").read_text(encoding="utf-8") == "mine"
    assert gearlash("new", "pair.toml", *HELICAL, "--overwrite").code == 0
    assert load("pair.toml").kind == "helical-pair"
    Path("link.toml").symlink_to("pair.toml")
    Path("folder").mkdir()
    for name, said in (("article", "comes with the package"), ("link.toml", "link"), ("folder", "folder"),
                       ("none/pair.toml", "no folder")):  # fmt: skip
        ran = gearlash("new", name, *HELICAL, "--overwrite")
        assert (ran.code, said in ran.complaint) == (2, True), name


def test_strokes_between_two_values_and_in_units():
    assert placed({"bearing_y": "4e8 N/m / 3e8 N/m"}) == {
        "pinion.bearing_stiffness_y": "4e8 N/m",
        "gear.bearing_stiffness_y": "3e8 N/m",
    }
    assert placed({"bearing_y": "4e8N/m"})["gear.bearing_stiffness_y"] == "4e8N/m"
    assert placed({"material": "steel/POM"}) == {"pinion.material": "steel", "gear.material": "POM"}
    assert placed({"material": "PA66-GF30/grey-cast-iron"})["pinion.material"] == "PA66-GF30"
    assert placed({"profile_shift": "0.3/-0.1"})["gear.profile_shift"] == "-0.1"
    assert placed({"bore": "/50mm"}) == {"gear.bore": "50mm"}
    assert placed({"bore": "30mm/"}) == {"pinion.bore": "30mm"}
    both = {"pinion.face_width": "34 mm", "gear.face_width": "32mm"}
    assert placed({"face_width": "34/32mm"}) == both  # one unit behind both
    assert placed({"bore": "28mm/45"})["gear.bore"] == "45 mm"
    assert placed({"face_width": '1 1/2"/1.25"'}) == {
        "pinion.face_width": '1 1/2"',
        "gear.face_width": '1.25"',
    }
    assert placed({"bore": "ø45/ø70 mm"}) == {"pinion.bore": "ø45 mm", "gear.bore": "ø70 mm"}
    assert placed({"teeth": "20/30/80"}) == {"pinion.teeth": "20", "gear.teeth": "30/80"}
    assert placed({"inertia": "0.001kg*m^2/0.03kg*m^2"})["pinion.inertia"] == "0.001kg*m^2"
    assert is_helical({"mesh.helix_angle": "15°"})
    assert not is_helical({"mesh.helix_angle": "0 deg"})


EITHER_WAY = {
    '3/4in': "write 0.75in or 3 in/4in",
    '1/2"': 'write 0.5" or 1 in/2"',
    "ø1/2 in": "write 0.5 in or 1 in/2 in",
    "3/4 lb": "write 0.75 lb or 3 lb/4 lb",
    "1/2 mil": "write 0.5 mil or",
    "3/2in": "write 1.5in or 3 in/2in",
    "3/4/8in": "write 3 in/0.5in or 0.75 in/8in",
}  # fmt: skip


@pytest.mark.parametrize("text", EITHER_WAY)
def test_a_stroke_that_may_be_in_a_fraction_or_between_gears_is_refused(text: str, gearlash: Gearlash):
    with pytest.raises(GearlashError, match="--bore") as refused:
        placed({"bore": text})
    assert EITHER_WAY[text] in str(refused.value)
    ran = gearlash("new", "pair.toml", *HELICAL, "--bore", text)
    assert (ran.code, Path("pair.toml").exists()) == (2, False)


@pytest.mark.parametrize(
    ("text", "pinion", "gear"),
    [
        ("1/2in/", "1/2in", None),
        ("/3/4in", None, "3/4in"),
        ("1/2in/3/4in", "1/2in", "3/4in"),
        ("1/2/3/4in", "1/2 in", "3/4in"),
        ("3/4 in / 1 in", "3/4 in", "1 in"),
        ("1in/3/4in", "1in", "3/4in"),
        ("½in/¾in", "½in", "¾in"),
        ("½/¾in", "½ in", "¾in"),
        ("34/32mm", "34 mm", "32mm"),
        ("3/7in", "3 in", "7in"),
    ],
)
def test_a_fraction_beside_a_stroke_that_is_between_gears(text: str, pinion: str | None, gear: str | None):
    parts = placed({"bore": text})
    assert (parts.get("pinion.bore"), parts.get("gear.bore")) == (pinion, gear)


def test_limits_of_both_gears_and_strokes_between_deviations():
    both = {"pinion.span": "32.83 mm -0.05/-0.08", "gear.span": "68.9 mm −60/−90 um"}
    assert placed({"span": "32.83 mm -0.05/-0.08 / 68.9 mm −60/−90 um"}) == both
    assert placed({"span": "32.83 -0.05/-0.08 mm"})["gear.span"] == "32.83 -0.05/-0.08 mm"  # of both gears
    assert placed({"bore": "25 0/-0.05 mm/30mm"}) == {"pinion.bore": "25 0/-0.05 mm", "gear.bore": "30mm"}
    assert placed({"face_width": "33.9:34.1/32 mm"})["pinion.face_width"] == "33.9:34.1 mm"
    assert placed({"profile_shift": "-0.3/-0.1"})["pinion.profile_shift"] == "-0.3"
    assert placed({"thickness_allowance": "-70/-90um"})["gear.thickness_allowance"] == "-90um"


@pytest.mark.parametrize("typed", ["0.06:0.14mm", "0,06–0,14 mm", "60 to 140 um", "0.1 mm ± 0.04"])
def test_limits_of_a_drawing_stay_in_the_file(gearlash: Gearlash, typed: str):
    options = {
        **dict(zip(HELICAL[::2], HELICAL[1::2], strict=True)),
        "--backlash": typed,
        "--torque": "50:250Nm",
    }
    ran = gearlash("new", "pair.toml", *(part for option in options.items() for part in option))
    assert ran.code == 0, ran.err
    assert "values stated, 2 of them with limits, " in ran.out
    assert f'backlash = "{typed}"' in Path("pair.toml").read_text(encoding="utf-8")
    value = {v.path: v for v in load("pair.toml").values()}["mesh.backlash"]
    assert (value.least, value.value, value.greatest) == (60.0, 100.0, 140.0)
    told = " ".join(gearlash("check", "pair.toml").out.split())
    assert "j_n along the line of action; limits 60 to 140 µm" in told
    assert "limits 50 to 250 N·m; the middle of its limits" in told


def test_fits_are_parted_at_any_stroke():
    for text in ("cd25/c26", "25cd/26c", "DIN 3967 25cd/c26"):
        parts = placed({"fit": text})
        assert parts["pinion.fit"] != parts["gear.fit"]
        assert "/" not in "".join(parts.values())
    assert placed({"fit": "25cd"})["gear.fit"] == "25cd"


def test_spur_teeth_on_stated_bearings_need_no_angle(gearlash: Gearlash):
    spur = [*HELICAL[:4], *HELICAL[6:]]
    assert gearlash("new", "spur.toml", *spur, "--type", "spur", "--bearing-y", "1e9N/m").code == 0
    case = load("spur.toml")
    assert (case.kind, case.entries["mesh.helix_angle"].number) == ("helical-pair", 0.0)


def test_one_number_of_teeth_is_refused(gearlash: Gearlash):
    equal = [*HELICAL]
    equal[1] = "23"
    ran = gearlash("new", "pair.toml", *equal)
    assert (ran.code, Path("pair.toml").exists()) == (2, False)
    assert "23/23 of equal gears" in ran.complaint
    equal[1] = "23/23"
    assert gearlash("new", "pair.toml", *equal).code == 0


@pytest.mark.parametrize(
    "text",
    ["25 : 57", "z1=25 z2=57", "z_1 = 25, z_2 = 57", "25-57", "25x57", "25 and 57", "wheel 57, pinion 25"],
)
def test_numbers_of_teeth_without_a_stroke_are_told_with_one(text: str):
    with pytest.raises(GearlashError, match=r"such as 25/57$"):
        placed({"teeth": text})


@pytest.mark.parametrize("text", ["25.5", "1:4", "many", "25 57 91"])
def test_what_is_no_pair_of_numbers_of_teeth_is_not_suggested(text: str):
    with pytest.raises(GearlashError, match=r"such as 25/57$"):
        placed({"teeth": text})


def test_questions_of_a_type_that_is_stated():
    """The helix angle is not asked for of spur teeth, and asked for again of helical ones."""
    told = {"Teeth of": "25/57", "Normal module": "3mm", "Speed of the pinion": "9rpm", "Torque of": "1Nm"}
    angles = ["", "15 deg"]
    questioned: list[str] = []

    def answer(question: str) -> str:
        questioned.append(question)
        if question.startswith("Helix angle"):
            return angles.pop(0)
        return next((text for begin, text in told.items() if question.startswith(begin)), "")

    assert questions.asked(answer, lambda _: None, questions.words_of("helical"))["helix_angle"] == "15 deg"
    questioned.clear()
    assert "helix_angle" not in questions.asked(answer, lambda _: None, questions.words_of("spur"))
    assert not any("Helix" in each for each in questioned)


def test_questions_are_asked_again_until_the_answer_can_be_read():
    answers = iter(["25", "25/57", "3", "3mm", "", "15 deg", *[""] * 10, "7", "", "80um", "4200rpm", "150Nm"])
    said: list[str] = []
    found = questions.asked(lambda _: next(answers), said.append)
    assert found["teeth"] == "25/57"
    assert any("25/25 of equal gears" in text for text in said)
    assert any("length with its unit" in text for text in said)


def test_what_the_drawing_says_otherwise_is_asked_for_in_turn():
    """Pitch in place of a module, W_k and balls of both gears, speed and torque at the gear."""
    told = {
        "Teeth of": "25/57", "Normal diametral": "8", "Face width": "40mm", "Span": "34.1mm/63.7mm",
        "Teeth k": "4/7", "Speed of the gear": "1842rpm", "Torque of the gear": "342Nm",
    }  # fmt: skip
    questioned: list[str] = []

    def answer(question: str) -> str:
        questioned.append(question)
        return next((text for begin, text in told.items() if question.startswith(begin)), "")

    found = questions.asked(answer, lambda _: None)
    assert found == {
        "teeth": "25/57", "diametral_pitch": "8", "face_width": "40mm", "span": "34.1mm/63.7mm",
        "span_teeth": "4/7", "gear_speed": "1842rpm", "gear_torque": "342Nm",
    }  # fmt: skip
    asked_for = " ".join(questioned)
    assert "Dimension over two balls" in asked_for
    assert "Diameter D_M" not in asked_for  # no dimension over balls was answered
    told |= {"Torque of the gear": "", "Power": "66kW", "Dimension over": "83.9mm/", "Span": ""}
    found = questions.asked(answer, lambda _: None)
    assert (found["power"], found["over_balls"]) == ("66kW", "83.9mm/")
    assert "Diameter D_M" in " ".join(questioned)


def test_a_power_where_a_torque_is_asked_for_is_taken_as_one_and_told():
    told = {"Teeth of": "25/57", "Normal module": "3mm", "Speed of the pinion": "4200rpm", "Torque": "7,5 kW"}
    said: list[str] = []

    def answer(question: str) -> str:
        return next((text for begin, text in told.items() if question.startswith(begin)), "")

    found = questions.asked(answer, said.append)
    assert found["power"] == "7,5 kW"
    assert "torque" not in found
    assert any("taken as: Power" in text for text in said)


def _answers(told: dict[str, list[str]]):
    """By the beginning of a question, one after the other; Enter alone for all others."""
    left = {begin: list(texts) for begin, texts in told.items()}

    def answer(question: str) -> str:
        begin = next((each for each in left if question.startswith(each)), None)
        return left[begin].pop(0) if begin is not None and left[begin] else ""

    return answer


NEEDED = {
    "Teeth of": ["25/57"],
    "Normal module": ["3mm"],
    "Speed of the p": ["9rpm"],
    "Torque of the p": ["1Nm"],
}


def test_a_value_that_was_offered_is_taken_by_a_letter():
    """Of both gears at once, too; not where none was offered."""
    told = NEEDED | {
        "Normal module": ["y", "3", "y"], "Face width": ["65/60", "y"], "Bore": ["Ø40H7/Ø70 H7", "Ja"],
        "Flank": ["Q10", "y"], "Profile": ["n.a."], "Helix": ["none"],
    }  # fmt: skip
    said: list[str] = []
    found = questions.asked(_answers(told), said.append)
    assert found == {
        "teeth": "25/57", "module": "3 mm", "face_width": "65 mm/60 mm", "bore": "40 mm/70 mm",
        "quality": "7", "speed": "9rpm", "torque": "1Nm",
    }  # fmt: skip
    assert sum("(y takes that)" in text for text in said) == 4
    assert sum("taken as not known" in text for text in said) == 2


def test_a_question_can_be_gone_back_to_and_tells_more_of_itself():
    told = NEEDED | {
        "Teeth of": ["?", "25/57", "26/57"], "Normal module": ["<", "3mm"], "Material": ["help"],
        "Bore": ["?"],
    }  # fmt: skip
    said: list[str] = []
    found = questions.asked(_answers(told), said.append)
    assert found["teeth"] == "26/57"
    text = " ".join(said)
    assert "was 25/57, and is dropped" in text
    assert "It is needed" in text
    assert "in mm, µm, m, cm, in, mil" in text
    assert "nodular-cast-iron" in text


def test_a_pitch_that_may_be_two_is_told_as_both():
    told = NEEDED | {"Normal module": ["8 DP"], "Normal diametral": ["8"]}
    said: list[str] = []
    assert questions.asked(_answers(told), said.append)["diametral_pitch"] == "8"
    assert any("Normal diametral" in text and "or Transverse diametral" in text for text in said)


def test_what_was_answered_is_told_as_a_command_when_questions_end():
    left = ["25/57", "3 mm", "20°"]

    def ended(_: str) -> str:
        if left:
            return left.pop(0)
        raise EOFError

    command = "gearlash new my.toml --teeth 25/57 --module '3 mm' --pressure-angle '20°'"
    with pytest.raises(GearlashError) as refused:
        questions.asked(ended, lambda _: None, file="my.toml")
    assert command in str(refused.value)


def test_what_a_pair_is_refused_for_is_asked_for_again():
    stated = {"teeth": "25/57", "module": "3mm", "centre_distance": "100mm", "bore": "30mm", "speed": "9rpm"}
    problems = [Problem("mesh.centre_distance", "'100mm'", "teeth that mesh"), Problem("mesh", None, "more")]
    said: list[str] = []
    refused, pair = CaseError("my.toml", problems), CaseError("my.toml", problems[1:])
    found = questions.asked_again(stated, refused, _answers({"Centre": ["1", "128mm"]}), said.append)
    assert found == {**stated, "centre_distance": "128mm"}
    assert any("teeth that mesh" in text for text in said)
    assert questions.asked_again(stated, refused, _answers({"Centre": ["<"]}), said.append) == stated
    assert questions.asked_again(stated, pair, _answers({}), said.append) is None


def test_questions_that_are_interrupted_say_that_nothing_was_written():
    def stopped(_: str) -> str:
        raise KeyboardInterrupt

    said: list[str] = []
    with pytest.raises(KeyboardInterrupt):
        questions.asked(stopped, said.append)
    assert "nothing was written" in said[-1]


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--type", "bevel"), "change along the face"),
        (("--type", "ring gear"), "a ring gear"),
        (("--type", "worm"), "slide along their teeth"),
        (("--type", "planetary"), "one carrier"),
        (("--type", "herringbone"), "half of torque"),
        (("--type", "square"), "expected spur or helical"),
        (("--type", "spring"), "expected spur or helical; gearlash"),
        (("--type", "helical bevel"), "change along the face"),
        (("--type", "rack and pinion"), "a rack has no centre"),
        (("--type", "internal spur"), "a ring gear"),
        (("--type", "helical, of paper"), "expected spur or helical, without paper"),
        (("--type", "not helical"), "without not"),
        (("--type", "geradverzahntes Stirnrad"), "--helix-angle 15 deg is that of helical teeth"),
        (("--type", "helical, worm"), "slide along their teeth"),
        (("--type", "spur gear"), "--helix-angle 15 deg is that of helical teeth"),
        (("--shaft-angle", "90"), "expected an angle with its unit"),
        (("--shaft-angle", "0 mm"), "expected an angle with its unit"),
        (("--shaft-angle", "90°"), "parallel shafts"),
        (("--teeth", "23/-57"), "internal gear"),
        (("--centre-distance", "-123mm"), "internal gear"),
        (("--speed", "-3000rpm"), "no sense of rotation"),
    ],
)
def test_gears_that_no_model_here_takes_are_refused_in_words(
    options: tuple[str, str], told: str, gearlash: Gearlash
):
    ran = gearlash("new", "pair.toml", *HELICAL, *options)
    assert ran.code == 2
    assert told in " ".join(ran.err.split())
    assert not Path("pair.toml").exists()
    assert gearlash("new", "pair.toml", *HELICAL, "--type", "Helical", "--shaft-angle", "0°").code == 0


@pytest.mark.parametrize(
    "stated",
    [
        ("--type", "helical, ground by rack", "--shaft-angle", "0"),
        ("--type", "External helical gears, rack-cut teeth", "--shaft-angle", "180 deg"),
        ("--type", "cylindrical", "--shaft-angle", "0 rad"),
        ("--type", "helical, ground by grinding worm"),
        ("--type", "Stirnrad, schrägverzahnt"),
    ],
)
def test_words_beside_the_type_are_taken_where_they_tell_of_no_other_gears(
    stated: tuple[str, ...], gearlash: Gearlash
):
    assert gearlash("new", "pair.toml", *HELICAL, *stated).code == 0
    assert load("pair.toml").kind == "helical-pair"


@pytest.mark.parametrize("angle", [(), ("--helix-angle", "0deg")])
def test_a_type_that_the_helix_angle_denies_is_refused(angle: tuple[str, ...], gearlash: Gearlash):
    spur = [*HELICAL[:4], *HELICAL[6:], *angle]
    for typed in ("helical", "external helical gears"):
        ran = gearlash("new", "pair.toml", *spur, "--type", typed)
        assert ran.code == 2
        assert "such as --helix-angle 15deg" in " ".join(ran.err.split())
        assert not Path("pair.toml").exists()
    assert gearlash("new", "pair.toml", *spur, "--type", "external spur").code == 0
    assert load("pair.toml").kind == "spur-1dof"


def test_a_template_has_the_teeth_that_the_type_says(gearlash: Gearlash):
    for typed, kind in (("spur", "spur-1dof"), ("helical", "helical-pair")):
        assert gearlash("new", f"{typed}.toml", "--type", typed).code == 0
        assert f'kind = "{kind}"' in Path(f"{typed}.toml").read_text(encoding="utf-8")


def test_questions_that_end_early_write_nothing():
    def ended(_: str) -> str:
        raise EOFError

    with pytest.raises(GearlashError, match="nothing was written"):
        questions.asked(ended, lambda _: None)


def test_what_is_unusual_is_told_and_what_cannot_be_is_refused_with_what_may_be(gearlash: Gearlash):
    undercut = [*HELICAL]
    undercut[undercut.index("--teeth") + 1] = "12/57"
    ran = gearlash("new", "pair.toml", *undercut)
    assert ran.code == 0
    assert "1 to look at" in ran.out
    assert "is undercut: from a profile shift of 0.228 on it would not be" in " ".join(ran.out.split())
    ran = gearlash("new", "other.toml", *HELICAL, "--tip-diameter", "86mm/")
    assert ran.code == 2
    assert "reaches the root of the gear" in " ".join(ran.err.split())
    assert not Path("other.toml").exists()


def test_tip_relief_is_a_word_of_a_drawing(gearlash: Gearlash):
    ran = gearlash("new", "pair.toml", *HELICAL, "--tip-relief", "20um/15um", "--crowning", "8um/")
    assert ran.code == 0
    text = Path("pair.toml").read_text(encoding="utf-8")
    assert 'tip_relief = "20um"' in text
    assert 'tip_relief = "15um"' in text
    assert "static error under load" in " ".join(ran.out.split())
    numbers = load("pair.toml").values()
    values = {v.path: float(v.value) for v in numbers if v.path.startswith("derived.")}
    assert values["derived.loaded_contact_ratio"] < values["derived.transverse_contact_ratio"]


def test_limits_are_answers_to_questions():
    told = {
        **NEEDED,
        "Whole normal backlash": ["0,06-0,14 mm"],
        "Torque of the p": ["50:250Nm"],
        "Speed of the p": ["1500:4500rpm", "3000rpm"],
    }
    said: list[str] = []
    found = questions.asked(_answers(told), said.append)
    assert (found["backlash"], found["torque"], found["speed"]) == ("0,06-0,14 mm", "50:250Nm", "3000rpm")
    assert any("operation.least_speed and operation.greatest_speed" in line for line in said)
