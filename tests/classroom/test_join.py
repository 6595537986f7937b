"""Joining and leaving, with real hubs, on one machine and without root."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.classroom.school import PIN, is_linked
from tests.classroom.talk import free_port
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.classroom.local_machine import LocalMachine
    from tests.classroom.school import School


def test_students_get_numbers_and_the_teacher_sees_them(school: School) -> None:
    school.open()
    school.join("Ana", "--number", "17")
    ben = school.join("Ben")
    assert wait_until(lambda: all(row["here"] for row in school.listed().values()))
    rows = school.listed()
    assert {number: row["name"] for number, row in rows.items()} == {1: "Ben", 17: "Ana"}
    assert rows[1]["version"]
    assert abs(rows[1]["clock_offset"]) < 1
    assert 'Ben, number 1 in "Robots"' in ben.succeed("status")
    assert wait_until(lambda: is_linked(ben))


def test_the_pin_may_come_from_standard_input(school: School) -> None:
    school.open()
    student = school._make("Ana")
    student.succeed("join", school.address, stdin=f"{PIN}\n")
    assert "number 1" in student.succeed("status")


@pytest.mark.parametrize(
    ("pin", "sentence"), [("0000", "wrong PIN"), ("", "the class requires a PIN")]
)
def test_without_the_pin_nobody_joins(school: School, pin: str, sentence: str) -> None:
    school.open()
    student = school._make("Eve")
    refused = student.zbot("join", school.address, ZBOT_PIN=pin)
    assert refused.code == 1
    assert sentence in refused.err
    assert "joined nothing" in student.succeed("status")
    assert not student.has_joined


def test_a_taken_number_is_refused_with_the_holders_name(school: School) -> None:
    school.open()
    school.join("Ana", "--number", "17")
    eve = school._make("Eve")
    refused = eve.zbot("join", school.address, "--number", "17", ZBOT_PIN=PIN)
    assert refused.code == 1
    assert "number 17 is taken by Ana" in refused.err
    assert "Ana had it" in school.teacher.succeed("class", "free", "17")
    eve.succeed("join", school.address, "--number", "17", ZBOT_PIN=PIN)


def test_a_list_of_students_keeps_numbers_for_names(school: School, tmp_path: Path) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text("number,name\n7,Ana\n9,Ben\n")
    school.open("--students", str(roster))
    school.join("ana")
    assert school.listed()[7]["name"] == "Ana"
    assert "9  Ben" in school.teacher.succeed("class", "list")


def test_a_name_one_letter_off_is_a_question(school: School, tmp_path: Path) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text("7,Ana\n9,Ben\n")
    school.open("--students", str(roster))
    student = school._make("Anna")
    join = ("join", school.address, "--name", "Anna")
    refused = student.zbot(*join, ZBOT_PIN=PIN)
    assert refused.code == 1
    assert 'no "Anna", but "Ana": type --name "Ana", or add --new-student' in refused.err
    assert school.listed() == {}
    student.succeed(*join, "--new-student", ZBOT_PIN=PIN)
    assert school.listed()[1]["name"] == "Anna"


@pytest.mark.skipif(sys.platform == "win32", reason="needs a terminal of POSIX")
def test_a_student_answers_the_question_on_a_terminal(school: School, tmp_path: Path) -> None:
    import pty  # noqa: PLC0415 - not on Windows

    roster = tmp_path / "roster.csv"
    roster.write_text("7,Ana\n")
    school.open("--students", str(roster))
    student = school._make("Anna")
    ours, theirs = pty.openpty()
    os.write(ours, b"y\n")
    words = [sys.executable, "-m", "zbot_cli", "join", school.address, "--name", "Anna"]
    env = {**student.environment, "ZBOT_PIN": PIN}
    done = subprocess.run(words, env=env, stdin=theirs, capture_output=True, check=False)
    assert b"Are you Ana?" in done.stdout + done.stderr
    assert b"Ana, you are number 7" in done.stdout
    os.close(ours)
    os.close(theirs)


def test_a_copied_laptop_gets_a_number_of_its_own(school: School) -> None:
    school.open()
    first = school.join("Ana")
    assert wait_until(lambda: school.listed()[1]["here"])
    copy = school._make("copy")
    copy.folder().mkdir(parents=True)
    (copy.folder() / "machine").write_bytes((first.folder() / "machine").read_bytes())
    copy.succeed("join", school.address, "--name", "Ben", ZBOT_PIN=PIN)
    rows = school.listed()
    assert {number: row["name"] for number, row in rows.items()} == {1: "Ana", 2: "Ben"}
    assert (copy.folder() / "machine").read_bytes() != (first.folder() / "machine").read_bytes()


@pytest.mark.parametrize(
    ("variable", "value", "sentence"),
    [
        ("ROS_DOMAIN_ID", "7", "ROS_DOMAIN_ID=7 is ignored"),
        ("ZBOT_DISCOVERY_RANGE", "WORLD", "use LOCALHOST, SUBNET or OFF"),
    ],
)
def test_joining_tells_what_the_environment_says_against_it(
    school: School, monkeypatch: pytest.MonkeyPatch, variable: str, value: str, sentence: str
) -> None:
    school.open()
    monkeypatch.setenv(variable, value)
    joined = school._make("Ana").zbot("join", school.address, ZBOT_PIN=PIN)
    assert joined.code == 0
    assert sentence in joined.err


def test_a_number_changes_hands_while_the_others_stay_linked(school: School) -> None:
    school.open()
    ben = school.join("Ben", "--number", "18")
    opened_ns = school.teacher.hub_state()["started_ns"]
    for name in ("Ana", "Cem", "Dora"):
        student = school.join(name, "--number", "17")
        assert is_linked(student)
        assert school.listed()[17]["name"] == name
        student.succeed("leave")
    assert is_linked(ben)
    assert school.teacher.hub_state()["started_ns"] == opened_ns


def test_a_number_may_have_many_owners(school: School) -> None:
    school.open()
    opened_ns = school.teacher.hub_state()["started_ns"]
    for name in ("Ana", "Ben", "Cem"):  # the hub knows two owners of such a high number
        student = school.join(name, "--number", "200")
        assert is_linked(student)
        student.succeed("leave")
    assert school.teacher.hub_state()["started_ns"] != opened_ns


def test_two_students_with_the_same_name_are_told(school: School) -> None:
    school.open()
    first = school.join("Ana", "--number", "17")
    second = school._make("other")
    joined = second.zbot("join", school.address, "--name", "Ana", "--number", "18", ZBOT_PIN=PIN)
    assert joined.code == 0
    assert 'number 17 of the class has the name "Ana" too' in joined.err
    assert 'number 18 of the class has the name "Ana" too' in first.succeed("status")


def test_leaving_releases_the_number(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    assert "left Robots" in ana.succeed("leave")
    assert school.listed() == {}
    assert ana.zbot("leave").code == 1
    school.join("Ben", "--number", "17")


def test_a_machine_joins_one_class_at_a_time(school: School) -> None:
    school.open()
    ana = school.join("Ana")
    refused = ana.zbot("join", school.address, ZBOT_PIN=PIN)
    assert refused.code == 1
    assert "has joined Robots: leave first" in refused.err
    refused = school.teacher.zbot("join", school.address)
    assert refused.code == 1
    assert "this machine has opened the class Robots" in refused.err


def test_a_program_that_is_not_a_hub_is_reported(
    make_machine: Callable[[str], LocalMachine],
) -> None:
    with socket.create_server(("127.0.0.1", free_port())) as server:
        port = server.getsockname()[1]
        refused = make_machine("Ana").zbot("join", f"127.0.0.1:{port}")
    assert refused.code == 1
    assert "is not a zbot hub" in refused.err


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no file modes")
def test_only_the_user_reads_what_a_class_writes(school: School) -> None:
    school.open()
    ana = school.join("Ana")
    for machine in (school.teacher, ana):
        for path in machine.folder().iterdir():
            assert path.name == "hub.lock" or path.stat().st_mode & 0o077 == 0, path


def test_a_name_is_never_interpreted(school: School) -> None:
    school.open()
    trap = "$(touch pwned) ../../x\x1b[31m; rm -rf /<script>"
    student = school._make("trap")
    student.succeed("join", school.address, "--name", trap, ZBOT_PIN=PIN)
    (row,) = school.listed().values()
    assert row["name"] == "$(touch pwned) ../../x [31m; rm -rf /<script>"
    assert "\x1b" not in school.teacher.succeed("class", "list")
    assert not list(student.home.parent.rglob("pwned"))
