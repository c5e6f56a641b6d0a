"""What is recorded: commands over every kind of case, contact rule, number of gaps and kind of answer."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Recorded:
    """One command, without `--json` and `--out`. `quick` ones are compared whenever the tests run."""

    name: str
    arguments: tuple[str, ...]
    quick: bool = False

    @property
    def result(self) -> str:
        """Kind of answer: the command's name."""
        return self.arguments[0]


def _of(name: str, line: str, *, quick: bool = False) -> Recorded:
    return Recorded(name, tuple(line.split()), quick)


COMMANDS = (
    _of("run-article", "run article", quick=True),
    _of("run-article-grazing", "run article --set omega=0.8301"),
    _of("run-article-long", "run article --set D=0.3523 --set omega=0.78"),
    _of("run-article-aperiodic", "run article --set omega=0.78 --set D=0.25"),
    _of("run-article-in-contact", "run article --set omega=0.9 --set model.contact=in-contact"),
    _of("run-article-no-tension", "run article --set omega=0.9 --set model.contact=no-tension"),
    _of("run-article-back-load", "run article --set load=-0.0919683 --set omega=0.9"),
    _of("run-drive", "run {cases}/drive.toml --set pinion_speed=6800rpm"),
    _of("run-soft-stop", "run {cases}/soft-stop.toml --set omega=0.82", quick=True),
    _of("run-geared-rotor", "run geared-rotor"),
    _of("run-two-stage", "run two-stage"),
    _of("run-shaw-holmes", "run shaw-holmes", quick=True),
    _of("run-wind-turbine", "run wind-turbine"),
    _of("run-blankenship-kahraman", "run blankenship-kahraman"),
    _of("run-not-excited", "run article --set ripple_2=0 --set error=0"),
    _of("check-drive", "check {cases}/drive.toml", quick=True),
    _of("check-article", "check article", quick=True),
    _of("check-two-stage", "check two-stage", quick=True),
    _of("sweep-article-omega", "sweep article --over omega=0.8:1.15:36"),
    _of("sweep-article-backlash", "sweep article --set omega=0.78 --over D=0.3:0.5:21"),
    _of("sweep-drive-speed", "sweep {cases}/drive.toml --over pinion_speed=1000rpm:7000rpm:13"),
    _of("sweep-kahraman-singh", "sweep kahraman-singh --over omega=0.8:0.84:9"),
    _of("sweep-geared-rotor", "sweep geared-rotor --over omega=0.6:1:5"),
    _of("sweep-soft-stop", "sweep {cases}/soft-stop.toml --over omega=0.7:0.9:11 --up", quick=True),
    _of("map-article", "map article --over omega=0.8:1.2:9 --over D=0.3:1:6"),
    _of("map-soft-stop", "map {cases}/soft-stop.toml --over omega=0.6:1:5 --over a=0.5:0.9:4", quick=True),
    _of("zones-article", "zones article --over omega=0.9:1.2:13"),
    _of("zones-article-backlash", "zones article --set omega=0.78 --over D=0.3:0.5:11"),
    _of("zones-drive", "zones {cases}/drive.toml --over pinion_speed=1000rpm:6000rpm:15"),
    _of("zones-soft-stop", "zones {cases}/soft-stop.toml --over omega=0.6:1:9"),
    _of("graze-article", "graze article --near 1.11"),
    _of("graze-article-low", "graze article --near 0.83"),
    _of("graze-article-backlash", "graze article --over D --set omega=0.78 --near 0.386"),
    _of("graze-drive", "graze {cases}/drive.toml"),
    _of("graze-soft-stop", "graze {cases}/soft-stop.toml --near 0.8"),
    _of("reproduce", "reproduce"),
)
