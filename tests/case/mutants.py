"""Case files with something wrong in them, made from right ones by a seed: any number, each time the same.

`python -m case.mutants 50000 7`, in `tests/`, loads so many of another seed and prints what goes wrong."""

from __future__ import annotations

import random
import re
import sys
import tempfile
import time
import traceback
import warnings
from collections.abc import Iterator
from pathlib import Path

from case.corpus import HELICAL, SPUR
from case.piecewise_texts import TEXT, dense
from gearlash.case import Case, CaseError, bundled, load
from gearlash.case.read import source_text

LONGEST = 10_000  # characters of a refusal, which names twenty problems at the most
SOON = 20.0  # s, generous: one takes milliseconds
TRIALS = Path(__file__).parents[1] / "cases"
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_QUOTED = re.compile(r'"[^"\n]*"')

NUMBERS = [
    "0", "0.0", "-0.0", "1", "-1", "2", "3", "41", "1e-3", "5e-324", "1e-308", "1e-300", "1e-160", "1e160",
    "1e300", "1e308", "1e309", "-1e308", "nan", "inf", "-inf", "+nan", "0x1F", "0b1", "1_000", "1e6", "1e9",
    "-5", "0.5", "9007199254740993", "1.0000000000000002", "9" * 19, "9" * 400, "0." + "3" * 400,
    "1e" + "9" * 30,
]  # fmt: skip
THINGS = [
    "true", "false", '""', '"x"', "[]", "[1]", "[[1, 2], [3]]", '["a"]', "{}", "{ value = 1 }", "1979-05-27",
    "1979-05-27T07:32:00Z", "07:32:00", "{ cos = 1 }", "{ cos = [1, 2, 3], sin = [1] }", "{ mean = nan }",
    '{ value = 0.05, provenance = "assumed", reason = "r" }', '{ value = 1, provenance = "no" }',
    "'''a\nb'''",
    '"1 mm"', '"-1 um"', '"1e999 N/m"', '"1e308 N/m"', '"5e-324 kg"', '"3·10⁸ N/m"', '"1 mm²"', '"4,5 mm"',
    '"omega"', '"omega*omega"', '"1/0"', '"sqrt(-1)"', '"exp(1000)"', '"2**9**9"', '"((((1))))"', '"x.y"',
    '"\\u0000"', '"\\u202e"', '"µm"', '"always"', '"in-contact"', '"no-tension"', "9" * 5000, "[" * 3000,
    "{ a = { a = { a = { a = 1 } } } }", "[" + "1, " * 3000 + "1]", '"' + "(" * 3000 + '"', "[nan, inf]",
]  # fmt: skip
LINES = [
    "[mesh]", "[pinion]", "[dimensionless]", "[operation]", "[model]", "[source]", "[parameters]", "[matrix]",
    "[forcing]", "[[clearance]]", "[initial]", "[nonsense]", "[a.b.c.d]", "[[mesh]]", "x = 1", "kind = 3",
    'kind = "spur-1dof"', 'kind = "helical-pair"', 'kind = "piecewise-linear"', 'kind = ""', "omega = 1",
    "D = 1", "error = 1", "= 1", "a = ", "\x00", "\ufeff", "'", '"""', "é = 1", '"" = 1', "cycles = 1000000",
    ".".join("a" * 200) + " = 1", "k" * 5000 + " = 1", "[" + "k" * 5000 + "]", "<<<<<<< mine",
    "# " + "é" * 999,
]  # fmt: skip
LETTERS = list("\x00\x1b\x7f\u202e\ufeff\ud7ff \t\n\r\"'[]{}=.,#-+*/^()0123456789eEnaµ²·ξ😀é")
BYTES = [
    b"\xff",
    b"\xfe\xff",
    b"\xc3",
    b"\x80",
    b"\xed\xa0\x80",
    b"\x00",
    b"\r",
    b"\xef\xbb\xbf",
    b"\xf0\x9f",
]


def sources() -> list[str]:
    """Right files of every kind."""
    trials = [path.read_text(encoding="utf-8") for path in sorted(TRIALS.glob("*.toml"))]
    return [*(source_text(name)[1] for name in bundled()), *trials, HELICAL, SPUR, TEXT, dense()]


