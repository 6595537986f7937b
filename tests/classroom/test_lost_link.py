"""Laptops and classes whose link is lost, with real hubs, on one machine and without root."""

from __future__ import annotations

import json
import os
import signal
import sys
from typing import TYPE_CHECKING

import pytest

from tests.classroom.recording_proxy import RecordingProxy
from tests.classroom.school import PIN, TALKER, is_linked
from tests.classroom.talk import open_session
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.local_machine import LocalMachine
    from tests.classroom.school import School


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process with the credentials of the student's laptop."""
    return free_domain


def test_a_laptop_that_left_while_the_hub_was_reopened_is_not_here(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    assert wait_until(lambda: school.listed()[17]["here"])
    pid = json.loads((ana.folder() / "hub.json").read_text())["pid"]
    school.teacher.succeed("share", "1", "2")  # the hub is opened anew
    os.kill(pid, getattr(signal, "SIGKILL", signal.SIGTERM))
    assert wait_until(lambda: not school.listed()[17]["here"])
    assert school.listed()[17]["clock_offset"] is None


def test_a_class_that_no_longer_runs_does_not_prevent_joining(
    school: School, make_machine: Callable[[str], LocalMachine]
) -> None:
    school.open()
    ana = school.join("Ana")
    school.teacher.succeed("class", "stop")
    assert wait_until(lambda: not is_linked(ana))
    # Nobody is there, so the old class stays joined.
    assert ana.zbot("join", school.address).code == 1
    assert "Robots" in ana.succeed("status")
    other = make_machine("other teacher")
    other.succeed("class", "start", "Next week")
    assert 'joined "Next week"' in ana.succeed("join", f"127.0.0.1:{other.port}")


def test_a_laptop_that_was_switched_off_joins_again(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    ana.kill_hub()
    assert "the hub of this machine is not running" in ana.succeed("status")
    ana.succeed("join", school.address, ZBOT_PIN=PIN)
    assert "number 17" in ana.succeed("status")


def test_a_laptop_that_was_switched_off_goes_on(school: School, domain: int) -> None:
    school.open()
    ana = school.join("Ana", "--number", str(domain))
    ana.kill_hub()
    listed = ana.zbot("node", "list")
    assert listed.code == 0
    assert "the hub of this machine is not running" in listed.err
    assert "`zbot join` starts it again" in listed.err
    program = school.run(ana, TALKER)
    program.wait_for("the hub of this machine is not running")
    assert "linked" in ana.succeed("join").splitlines()
    assert wait_until(lambda: school.listed()[domain]["nodes"] == ["/talker"])
    assert "linked" in ana.succeed("join").splitlines()  # nothing has to be done


def test_there_is_nothing_to_continue_without_a_class(school: School) -> None:
    stranger = school._make("Eve").zbot("join")
    assert stranger.code == 1
    assert "has not joined anything: join with `zbot join CODE`" in stranger.err
    assert school._make("Eve").zbot("join", "--name", "Eve").code == 2
    school.open()
    teacher = school.teacher.zbot("join")
    assert teacher.code == 1
    assert "`zbot class start` shows or continues it" in teacher.err


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not suspend processes")
def test_a_suspended_class_is_not_taken_for_a_refusal(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    pid = school.teacher.hub_state()["pid"]
    os.kill(pid, signal.SIGSTOP)
    try:
        assert wait_until(lambda: not is_linked(ana))
        unknown = "the other machine does not answer at the moment"
        assert wait_until(lambda: unknown in ana.succeed("status"))
        assert "leave" not in ana.succeed("status")
        refused = school._make("Ben").zbot("join", school.address, ZBOT_PIN=PIN)
        assert refused.code == 1
        assert "does not answer: it is busy or suspended" in refused.err
        assert not school._make("Ben").has_joined
        assert "the class does not answer" in ana.zbot("leave").err
    finally:
        os.kill(pid, signal.SIGCONT)


def test_a_freed_laptop_is_told_what_to_do(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    assert wait_until(lambda: school.listed()[17]["here"])
    freed = school.teacher.succeed("class", "free", "17")
    assert "number 17 is free; Ana had it" in freed
    assert "was connected, and is out of the class now" in freed
    told = ana.succeed("status")
    assert "the class does not accept this laptop" in told
    assert "type `zbot leave`, and join again" in told
    assert ana.zbot("leave").err == ""


@pytest.mark.parametrize("link", ["class", "router"])
def test_a_link_that_comes_back_at_once_does_not_hide_nodes(
    school: School, domain: int, link: str
) -> None:
    school.teacher.succeed("class", "start", "Robots")
    proxy = RecordingProxy(school.teacher.port)
    ana = school._make("Ana")
    ana.succeed("join", f"127.0.0.1:{proxy.port}", "--number", str(domain))
    school.run(ana, TALKER).wait_for("ready")
    assert wait_until(lambda: school.listed()[domain]["nodes"] == ["/talker"])
    for _ in range(3):
        # The hub of the laptop, or of the class, has another change within 0.1 s.
        port = ana.port if link == "router" else school.teacher.port
        paths = {"mode": "router", "connect/endpoints": [f"tcp/127.0.0.1:{port}"]}
        open_session({**paths, "listen/endpoints": []}).close()
        proxy.cut()
        assert wait_until(lambda: school.listed()[domain]["nodes"] == ["/talker"], 20)
        assert wait_until(lambda: is_linked(ana), 20)
    proxy.close()
