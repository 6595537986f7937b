"""Tests of how `zbot launch` and its programs end."""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.launch.conftest import pid_in
from tests.conftest import Program, wait_until

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path
_STUBBORN = "import signal; [signal.signal(n, signal.SIG_IGN) for n in (2, 15)]; print('deaf'); "
_STUBBORN += "import time; time.sleep(60)"


def test_a_failed_program_is_reported_in_the_exit_code(launch: Callable[..., Program]) -> None:
    program = launch("python('raise SystemExit(3)', name='bad'), python('', name='good')")
    assert program.wait() == 1
    died = program.output
    assert re.search(r"\[ERROR\] \[bad-1\]: process has died \[pid \d+, exit code 3, cmd '", died)
    assert "[INFO] [good-2]: process has finished cleanly" in died


def test_shutdown_ends_the_others(launch: Callable[..., Program]) -> None:
    program = launch(
        "python('import time; time.sleep(60)', name='long'),"
        "python('', name='short', on_exit=Shutdown(reason='enough'))"
    )
    assert program.wait() == 0
    assert "[INFO] [long-1]: sending signal 'SIGINT' to process[long-1]" in program.output


def test_an_unresponsive_program_gets_sigterm_and_sigkill(launch: Callable[..., Program]) -> None:
    program = launch(
        f"python({_STUBBORN!r}, name='deaf', sigterm_timeout='0.2', sigkill_timeout=0.2)"
    )
    program.wait_for("[deaf-1] deaf")
    assert program.stop() == 0
    text = program.output
    assert "process[deaf-1] failed to terminate '0.2' seconds after receiving 'SIGINT'" in text
    assert "escalating to 'SIGTERM'" in text
    assert "escalating to 'SIGKILL'" in text


def test_a_second_ctrl_c_does_not_wait(launch: Callable[..., Program]) -> None:
    program = launch(f"python({_STUBBORN!r}, name='deaf')")
    program.wait_for("[deaf-1] deaf")
    for line in ("user interrupted with ctrl-c", "user interrupted again"):
        program.process.send_signal(signal.SIGINT)
        program.wait_for(line)
    program.wait_for("escalating to 'SIGTERM'")
    program.process.send_signal(signal.SIGINT)
    assert program.wait(3) == 0


