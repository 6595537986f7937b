from __future__ import annotations

import io
import re
import signal
import subprocess
import sys
import threading
from typing import TYPE_CHECKING, Any

import pytest

from zbot import log
from zbot.errors import (
    ArgumentTypeError,
    InvalidNameError,
    InvalidSeverityError,
    LogCallChangedError,
    LogOptionError,
    NotAClockError,
    ZbotError,
)
from zbot.log import LoggingSeverity, get_logger
from zbot.time import Time

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

DEBUG, INFO, WARN = LoggingSeverity.DEBUG, LoggingSeverity.INFO, LoggingSeverity.WARN
ERROR, FATAL, UNSET = LoggingSeverity.ERROR, LoggingSeverity.FATAL, LoggingSeverity.UNSET
LINE = re.compile(r"\[(\w+)\] \[(\d{10}\.\d{9})\] \[([\w.]+)\]: (.*)", re.DOTALL)


@pytest.fixture(autouse=True)
def fresh_log(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for variable in ("NO_COLOR", "FORCE_COLOR", "ZBOT_LOG_DIR", "ROS_LOG_DIR", "ROS_HOME"):
        monkeypatch.delenv(variable, raising=False)
    for name in ("CONSOLE_OUTPUT_FORMAT", "COLORIZED_OUTPUT", "LOGGING_USE_STDOUT"):
        monkeypatch.delenv(f"RCUTILS_{name}", raising=False)
    log.clear_config()
    yield
    log.clear_config()


class FakeClock:
    def __init__(self) -> None:
        self.sec = 0.0

    def now(self) -> Time:
        return Time(seconds=self.sec)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def replaced_stderr(monkeypatch: pytest.MonkeyPatch, *, is_terminal: bool) -> io.StringIO:
    stream = Terminal() if is_terminal else io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)
    return stream


def messages(capsys: pytest.CaptureFixture[str]) -> list[str]:
    return [LINE.fullmatch(line)[4] for line in capsys.readouterr().err.splitlines()]  # type: ignore[index]


# -- lines ---------------------------------------------------------------------------------------


def test_line_has_the_form_of_ros(capsys: pytest.CaptureFixture[str]) -> None:
    assert get_logger("sensor").warning("too hot")
    match = LINE.fullmatch(capsys.readouterr().err.rstrip("\n"))
    assert match is not None
    assert (match[1], match[3], match[4]) == ("WARN", "sensor", "too hot")


