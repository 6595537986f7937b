from __future__ import annotations

import io
import re
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

from zbot import log
from zbot.log import LoggingSeverity, get_logger

if TYPE_CHECKING:
    from tests.unit.log.conftest import Logged


DEBUG, INFO, WARN = LoggingSeverity.DEBUG, LoggingSeverity.INFO, LoggingSeverity.WARN
ERROR, FATAL = LoggingSeverity.ERROR, LoggingSeverity.FATAL
LINE = re.compile(r"\[(\w+)\] \[(\d{10}\.\d{9})\] \[([\w.]+)\]: (.*)", re.DOTALL)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def replaced_stderr(monkeypatch: pytest.MonkeyPatch, *, is_terminal: bool) -> io.StringIO:
    stream = Terminal() if is_terminal else io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)
    return stream


def test_line_has_the_form_of_ros(capsys: pytest.CaptureFixture[str]) -> None:
    assert get_logger("sensor").warning("too hot")
    match = LINE.fullmatch(capsys.readouterr().err.rstrip("\n"))
    assert match is not None
    assert (match[1], match[3], match[4]) == ("WARN", "sensor", "too hot")


@pytest.mark.parametrize("method", ["info", "warn", "warning", "error", "fatal"])
def test_every_level_from_info_on_is_written(method: str, logged: Logged) -> None:
    assert getattr(get_logger("sensor"), method)("text") is True
    assert logged() == ["text"]


def test_debug_is_not_written_until_its_level_is_set(logged: Logged) -> None:
    logger = get_logger("sensor")
    assert logger.debug("before") is False
    logger.set_level(DEBUG)
    assert logger.debug("after") is True
    assert logged() == ["after"]


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


@pytest.mark.parametrize(
    "message",
    [
        *(42, None, 2.5, [1, "two"], ValueError("why"), {"a": 1}),
        *("50 % {name} {}", "100%s", "ü 温度 🤖", "", "\x00"),
    ],
)
def test_any_message_is_written_as_it_is(
    message: object, capsys: pytest.CaptureFixture[str]
) -> None:
    get_logger("sensor").info(message)
    assert capsys.readouterr().err.endswith(f"[sensor]: {message}\n")


def test_lone_surrogates_are_escaped(logged: Logged) -> None:
    records: list[log.Record] = []
    log.add_sink("sensor", records.append)
    get_logger("sensor").info("broken \ud800 name")
    log.remove_sink("sensor", records.append)
    assert logged() == [r"broken \ud800 name"]
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


def test_output_format_has_time_and_place(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    template = "{time_as_nanoseconds}|{time}|{date_time_with_ms}|{line_number}"
    monkeypatch.setenv("RCUTILS_CONSOLE_OUTPUT_FORMAT", template)
    get_logger("sensor").info("text")
    stamp, seconds, date, line = capsys.readouterr().err.rstrip("\n").split("|")
    assert seconds == f"{stamp[:-9]}.{stamp[-9:]}"
    assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3}", date)
    assert date.endswith(stamp[-9:-6])
    assert int(line) == test_output_format_has_time_and_place.__code__.co_firstlineno + 5


def test_stdout_is_used_on_request(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("RCUTILS_LOGGING_USE_STDOUT", "1")
    get_logger("sensor").info("text")
    captured = capsys.readouterr()
    assert captured.out.endswith("text\n")
    assert captured.err == ""


def test_wrong_setting_is_reported_once(monkeypatch: pytest.MonkeyPatch, logged: Logged) -> None:
    monkeypatch.setenv("RCUTILS_COLORIZED_OUTPUT", "yes")
    for number in range(2):
        get_logger("sensor").info(number)
    assert logged() == ["RCUTILS_COLORIZED_OUTPUT is 'yes': use 0 or 1", "0", "1"]


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
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=100
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
    signal.setitimer(signal.ITIMER_REAL, 0.0002)  # not before: it would interrupt itself
signal.signal(signal.SIGALRM, handle)
signal.setitimer(signal.ITIMER_REAL, 0.0002)
while len(calls) < 300:
    logger.info("from the program", skip_first=True)
signal.setitimer(signal.ITIMER_REAL, 0)
"""
    )
    assert result.stderr.count("from the handler") >= 300