def files(count: int, seed: int) -> Iterator[bytes]:
    """So many files."""
    texts, choose = sources(), random.Random(seed)
    for _ in range(count):
        text = choose.choice(texts)
        for _ in range(choose.choice((0, 1, 1, 1, 2, 3, 6))):
            text = choose.choice(CHANGES)(text, choose)
        data = text.encode("utf-8", "surrogatepass")
        if choose.random() < 0.08:
            at = choose.randrange(len(data) + 1)
            data = data[:at] + choose.choice(BYTES) + data[at + choose.randrange(3) :]
        yield data if choose.random() < 0.97 else data[: choose.randrange(len(data) + 1)]


def _lines(text: str, choose: random.Random) -> str:
    """A line lost, doubled, exchanged with another or put in."""
    rows = text.splitlines() or [""]
    i, j = choose.randrange(len(rows)), choose.randrange(len(rows))
    what = choose.randrange(5)
    if what == 0:
        del rows[i]
    elif what == 1:
        rows.insert(j, rows[i])
    elif what == 2:
        rows[i], rows[j] = rows[j], rows[i]
    elif what == 3:
        rows.insert(i, choose.choice(LINES))
    else:
        rows[i:i] = rows[j : j + choose.randrange(12)] * choose.choice((1, 1, 2, 50))
    return "\n".join(rows)


def _letters(text: str, choose: random.Random) -> str:
    at, length = choose.randrange(len(text) + 1), choose.choice((0, 1, 1, 3))
    return text[:at] + choose.choice(LETTERS) * choose.choice((0, 1, 1, 2)) + text[at + length :]


def _numbers(text: str, choose: random.Random) -> str:
    return _replaced(text, _NUMBER, choose.choice(NUMBERS), choose)


def _texts(text: str, choose: random.Random) -> str:
    return _replaced(text, _QUOTED, choose.choice((*THINGS, *(f'"{each} mm"' for each in NUMBERS))), choose)


def _values(text: str, choose: random.Random) -> str:
    """What stands behind a name."""
    return _replaced(text, re.compile(r"(?<== )[^\n]+"), choose.choice((*THINGS, *NUMBERS)), choose)


def _names(text: str, choose: random.Random) -> str:
    """A name with another one's place, or misspelt."""
    found = re.findall(r"\b[a-zA-Z_]\w*\b", text) or ["x"]
    name = choose.choice((*found, *found, "x", "é", "a" * 300, "constructor", "__class__", "ripple_9", "CON"))
    return _replaced(text, re.compile(r"\b[a-zA-Z_]\w*\b"), name, choose)


def _replaced(text: str, pattern: re.Pattern[str], new: str, choose: random.Random) -> str:
    places = list(pattern.finditer(text))
    if not places:
        return text + new
    place = choose.choice(places)
    return text[: place.start()] + new + text[place.end() :]


CHANGES = [_lines, _letters, _numbers, _numbers, _texts, _values, _values, _names]


def wrong(path: Path, data: bytes) -> tuple[str, Case | None]:
    """What is wrong with how a file is taken or refused, if anything is; and the case that it holds."""
    path.write_bytes(data)
    began, case = time.monotonic(), None
    try:
        case = load(path)
        assert Case.from_json(case.to_json()).hash == case.hash
        case.family()[0].system()
        case.notes()
    except CaseError as error:
        told = str(error)
        if case is not None:
            return f"refused after it was taken: {told[:500]}", None
        if not (path.name in told and error.problems and all(p.expected for p in error.problems)):
            return f"names no place: {told[:500]}", None
        if len(told) > LONGEST:
            return f"{len(told)} characters: {told[:500]}", None
    except Exception:  # noqa: BLE001 (any other is what is looked for)
        return traceback.format_exc()[-1500:], None
    taken = time.monotonic() - began
    return (f"took {taken:.1f} s" if taken > SOON else ""), case


def main(count: int, seed: int) -> None:
    """Prints what goes wrong, each kind once."""
    warnings.simplefilter("error")
    seen, taken = set(), 0
    with tempfile.TemporaryDirectory() as folder:
        for number, data in enumerate(files(count, seed)):
            told, case = wrong(Path(folder) / "case.toml", data)
            taken += case is not None
            kind = told.strip().splitlines()[-1][:60] if told else ""
            if told and kind not in seen:
                seen.add(kind)
                (Path(tempfile.gettempdir()) / f"mutant-{seed}-{number}.toml").write_bytes(data)
                print(f"--- {number}: {told}", flush=True)
    print(f"{count} files of seed {seed}: {taken} taken, {len(seen)} kinds of wrong answers")


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