@pytest.mark.parametrize("method", ["info", "warn", "warning", "error", "fatal"])
def test_every_level_from_info_on_is_written(
    method: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert getattr(get_logger("sensor"), method)("text") is True
    assert messages(capsys) == ["text"]


def test_debug_is_silent_until_its_level_is_set(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("sensor")
    assert logger.debug("before") is False
    logger.set_level(DEBUG)
    assert logger.debug("after") is True
    assert messages(capsys) == ["after"]


@pytest.mark.parametrize("message", [42, None, 2.5, [1, "two"], ValueError("why"), {"a": 1}])
def test_anything_can_be_logged(message: object, capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("sensor").info(message)
    assert messages(capsys) == [str(message)]


def test_message_of_several_lines_stays_one_write(monkeypatch: pytest.MonkeyPatch) -> None:
    writes: list[str] = []

    class Stream(io.StringIO):
        def write(self, text: str) -> int:
            writes.append(text)
            return len(text)

    monkeypatch.setattr(sys, "stderr", Stream())
    get_logger("sensor").info("one\ntwo")
    assert len(writes) == 1
    assert writes[0].endswith("[sensor]: one\ntwo\n")


@pytest.mark.parametrize("message", ["50 % {name} {}", "100%s", "ü 温度 🤖", "", "\x00"])
def test_message_is_written_as_it_is(message: str, capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("sensor").info(message)
    assert capsys.readouterr().err.endswith(f"[sensor]: {message}\n")


def test_lone_surrogates_are_escaped_everywhere(capsys: pytest.CaptureFixture[str]) -> None:
    records: list[log.Record] = []
    log.add_sink("sensor", records.append)
    get_logger("sensor").info("broken \ud800 name")
    log.remove_sink("sensor", records.append)
    assert messages(capsys) == [r"broken \ud800 name"]
    assert records[0].message == r"broken \ud800 name"


def test_stream_that_cannot_encode_gets_escapes(monkeypatch: pytest.MonkeyPatch) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stderr", io.TextIOWrapper(raw, encoding="ascii"))
    get_logger("sensor").info("20 °C")
    assert raw.getvalue().endswith(b"20 \\xb0C\n")


@pytest.mark.parametrize(
    ("template", "expected"),
    [
        ("{severity}|{name}|{message}", "INFO|sensor|text"),
        ("{message}{message}", "texttext"),
        ("{bogus} {} {{message}} 5% {message", "{bogus} {} {text} 5% {message"),
        (r"a\tb\n{message}\x1b[0m \q", "a\tb\ntext\x1b[0m \\q"),
        ("{function_name}", "test_output_format_follows_the_variable"),
        ("{file_name}", __file__),
    ],
)
def test_output_format_follows_the_variable(
    template: str,
    expected: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("RCUTILS_CONSOLE_OUTPUT_FORMAT", template)
    get_logger("sensor").info("text")
    assert capsys.readouterr().err == f"{expected}\n"


def test_output_format_tells_time_and_place(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    template = "{time_as_nanoseconds}|{time}|{date_time_with_ms}|{line_number}"
    monkeypatch.setenv("RCUTILS_CONSOLE_OUTPUT_FORMAT", template)
    get_logger("sensor").info("text")
    stamp, seconds, date, line = capsys.readouterr().err.rstrip("\n").split("|")
    assert seconds == f"{stamp[:-9]}.{stamp[-9:]}"
    assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}", date)
    assert date.endswith(stamp[-9:-6])
    assert int(line) == test_output_format_tells_time_and_place.__code__.co_firstlineno + 5


def test_stdout_is_used_on_request(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RCUTILS_LOGGING_USE_STDOUT", "1")
    get_logger("sensor").info("text")
    captured = capsys.readouterr()
    assert captured.out.endswith("text\n")
    assert captured.err == ""


def test_wrong_setting_is_told_once(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RCUTILS_COLORIZED_OUTPUT", "yes")
    for number in range(2):
        get_logger("sensor").info(number)
    assert messages(capsys) == ["RCUTILS_COLORIZED_OUTPUT is 'yes': use 0 or 1", "0", "1"]


# -- colour --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("severity", "colour"), [(DEBUG, 32), (INFO, 0), (WARN, 33), (ERROR, 31), (FATAL, 31)]
)
def test_terminal_gets_the_colours_of_ros(
    severity: LoggingSeverity, colour: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    stream = replaced_stderr(monkeypatch, is_terminal=True)
    log.set_logger_level("", DEBUG)
    get_logger("sensor").log("text", severity)
    text = stream.getvalue()
    assert text.startswith(f"\x1b[{colour}m[{severity.name}]")
    assert text.endswith("text\x1b[0m\n")


@pytest.mark.parametrize(
    ("variables", "is_terminal", "is_coloured"),
    [
        ({}, False, False),
        ({}, True, True),
        ({"NO_COLOR": "1"}, True, False),
        ({"FORCE_COLOR": "1"}, False, True),
        ({"NO_COLOR": "1", "FORCE_COLOR": "1"}, True, False),
        ({"RCUTILS_COLORIZED_OUTPUT": "1", "NO_COLOR": "1"}, False, True),
        ({"RCUTILS_COLORIZED_OUTPUT": "0", "FORCE_COLOR": "1"}, True, False),
    ],
)
def test_colour_follows_terminal_and_environment(
    variables: dict[str, str],
    is_terminal: bool,
    is_coloured: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for variable, value in variables.items():
        monkeypatch.setenv(variable, value)
    stream = replaced_stderr(monkeypatch, is_terminal=is_terminal)
    get_logger("sensor").info("text")
    assert ("\x1b" in stream.getvalue()) == is_coloured


# -- broken outputs ------------------------------------------------------------------------------


class BrokenPipe(io.StringIO):
    def write(self, text: str) -> int:
        raise BrokenPipeError(text)


def closed_stream() -> io.StringIO:
    stream = io.StringIO()
    stream.close()
    return stream


@pytest.mark.parametrize("stream", [None, BrokenPipe(), closed_stream()])
def test_unusable_stream_never_raises(stream: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", stream)
    assert get_logger("sensor").info("text") is True


def run(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=20
    )


def test_lines_of_threads_do_not_mix() -> None:
    result = run(
        """
import threading
from zbot.log import get_logger
def work(letter):
    logger = get_logger(letter)
    for _ in range(200):
        logger.info(letter * 300)
threads = [threading.Thread(target=work, args=[letter]) for letter in "abcd"]
[thread.start() for thread in threads]
[thread.join() for thread in threads]
"""
    )
    lines = result.stderr.splitlines()
    assert len(lines) == 800
    assert all(re.search(r"\[(\w)\]: \1{300}$", line) for line in lines)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="Windows has no interval timer")
def test_signal_handler_may_log_at_any_moment() -> None:
    result = run(
        """
import signal
from zbot.log import get_logger
logger, calls = get_logger("main"), []
def handle(*_):
    calls.append(logger.info("from the handler", throttle_duration_sec=1e-9))
signal.signal(signal.SIGALRM, handle)
signal.setitimer(signal.ITIMER_REAL, 0.0002, 0.0002)
while len(calls) < 300:
    logger.info("from the program", skip_first=True)
signal.setitimer(signal.ITIMER_REAL, 0)
"""
    )
    assert result.stderr.count("from the handler") >= 300


# -- levels --------------------------------------------------------------------------------------


def test_levels_are_inherited_by_dots() -> None:
    child = get_logger("robot").get_child("arm")
    log.set_logger_level("robot", WARN)
    assert child.name == "robot.arm"
    assert child.get_effective_level() is WARN
    assert log.get_logger_effective_level("robot.arm.hand") is WARN
    assert log.get_logger_effective_level("robotic") is INFO
    child.set_level(DEBUG)
    assert child.is_enabled_for(DEBUG)
    assert not get_logger("robot").is_enabled_for(INFO)
    child.set_level(UNSET)
    assert child.get_effective_level() is WARN


def test_own_level_is_unset_until_it_is_set() -> None:
    assert log.get_logger_level("robot") is UNSET
    assert log.get_logger_level("") is INFO
    log.set_logger_level("robot", 40)
    assert log.get_logger_level("robot") is ERROR


def test_empty_name_sets_the_level_of_all() -> None:
    log.set_logger_level("", ERROR)
    assert get_logger("anything").get_effective_level() is ERROR
    log.set_logger_level("", UNSET)
    assert get_logger("anything").get_effective_level() is INFO


def test_is_enabled_for_unset_is_false() -> None:
    assert not get_logger("sensor").is_enabled_for(UNSET)


def test_configure_sets_levels_and_switches(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("sensor")
    log.configure({"": 40, "sensor": 10})
    assert (logger.get_effective_level(), log.get_logger_effective_level("x")) == (DEBUG, ERROR)
    log.configure(DEBUG)
    assert log.get_logger_effective_level("x") is DEBUG
    log.configure(stdout_enabled=False)
    assert logger.info("unseen") is True
    assert capsys.readouterr().err == ""


def test_clear_config_forgets_levels() -> None:
    logger = get_logger("sensor")
    logger.set_level(FATAL)
    log.clear_config()
    assert logger.get_effective_level() is INFO


@pytest.mark.parametrize("text", ["info", "INFO", "Info"])
def test_severity_is_read_from_text(text: str) -> None:
    assert log.get_logging_severity_from_string(text) is INFO


@pytest.mark.parametrize(
    "call",
    [
        lambda: log.get_logging_severity_from_string("loud"),
        lambda: log.set_logger_level("sensor", 25),
        lambda: get_logger("sensor").set_level("debug"),  # type: ignore[arg-type]
        lambda: get_logger("sensor").log("text", 35),
        lambda: get_logger("sensor").is_enabled_for(-1),
        lambda: log.configure({"sensor": 1}),
    ],
)
def test_unknown_severity_is_refused(call: Callable[[], object]) -> None:
    with pytest.raises(InvalidSeverityError, match=r"use DEBUG \(10\)") as raised:
        call()
    assert isinstance(raised.value, (ValueError, RuntimeError))


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: get_logger(""), InvalidNameError),
        (lambda: get_logger("sensor").get_child(""), InvalidNameError),
        (lambda: get_logger(7), ArgumentTypeError),  # type: ignore[arg-type]
    ],
)
def test_logger_needs_a_name(call: Callable[[], object], error: type[ZbotError]) -> None:
    with pytest.raises(error):
        call()


# -- filters -------------------------------------------------------------------------------------


def test_once_writes_the_first_call_at_a_place(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("sensor")
    told = [logger.info(number, once=True) for number in range(3)]
    told += [logger.info("elsewhere", once=True), logger.info("same line", once=True)]
    assert told == [True, False, False, True, True]
    assert messages(capsys) == ["0", "elsewhere", "same line"]


def test_once_is_remembered_for_each_logger(capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("a", "b", "a"):
        get_logger(name).info(name, once=True)
    assert messages(capsys) == ["a", "b", "a"]


def test_once_waits_until_the_level_lets_it_through() -> None:
    logger = get_logger("sensor")
    told = []
    for level in (ERROR, INFO, INFO):
        logger.set_level(level)
        told.append(logger.info("text", once=True))
    assert told == [False, True, False]


def test_skip_first_writes_all_but_the_first() -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", skip_first=True) for _ in range(3)] == [False, True, True]


def test_skip_first_and_once_write_the_second() -> None:
    logger = get_logger("sensor")
    told = [logger.info("text", skip_first=True, once=True) for _ in range(4)]
    assert told == [False, True, False, False]


def test_throttle_writes_one_line_in_its_duration() -> None:
    logger, clock, told = get_logger("sensor"), FakeClock(), []
    for clock.sec in (0.0, 0.5, 0.99, 1.0, 1.5, 7.0, 7.1):
        told.append(logger.info("text", throttle_duration_sec=1.0, throttle_time_source_type=clock))
    assert told == [True, False, False, True, False, True, False]


def test_throttle_writes_when_simulated_time_begins_again() -> None:
    logger, clock, told = get_logger("sensor"), FakeClock(), []
    for clock.sec in (100.0, 100.5, 0.0, 0.5):
        told.append(logger.info("text", throttle_duration_sec=1.0, throttle_time_source_type=clock))
    assert told == [True, False, True, False]


def test_throttle_measures_monotonic_time_by_default() -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", throttle_duration_sec=3600) for _ in range(3)] == [
        True,
        False,
        False,
    ]


@pytest.mark.parametrize("options", [{"once": False}, {"throttle_duration_sec": 0}])
def test_filter_that_is_off_does_nothing(options: dict[str, Any]) -> None:
    logger = get_logger("sensor")
    assert [logger.info("text", **options) for _ in range(3)] == [True] * 3


def test_other_name_is_used_for_the_line(capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("sensor").info("text", name="driver")
    assert "[driver]: text" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "error", "text"),
    [
        ({"onse": True}, LogOptionError, "'onse' does not exist"),
        ({"throttle_time_source_type": FakeClock()}, LogOptionError, "throttle_duration_sec"),
        ({"throttle_duration_sec": "1"}, ArgumentTypeError, "number of seconds"),
        (
            {"throttle_duration_sec": 1, "throttle_time_source_type": "STEADY"},
            NotAClockError,
            "'STEADY'",
        ),
    ],
)
def test_wrong_option_is_refused(
    options: dict[str, Any], error: type[ZbotError], text: str
) -> None:
    with pytest.raises(error, match=text):
        get_logger("sensor").info("text", **options)


@pytest.mark.parametrize(
    ("first", "second", "what"),
    [
        ({"severity": INFO}, {"severity": WARN}, "severity"),
        ({"severity": INFO, "name": "a"}, {"severity": INFO, "name": "b"}, "logger name"),
        ({"severity": INFO}, {"severity": INFO, "once": True}, "filters"),
        (
            {"severity": INFO, "throttle_duration_sec": 1.0},
            {"severity": INFO, "throttle_duration_sec": 2.0},
            "filters",
        ),
    ],
)
def test_place_cannot_change_what_it_asks_for(
    first: dict[str, Any], second: dict[str, Any], what: str
) -> None:
    logger = get_logger("sensor")

    def place(options: dict[str, Any]) -> bool:
        return logger.log("text", **options)

    assert place(first)
    assert place(first) or "throttle_duration_sec" in first
    with pytest.raises(LogCallChangedError, match=rf"{what} .*test_log\.py:\d+"):
        place(second)


# -- sinks ---------------------------------------------------------------------------------------


@pytest.fixture
def records() -> Iterator[list[log.Record]]:
    received: list[log.Record] = []
    sink = received.append
    log.add_sink("robot", sink)
    yield received
    log.remove_sink("robot", sink)


def test_sink_gets_the_lines_of_its_logger_and_children(records: list[log.Record]) -> None:
    for name in ("robot", "robot.arm", "robotic", "other"):
        get_logger(name).info(name)
    assert [record.name for record in records] == ["robot", "robot.arm"]


def test_record_tells_where_the_line_was_logged(records: list[log.Record]) -> None:
    get_logger("robot").error("text")
    record = records[0]
    assert (record.level, record.message) == (ERROR, "text")
    assert (record.file, record.function) == (
        __file__,
        test_record_tells_where_the_line_was_logged.__name__,
    )
    assert record.line == test_record_tells_where_the_line_was_logged.__code__.co_firstlineno + 1
    assert record.stamp_ns > 1_700_000_000 * 10**9


def test_sink_works_for_loggers_made_before_it() -> None:
    logger, received = get_logger("late"), list[log.Record]()
    sink = received.append
    log.add_sink("late", sink)
    logger.info("heard")
    log.remove_sink("late", sink)
    log.remove_sink("late", sink)
    logger.info("not heard")
    assert [record.message for record in received] == ["heard"]


def test_sinks_can_be_switched_off(records: list[log.Record]) -> None:
    log.configure(rosout_enabled=False)
    get_logger("robot").info("text")
    assert records == []


def test_failing_sink_is_told_once_and_loses_nothing(
    records: list[log.Record], capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(record: log.Record) -> None:
        raise OSError(f"no network for {record.message}")

    log.add_sink("robot.arm", fail)
    for number in (1, 2):
        get_logger("robot.arm").info(number)
    log.remove_sink("robot.arm", fail)
    told = messages(capsys)
    assert told == [
        "1",
        "a sink of logger 'robot.arm' failed, told once: OSError('no network for 1')",
        "2",
    ]
    assert [record.message for record in records] == ["1", "2"]


def test_what_a_sink_logs_does_not_come_back_to_it(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("loop")

    def sink(record: log.Record) -> None:
        logger.info(f"sent {record.message}")

    log.add_sink("loop", sink)
    logger.info("text")
    log.remove_sink("loop", sink)
    assert messages(capsys) == ["text", "sent text"]


def test_sinks_of_other_threads_are_not_held_back() -> None:
    received: list[str] = []

    def sink(record: log.Record) -> None:
        received.append(record.message)
        if record.message == "outer":
            thread = threading.Thread(target=get_logger("busy").info, args=["inner"])
            thread.start()
            thread.join()

    log.add_sink("busy", sink)
    get_logger("busy").info("outer")
    log.remove_sink("busy", sink)
    assert received == ["outer", "inner"]


# -- files ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("variable", ["ZBOT_LOG_DIR", "ROS_LOG_DIR"])
def test_lines_go_to_a_file_where_a_folder_is_set(
    variable: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "new" / "logs"
    monkeypatch.setenv(variable, str(folder))
    monkeypatch.setattr(sys, "argv", ["/somewhere/sensor.py"])
    assert not folder.exists()
    get_logger("sensor").info("20 °C")
    get_logger("sensor").info("21 °C")
    (file,) = folder.iterdir()
    assert re.fullmatch(r"sensor_\d+_\d{13}\.log", file.name)
    lines = file.read_text(encoding="utf-8").splitlines()
    assert [line.partition("]: ")[2] for line in lines] == ["20 °C", "21 °C"]


def test_file_has_no_colour_and_stays_when_the_console_is_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    monkeypatch.setenv("FORCE_COLOR", "1")
    log.configure(stdout_enabled=False, file_prefix="mine")
    get_logger("sensor").info("text")
    (file,) = tmp_path.iterdir()
    assert file.name.startswith("mine_")
    assert LINE.fullmatch(file.read_text().rstrip("\n"))


def test_file_can_be_switched_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    log.configure(file_enabled=False)
    get_logger("sensor").info("text")
    assert list(tmp_path.iterdir()) == []


def test_unusable_folder_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "file"))
    for number in range(2):
        get_logger("sensor").info(number)
    told = messages(capsys)
    assert (told[0], told[2:]) == ("0", ["1"])
    assert told[1].startswith("cannot write the log file")


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({"ZBOT_LOG_DIR": "z", "ROS_LOG_DIR": "r", "ROS_HOME": "h"}, "z"),
        ({"ROS_LOG_DIR": "r", "ROS_HOME": "h"}, "r"),
        ({"ROS_HOME": "h"}, "h/log"),
        ({}, "home/.ros/log"),
        ({"ZBOT_LOG_DIR": "", "ROS_LOG_DIR": "~/r"}, "home/r"),
    ],
)
def test_logging_directory_follows_the_environment(
    variables: dict[str, str], expected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", "home")
    monkeypatch.setenv("USERPROFILE", "home")
    for variable, value in variables.items():
        monkeypatch.setenv(variable, value)
    assert log.get_logging_directory().as_posix() == expected