# Python misses a signal that comes just before it goes to sleep. So a thread says that it sleeps.
_SLEEP = (
    "import threading, time; "
    "threading.Timer(0.1, print, ['working'], {'flush': True}).start(); time.sleep(600)"
)
_SLOW = {
    "function": f"OpaqueFunction(function=lambda _: exec({_SLEEP!r}))",
    "file": "IncludeLaunchDescription('slow.launch.py')",
    "caught": "*[IncludeLaunchDescription('caught.launch.py') for _ in range(2)]",
}
_CAUGHT = f"""
from launch import LaunchDescription
def generate_launch_description():
    try:
        {_SLEEP}
    except:
        return LaunchDescription()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("slow", list(_SLOW))
def test_a_signal_ends_code_of_a_launch_file_that_takes_long(
    launch: Callable[..., Program], tmp_path: Path, slow: str, number: int
) -> None:
    (tmp_path / "slow.launch.py").write_text(_SLEEP)
    (tmp_path / "caught.launch.py").write_text(_CAUGHT)
    before, after = "python('', name='before')", "python('', name='after')"
    program = launch(f"{before}, {_SLOW[slow]}, {after}")
    program.wait_for("working")
    assert program.stop(number) == 0
    assert program.output.count("working") == 1
    assert "process started" not in program.output
    assert "Traceback" not in program.output


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_a_signal_ends_a_command_and_its_children(
    launch: Callable[..., Program], tmp_path: Path
) -> None:
    line = f"sh -c \"echo $$ > '{tmp_path}/pid'; sleep 60; true\""
    program = launch(f"LogInfo(msg=Command({line!r}))")
    assert wait_until(lambda: (tmp_path / "pid").exists() and (tmp_path / "pid").read_text() != "")
    assert program.stop() == 0
    group = int((tmp_path / "pid").read_text())
    assert wait_until(lambda: not _is_group_alive(group))


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_a_killed_launch_leaves_no_process(launch: Callable[..., Program]) -> None:
    program = launch(
        "Node(package='zbot', executable='talker'),"
        "ExecuteProcess(cmd=['sleep 60 & sleep 60 & echo here; wait'], shell=True, name='sh'),"
        f"python({_STUBBORN!r}, name='deaf')"
    )
    pids = [pid_in(program.wait_for("process started with pid [")) for _ in range(3)]
    program.wait_for("deaf")
    program.process.kill()
    assert wait_until(lambda: not any(_is_group_alive(pid) for pid in pids))


def _is_group_alive(group: int) -> bool:
    """Return whether a process of a group runs; a zombie does not count."""
    if shutil.which("ps") is None:
        pytest.skip("the command ps is not here: apt-get install procps")
    listed = subprocess.run(
        ["ps", "-eo", "pgid=,stat="], capture_output=True, text=True, check=True
    )
    rows = (line.split() for line in listed.stdout.splitlines())
    return any(int(found) == group and not state.startswith("Z") for found, state in rows)


def test_sigterm_ends_the_launch_as_ctrl_c_does(launch: Callable[..., Program]) -> None:
    program = launch("Node(package='zbot', executable='talker')")
    program.wait_for("Publishing")
    assert program.stop(signal.SIGTERM) == 0
    assert "[INFO] [talker-1]: process has finished cleanly" in program.output


def test_respawn_starts_again_until_ctrl_c(launch: Callable[..., Program]) -> None:
    program = launch("python('print(\"again\")', name='r', respawn=True, respawn_delay=0.05)")
    pids = {pid_in(program.wait_for("[INFO] [r-1]: process started with pid [")) for _ in range(3)}
    assert len(pids) == 3
    assert program.stop() == 0


def test_respawn_ends_after_its_retries(launch: Callable[..., Program]) -> None:
    program = launch(
        "python('raise SystemExit(1)', name='r', respawn='true', respawn_max_retries=2)"
    )
    assert program.wait() == 1
    assert program.output.count("process started") == 3


def test_event_handlers_run_their_actions(launch: Callable[..., Program]) -> None:
    program = launch(
        """
        (first := python('print("ready")', name='first')) and first,
        RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg='begun')])),
        RegisterEventHandler(OnProcessIO(
            target_action=first,
            on_stdout=lambda event: LogInfo(msg='read ' + event.text.decode().strip()))),
        RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[
            LogInfo(msg=['exit ', LocalSubstitution('event.returncode')]),
            TimerAction(period=0.05, actions=[EmitEvent(event=ShutdownEvent(reason='done'))])])),
        RegisterEventHandler(OnShutdown(
            on_shutdown=lambda event, context: [LogInfo(msg='bye ' + event.reason)])),
        python('import time; time.sleep(60)', name='second'),
        """
    )
    assert program.wait() == 0
    said = re.findall(r"\[launch.user\]: (.*)", program.output)
    assert [line for line in said if line != "read "] == [
        "begun",
        "read ready",
        "exit 0",
        "bye done",
    ]


def test_a_process_can_be_signalled_and_written_to(launch: Callable[..., Program]) -> None:
    program = launch(
        """
        (cat := ExecuteProcess(cmd=['cat'], name='cat')) and cat,
        RegisterEventHandler(OnProcessStart(target_action=cat, on_start=lambda event, context: [
            OpaqueFunction(function=lambda context: cat.process_details and None),
            TimerAction(period=0.05, actions=[EmitEvent(event=SignalProcess(
                signal_number='SIGTERM', process_matcher=matches_action(cat)))])])),
        """
    )
    assert program.wait() == 0
    assert "[INFO] [cat-1]: sending signal 'SIGTERM' to process[cat-1]" in program.output


def test_an_exit_code_after_ctrl_c_is_not_a_failure(launch: Callable[..., Program]) -> None:
    code = "import signal, sys, time; signal.signal(2, lambda *_: sys.exit(4)); print('on'); "
    program = launch(f"python({code + 'time.sleep(60)'!r}, name='odd')")
    program.wait_for("[odd-1] on")
    assert program.stop() == 0
    assert "process has died [pid" in program.output
    assert "exit code 4" in program.output
