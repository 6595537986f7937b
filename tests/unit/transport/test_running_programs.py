from __future__ import annotations

import os
from dataclasses import replace
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest

from zbot.transport import membership, router_process, running_programs
from zbot.transport.membership import Membership
from zbot.transport.running_programs import Registration, RunningProgram

if TYPE_CHECKING:
    from pathlib import Path

STUDENT = Membership(
    "student", "10.0.0.1", 7447, class_name="Robots", number=17, user="student17", secret="s3"
)
TEACHER = replace(STUDENT, role="teacher", number=0, user="teacher")
INSIDE = RunningProgram(
    pid=1,
    space="here",
    command="talker",
    domain=17,
    is_tool=False,
    in_class=True,
    class_name="Robots",
    login=membership.login(STUDENT),
    hidden_by="",
    nodes=["/talker"],
)
BEFORE = replace(INSIDE, in_class=False, class_name="", login="", domain=0)


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))


@pytest.mark.parametrize(
    ("program", "joined", "reason"),
    [
        (INSIDE, STUDENT, ""),
        (INSIDE, None, 'it started when this machine was in class "Robots"'),
        (INSIDE, replace(STUDENT, secret="other"), 'it started when this machine was in class'),
        (BEFORE, STUDENT, "it started when this machine was in no class"),
        (BEFORE, replace(STUDENT, user=""), "it started when this machine was in no class"),
        (BEFORE, None, ""),
        (BEFORE, Membership("partner", "10.0.0.1", 7447), ""),
        (replace(INSIDE, domain=7), STUDENT, "it uses domain 7"),
        (replace(INSIDE, domain=7, is_tool=True), STUDENT, ""),
        (replace(INSIDE, login=membership.login(TEACHER)), TEACHER, ""),
        (replace(INSIDE, hidden_by="ZBOT_DISCOVERY_RANGE=OFF"), STUDENT, "ZBOT_DISCOVERY_RANGE="),
        (replace(BEFORE, hidden_by="ZBOT_DISCOVERY_RANGE=OFF"), None, ""),
    ],
)  # fmt: skip
def test_a_program_outside_the_class_has_a_reason(
    program: RunningProgram, joined: Membership | None, reason: str
) -> None:
    assert program.reason(joined).startswith(reason)
    assert bool(program.reason(joined)) == bool(reason)


def test_the_file_has_no_secret_and_is_removed() -> None:
    membership.save(STUDENT)
    registration = Registration(17, is_tool=False)
    registration.add("/talker")
    (path,) = (membership.folder() / "programs").iterdir()
    assert '"/talker"' in path.read_text(encoding="utf-8")
    assert '"s3"' not in path.read_text(encoding="utf-8")
    registration.close()
    registration.close()
    assert not path.exists()


def test_the_file_of_a_killed_program_is_removed_later() -> None:
    Registration(17, is_tool=False).close()
    path = membership.folder() / "programs" / "1-dead.json"
    path.write_text("{}", encoding="utf-8")
    assert running_programs.running() == []
    assert path.exists()  # its program may just have made it
    os.utime(path, (0, 0))
    assert running_programs.running() == []
    assert not path.exists()


def test_without_a_writable_folder_nothing_is_registered() -> None:
    membership.folder().mkdir()
    (membership.folder() / "programs").touch()
    registration = Registration(17, is_tool=False)
    registration.add("/talker")
    registration.close()
    assert running_programs.running() == []


def test_a_stopped_program_is_named_with_its_process(monkeypatch: pytest.MonkeyPatch) -> None:
    programs = [replace(INSIDE, pid=11), replace(INSIDE, pid=12, nodes=["/arm", "/_hidden"])]
    monkeypatch.setattr(running_programs, "running", lambda: programs)
    monkeypatch.setattr(router_process, "is_stopped", lambda pid: pid in {11, 12})
    stopped, text = running_programs.stopped, running_programs.stopped_text
    assert text(stopped(17, {"/arm", "/other"})) == (
        "/arm (process 12) is stopped, e.g. by Ctrl-Z: type `fg` in the terminal, or `kill -9 12`"
    )
    assert text(stopped(17)) == (
        "/talker (process 11); /arm (process 12) are stopped, e.g. by Ctrl-Z: "
        "type `fg` in the terminal, or `kill -9 11 12`"
    )
    assert text(stopped(17, {"/other"})) == text(stopped(0)) == ""
    monkeypatch.setattr(router_process, "is_stopped", lambda _: False)
    assert text(stopped(17)) == ""


def test_nodes_of_other_domains_are_named_with_their_domain(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    programs = [INSIDE, replace(INSIDE, domain=5, nodes=["/arm"]), replace(INSIDE, nodes=["/_x"])]
    monkeypatch.setattr(running_programs, "running", lambda: programs)
    assert running_programs.elsewhere_text(5) == (
        "this machine runs /talker in domain 17: set ZBOT_DOMAIN_ID=17"
    )
    in_class = SimpleNamespace(role="student")
    monkeypatch.setattr(membership, "load", lambda: in_class)
    assert running_programs.elsewhere_text(5) == "this machine runs /talker in domain 17"
    monkeypatch.setattr(running_programs, "running", lambda: programs[:1])
    assert running_programs.elsewhere_text(17) == ""
