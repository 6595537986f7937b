from __future__ import annotations

import threading
from typing import Any

import pytest

from zbot.errors import ArgumentTypeError
from zbot.launch.actions.execute import ExecuteProcess
from zbot.launch.process_event import ProcessExited, ProcessStarted, ProcessStderr, ProcessStdout
from zbot.launch.testing.assertion import (
    assertExitCodes,
    assertInStderr,
    assertInStdout,
    assertSequentialStdout,
)
from zbot.launch.testing.error import NoMatchingProcessError, SeveralProcessesError
from zbot.launch.testing.process_lookup import NO_CMD_ARGS, resolve_processes
from zbot.launch.testing.record import ExitRecord, OutputRecord
from zbot.launch.testing.tool import ProcessProxy


def event(kind: type[Any], action: ExecuteProcess, **attributes: Any) -> Any:
    made = kind(action=action, **action.process_details)
    for name, value in attributes.items():
        setattr(made, name, value)
    return made


def process(name: str, *arguments: str) -> ExecuteProcess:
    action = ExecuteProcess(cmd=["talker", *arguments])
    action.process_details = {
        "name": name, "cmd": ["talker", *arguments], "cwd": None, "env": {}, "pid": 5,
    }  # fmt: skip
    return action


@pytest.fixture
def talker() -> ExecuteProcess:
    return process("talker-1")


@pytest.fixture
def other() -> ExecuteProcess:
    return process("talker-2", "--loud")


@pytest.fixture
def output(talker: ExecuteProcess, other: ExecuteProcess) -> OutputRecord:
    record = OutputRecord()
    record.append(event(ProcessStdout, talker, text=b"\x1b[32mHello 1\x1b[0m\nHel"))
    record.append(event(ProcessStderr, other, text=b"warned\n"))
    record.append(event(ProcessStdout, talker, text=b"lo 2\n"))
    return record


@pytest.fixture
def exits(talker: ExecuteProcess, other: ExecuteProcess) -> ExitRecord:
    record = ExitRecord()
    record.append(event(ProcessStarted, talker))
    record.append(event(ProcessStarted, other))
    record.append(event(ProcessExited, talker, returncode=0))
    return record


def test_processes_are_found_by_action_name_and_arguments(
    output: OutputRecord, talker: ExecuteProcess, other: ExecuteProcess
) -> None:
    assert resolve_processes(output) == [talker, other]
    assert resolve_processes(output, process=talker) == [talker]
    assert resolve_processes(output, process="talker-2") == [other]
    assert resolve_processes(output, process="talker", cmd_args="--loud") == [other]
    assert resolve_processes(output, process="talker", cmd_args=NO_CMD_ARGS) == [talker]
    assert resolve_processes(output, process="talker", strict_proc_matching=False) == [
        talker,
        other,
    ]


def test_ambiguous_and_unknown_processes_are_refused(output: OutputRecord) -> None:
    with pytest.raises(SeveralProcessesError, match="talker-1, talker-2"):
        resolve_processes(output, process="talker")
    with pytest.raises(NoMatchingProcessError, match="Known are: talker-1, talker-2"):
        resolve_processes(output, process="listener")
    with pytest.raises(NoMatchingProcessError, match="No process started"):
        resolve_processes(OutputRecord())
    wrong: Any = 5
    with pytest.raises(ArgumentTypeError):
        resolve_processes(output, process=wrong)


def test_assertions_search_both_streams(
    output: OutputRecord, talker: ExecuteProcess, other: ExecuteProcess
) -> None:
    assertInStdout(output, "Hello 2", talker)
    assertInStdout(output, ["Hello 1", "Hello 2"], None)
    assertInStderr(output, "warned", other)
    assertInStdout(output, "\x1b[32m", talker, strip_ansi_escape_sequences=False)
    assertInStdout(output, "HELLO", talker, output_filter=str.upper)
    with pytest.raises(AssertionError, match="'warned' is not in the stdout of talker-2"):
        assertInStdout(output, "warned", other)
    with pytest.raises(AssertionError):
        assertInStderr(output, "Hello", talker)


def test_texts_can_be_expected_in_order(output: OutputRecord, talker: ExecuteProcess) -> None:
    with assertSequentialStdout(output, talker) as checker:
        checker.assertInStdout("Hello 1")
        checker.assertInStdout("Hello 2")
        with pytest.raises(AssertionError, match="does not come after"):
            checker.assertInStdout("Hello 1")


def test_exit_codes_are_compared(
    exits: ExitRecord, talker: ExecuteProcess, other: ExecuteProcess
) -> None:
    assertExitCodes(exits, process=talker)
    with pytest.raises(AssertionError, match="talker-2 exited with code None"):
        assertExitCodes(exits)
    exits.append(event(ProcessExited, other, returncode=-2))
    with pytest.raises(AssertionError, match="talker-2 exited with code -2"):
        assertExitCodes(exits)
    assertExitCodes(exits, [0, -2])
    assertExitCodes(exits, [0, 130])
    wrong: Any = ["0"]
    with pytest.raises(ArgumentTypeError):
        assertExitCodes(exits, wrong)


def test_later_output_is_waited_for(output: OutputRecord, talker: ExecuteProcess) -> None:
    late = event(ProcessStdout, talker, text=b"late\n")
    threading.Timer(0.02, output.append, [late]).start()
    output.assertWaitFor("late", process=talker, timeout=60)
    with pytest.raises(AssertionError, match="did not come in time"):
        output.assertWaitFor(msg="never", process=talker, timeout=0.01)
    with pytest.raises(NoMatchingProcessError):
        output.waitFor("x", process="listener", timeout=0.01)


def test_the_end_of_a_process_is_waited_for(exits: ExitRecord, other: ExecuteProcess) -> None:
    exits.assertWaitForStartup(other, timeout=0)
    exits.assertWaitForShutdown("talker-1", timeout=0)
    with pytest.raises(AssertionError, match="'talker-2' to end"):
        exits.assertWaitForShutdown(other, timeout=0.01)
    threading.Timer(0.02, exits.append, [event(ProcessExited, other)]).start()
    exits.assertWaitForShutdown(other, timeout=60)


def test_a_proxy_shows_one_process(
    output: OutputRecord, exits: ExitRecord, talker: ExecuteProcess, other: ExecuteProcess
) -> None:
    proxy = ProcessProxy(talker, exits, output)
    assert proxy.terminated
    assert proxy.exit_code == 0
    assert proxy.stdout.endswith("Hello 2\n")
    assert proxy.stderr == ""
    assert proxy.wait_for_output(lambda text: "Hello 2" in text, timeout=0)
    assert ProcessProxy(other, exits, output).running
    assert not ProcessProxy(other, exits, output).wait_for_shutdown(timeout=0.01)
