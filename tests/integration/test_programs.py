"""Programs that use rclpy in the styles of courses; each runs as a process of its own."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import pytest

if TYPE_CHECKING:
    from tests.conftest import Program, Start

PROGRAMS = Path(__file__).parents[1] / "programs"


class Part(NamedTuple):
    """A program and the lines that it has to print, in this order."""

    program: str
    lines: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    is_endless: bool = False  #: whether it runs until Ctrl-C
    codes: tuple[int, ...] = (0,)  #: its allowed exit codes


def endless(program: str, *lines: str) -> Part:
    return Part(program, lines, is_endless=True)


def ending(program: str, *lines: str, words: tuple[str, ...] = ()) -> Part:
    return Part(program, lines, words)


FARM = endless("rabbit_farm")
FERRY = endless("ferry")
SCENARIOS = [
    (
        endless("greenhouse_probe", "[probe]: target is now 61.5"),
        ending(
            "greenhouse_console",
            "target=95.0: mould grows above 90",
            "bed=melons: ",
            "target=61.5: set",
            "event 61.5 measured 60.5",
            "[61.5, 'tomatoes']",
        ),
    ),
    (
        ending(
            "greenhouse_roof",
            "/garden/lid /garden/closed 3",
            "angles DOUBLE_ARRAY [0.5, 1.0]",
            "hinges STRING_ARRAY ['left', 'right']",
            "open_at DOUBLE 28.5",
            "panes INTEGER 12",
            "['names', 'phases', 'volts'] False",
            "set to a text: False 24.0",
            "3",
            "not declared",
            words=(
                *("--ros-args", "-r", "__node:=lid", "-r", "__ns:=/garden", "-r"),
                *("opened:=closed", "-p", "angles:=[0.5, 1.0]", "-p", "hinges:=[left, right]"),
                *("-p", "open_at:=28.5", "-p", "panes:=12", "-p", "motor.phases:=2"),
                *("--", "--windows", "3"),
            ),
        ),
    ),
    (
        endless("mast", "the mast stands", "the mast is folded"),
        ending(
            "weather_office",
            "complete True",
            "bytes 00010000 4.0 True",
            "ceiling lowest 250 at 0.0, mean 437.5",
            "station North Head True",
            "waited True mast",
        ),
    ),
    (
        ending(
            "sorting_belt",
            "[feeder]: fed 3, stopped True",
            "[feeder]: fed 6, stopped True",
            "[sorter]: even [2, 4, 6] odd [1, 3, 5, 7]",
            "belt off after 2 pauses, 1 timer left",
        ),
    ),
    (
        endless("ferry", "[ferry]: ramp up", "[ferry]: ramp down", "the ferry is moored"),
        ending("ferry_tickets", "trip 1 | trip 2", "trip 3 with 2 bags | trip 4 and trip 5"),
    ),
    (
        FERRY,
        ending(
            "ferry_crew",
            "found True",
            "in a callback True ramp up",
            "in the main thread True False",
        ),
    ),
    (
        endless(
            "rabbit_farm", "[farm]: a fox came", "[farm]: no more than 100000 seasons were wanted"
        ),
        ending(
            "rabbit_keeper",
            "[keeper]: accepted: True",
            "result [1, 1, 2, 3, 5] feedback [2, 3, 5]",
            "refused True",
            "seven seasons aborted",
            "canceling 1 canceled",
        ),
    ),
    (
        FARM,
        ending(
            "rabbit_asyncio",
            "[1, 1, 2, 3] [1, 1, 2, 3, 5, 8]",
            "news: a litter was born",
            "spinning False",
        ),
    ),
    (
        endless(
            "pump",
            "[pump]: valves tested, was unconfigured",
            "[pump]: motor on",
            "[pump]: motor off, some water was moved: True",
            "[pump]: drained",
            "[pump]: scrapped",
        ),
        ending(
            "pump_operator",
            "too early: False unconfigured",
            "True inactive | water False",
            "True active | water True",
            "True inactive | True unconfigured",
            "True finalized True finalized",
        ),
    ),
    (
        ending(
            "lighthouse",
            "dark since 1",
            "flash True",
            "missed True",
            "1 ship",
            "lighthouse 100000000",
        ),
    ),
    (ending("crane", "hook at 10.0 5.0 30.0, no ship"),),
    (
        ending(
            "bakery_clock",
            "rested True True",
            "101500000005 True",
            "clocks differ",
            "bread within the sixth hours: True",
            "running False",
        ),
    ),
    (
        ending(
            "telegraph",
            "[DEBUG]",
            "[INFO]",
            "[WARN]",
            "[ERROR]",
            "[FATAL]",
            "[station.telegraph]: once 0",
            "seldom 0",
            "skipping 1",
            "skipping 2",
            "skipping 3",
            "[station.telegraph.branch]: from the branch",
            "[clerk]: ink is out",
            "station.telegraph DEBUG True",
        ),
    ),
    (
        ending(
            "harbour",
            "/harbour/boats/captain /harbour/boats/siren /harbour/office/log",
            "invalid: ",
            "seen True [('captain', '/harbour/boats'), ('office', '/harbour')]",
            "lock True",
            "['std_msgs/msg/String'] 1",
            "['std_srvs/srv/Empty']",
            "default False own True",
            "own False",
        ),
    ),
    (ending("vineyard", "6 4 18 [40, 120, 20] [20. 60. 10.]", "(2, 3) 1.5 in field"),),
    (ending("mower", "20 poses on the lawn", "at 2.00 2.00, turned by 90.0"),),
    (
        Part("turtlesim", is_endless=True, codes=(-signal.SIGINT,)),
        ending("turtle_post", "built the house", "letter delivered True"),
    ),
    (
        ending(
            "bell_tower",
            "waiting ['monk listens', 'owl listens'] [False, False]",
            "after ['monk heard clang', 'owl heard clang'] ['monk', 'owl']",
        ),
    ),
    (ending("canteen", "served True {('soup', 'table')}", "paid True clashes 0"),),
    (
        ending(
            "postcards",
            "geometry_msgs.msg.Point(x=1.5, y=-2.0, z=0.0) 36 0.25",
            "geometry_msgs/PoseWithCovariance UnboundedString",
            "refused",
            "refused",
            "refused",
            "00010000 True False",
            "True",
            "wish you were here",
        ),
    ),
]
#: Texts that a program prints only when something is wrong.
UNWANTED = ("Traceback", "unheard", "once 1", "skipping 0", "seldom 1", "taken")


def test_every_program_is_in_a_scenario() -> None:
    listed = {part.program for scenario in SCENARIOS for part in scenario}
    assert {path.stem for path in PROGRAMS.glob("*.py")} == listed - {"turtlesim"}


@pytest.mark.parametrize(
    "scenario", SCENARIOS, ids=[scenario[-1].program for scenario in SCENARIOS]
)
def test_the_programs_of_a_scenario_print_their_lines(
    scenario: tuple[Part, ...], start: Start
) -> None:
    def run(part: Part) -> Program:
        path = PROGRAMS / f"{part.program}.py"
        return start("zbot", "run", str(path) if path.is_file() else part.program, *part.words)

    running = [(run(part), part) for part in scenario]
    for program, part in reversed(running):  # the programs that end by themselves come last
        code = program.stop() if part.is_endless else program.wait(30)
        assert code in part.codes, program.output
        expect_in_order(part.lines, program.lines)
        assert not any(word in program.output for word in UNWANTED), program.output


def expect_in_order(expected: tuple[str, ...], lines: list[str]) -> None:
    rest = iter(lines)
    for text in expected:
        assert any(text in line for line in rest), f"{text!r} is not in:\n" + "\n".join(lines)
