"""Tests of the router process: the sign that the machine is busy, and one killer at a time."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest

from zbot.transport import background_process, membership, router_process

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize(
    ("threads_ms", "begin_s", "is_busy"),
    [
        ([(100, 90), (10, 10)], (0.0, 0.0), False),
        ([(100, 200), (10, 100)], (0.0, 0.0), True),
        ([(2, 40)], (0.0, 0.0), False),  # too short to mean anything
        ([(1000, 3000)], (0.99, 2.96), False),  # the machine was busy earlier
        ([(1000, 300)], (0.99, 0.2), True),
        ([(100, 10)], (0.2, 0.0), False),  # a thread has ended meanwhile
    ],
)
def test_a_machine_is_busy_if_this_process_waits_for_a_processor(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    threads_ms: list[tuple[int, int]],
    begin_s: tuple[float, float],
    *,
    is_busy: bool,
) -> None:
    for number, (ran_ms, waited_ms) in enumerate(threads_ms):
        folder = tmp_path / "self" / "task" / str(number)
        folder.mkdir(parents=True)
        (folder / "schedstat").write_text(f"{ran_ms}000000 {waited_ms}000000 7\n")
    monkeypatch.setattr(router_process, "_PROC", tmp_path)
    assert router_process.is_machine_busy(begin_s) == is_busy


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such figure")
def test_other_systems_have_a_load_average(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(router_process, "_PROC", tmp_path)
    for load, is_busy in ((1.0, False), (1000.0, True)):
        monkeypatch.setattr(os, "getloadavg", lambda load=load: (load, 0.0, 0.0))
        assert router_process.is_machine_busy() == is_busy


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux counts these times")
def test_the_times_of_this_process_are_known() -> None:
    ran_s, waited_s = router_process.processor_times()
    assert ran_s > 0
    assert waited_s >= 0


def test_only_one_program_kills_a_router_and_writes_to_its_file(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    domain, router = 7, 1111
    membership.folder().mkdir(parents=True, exist_ok=True)
    path = background_process.lock_path(f"router-{domain}")
    with (
        path.open("w+") as file,
        background_process.lock_path(f"router-{domain}-end").open("a") as end,
    ):
        assert background_process.lock(file)
        assert background_process.lock(end)  # another program kills the router
        file.write(str(router))
        file.flush()
        ended: list[int] = []
        monkeypatch.setattr(os, "kill", lambda number, _: ended.append(number))
        assert router_process.pid(domain) == router
        assert not router_process.kill(domain, router)
        assert ended == []
        assert path.read_text() == str(router)


def test_a_router_changes_for_a_second_after_its_file_was_written() -> None:
    domain = 8
    membership.folder().mkdir(parents=True, exist_ok=True)
    path = background_process.lock_path(f"router-{domain}")
    assert not router_process.is_changing(domain)
    path.write_text("killed", encoding="utf-8")
    assert router_process.is_changing(domain)
    before_s = time.time() - 2
    os.utime(path, (before_s, before_s))
    assert not router_process.is_changing(domain)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot stop a process")
def test_a_process_is_stopped_until_it_continues() -> None:
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as process:
        assert not router_process.is_stopped(process.pid)
        process.send_signal(signal.SIGSTOP)
        os.waitpid(process.pid, os.WUNTRACED)
        assert router_process.is_stopped(process.pid)
        process.send_signal(signal.SIGCONT)
        process.communicate(b"")
    assert not router_process.is_stopped(process.pid)
