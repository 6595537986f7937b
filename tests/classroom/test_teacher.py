"""What a teacher does with a class, with real hubs, on one machine and without root."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from tests.classroom.school import PIN, TALKER, is_linked
from tests.classroom.talk import free_port
from tests.conftest import wait_until
from tests.torture.processes import forget_most_memory, memory_mb, most_memory_mb

if TYPE_CHECKING:
    from pathlib import Path

    from tests.classroom.school import School


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process with the credentials of the student's laptop."""
    return free_domain


def test_class_start_prints_code_address_and_pin(school: School) -> None:
    opened = school.open()
    assert opened["pin"] == PIN
    assert opened["port"] == school.teacher.port
    assert "open at" in school.teacher.succeed("status")


def test_a_pin_is_made_where_none_is_given(school: School) -> None:
    told = school.teacher.succeed("class", "start", "--pin")
    pin = next(line for line in told.splitlines() if line.startswith("PIN: ")).split()[1]
    assert len(pin) == 6
    assert pin.isdigit()


def test_commands_in_a_row_find_the_class_open(school: School) -> None:
    school.open()
    for reader in range(2, 7):  # the hub opens anew at each
        school.teacher.succeed("share", "1", str(reader))


@pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's list of processes")
def test_a_hub_that_opens_anew_gives_the_memory_of_the_former_one_back(school: School) -> None:
    school.open()
    hub = school.teacher.hub_state()["pid"]
    before_mb = memory_mb(hub)
    forget_most_memory(hub)
    for reader in range(2, 7):
        school.teacher.succeed("share", "1", str(reader))
    assert wait_until(lambda: memory_mb(hub) < before_mb + 10)  # 150 MB, if each were kept
    assert most_memory_mb(hub) < 1.5 * before_mb


def test_a_new_period_frees_all_numbers_and_keeps_code_and_pin(
    school: School, tmp_path: Path
) -> None:
    opened = school.open()
    ana = school.join("Ana", "--number", "17")
    roster = tmp_path / "roster.csv"
    roster.write_text("17,Ben\n")
    told = school.teacher.succeed("class", "next", "--students", str(roster))
    assert "1 number of the last period is free again" in told
    assert f"PIN: {PIN}" in told
    assert json.loads(school.teacher.succeed("class", "list", "--json"))["join"] == opened
    assert school.listed() == {}
    assert wait_until(lambda: "does not accept this laptop" in ana.succeed("status"))
    ben = school.join("Ben")
    assert is_linked(ben)
    assert school.listed()[17]["name"] == "Ben"


def test_a_class_goes_on_after_the_teachers_machine_was_switched_off(school: School) -> None:
    school.open()
    school.join("Ana", "--number", "17")
    school.teacher.kill_hub()
    assert "does not run" in school.teacher.zbot("class", "list").err
    again = school.teacher.succeed("class", "start", "Robots")
    assert f"PIN: {PIN}" in again
    assert wait_until(lambda: school.listed()[17]["here"])


def test_code_and_pin_can_be_seen_again_by_the_teacher_alone(school: School) -> None:
    opened = school.open()
    ana = school.join("Ana")
    listed = school.teacher.succeed("class", "list")
    assert f"PIN: {PIN}" in listed
    assert f"zbot join {opened['code'] or opened['host']}" in listed
    assert json.loads(school.teacher.succeed("class", "list", "--json"))["join"] == opened
    assert f"PIN: {PIN}" in school.teacher.succeed("status")
    assert json.loads(school.teacher.succeed("status", "--json"))["join"] == opened
    assert PIN not in ana.succeed("status", "--json")


def test_starting_an_open_class_shows_how_students_join_it(school: School) -> None:
    opened = school.open()
    ana = school.join("Ana")
    assert wait_until(lambda: is_linked(ana))
    for words in ((), ("Robots",), ("Robots", "--pin")):
        assert json.loads(school.teacher.succeed("class", "start", *words, "--json")) == opened
    assert is_linked(ana)


def test_the_rule_about_sensors_is_kept_until_it_changes(school: School) -> None:
    sentence = "The live page publishes no sensors of browsers in this class"
    assert sentence in school.teacher.succeed("class", "start", "Robots", "--no-sensors")
    school.teacher.kill_hub()
    assert sentence in school.teacher.succeed("class", "start")
    assert sentence not in school.teacher.succeed("class", "start", "--sensors")
    assert sentence not in school.teacher.succeed("class", "start")


def test_an_open_class_is_not_replaced(school: School) -> None:
    school.open()
    for words, sentence in (
        (("Painting",), 'this machine has the class "Robots"'),
        (("--port", "7999"), "has another port"),
        (("--pin",), "has another PIN"),
    ):
        refused = school.teacher.zbot("class", "start", *words, ZBOT_PIN="1111")
        assert refused.code == 1
        assert sentence in refused.err
    assert f"PIN: {PIN}" in school.teacher.succeed("status")


def test_a_class_without_a_pin_gets_none_later(school: School) -> None:
    school.teacher.succeed("class", "start", "Robots")
    for has_hub in (True, False):
        refused = school.teacher.zbot("class", "start", "--pin")
        assert refused.code == 1
        assert "has no PIN" in refused.err
        if has_hub:
            school.teacher.kill_hub()


def test_a_class_that_continues_keeps_name_pin_and_port(school: School) -> None:
    school.teacher.succeed("class", "start", "Robots", "--pin", "--port", str(free_port()))
    before = school.teacher.succeed("class", "start", "--json")
    school.teacher.kill_hub()
    assert school.teacher.succeed("class", "start", "--pin", "--json") == before


def test_a_new_pin_leaves_students_in_the_class(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    school.teacher.succeed("class", "start", "--new-pin", ZBOT_PIN="5555")
    assert "wrong PIN" in school._make("Eve").zbot("join", school.address, ZBOT_PIN=PIN).err
    assert wait_until(lambda: school.listed()[17]["here"])
    assert wait_until(lambda: is_linked(ana))
    made = json.loads(school.teacher.succeed("class", "start", "--new-pin", "--json"))["pin"]
    assert made not in {PIN, "5555"}


def test_a_port_in_use_does_not_lose_the_class(school: School) -> None:
    school.open()
    school.teacher.kill_hub()
    with socket.create_server(("0.0.0.0", school.teacher.port)):
        assert school.teacher.zbot("class", "start").code == 1
    assert f"PIN: {PIN}" in school.teacher.succeed("class", "start")


def test_a_teacher_does_not_close_the_class_by_leaving_without_a_question(school: School) -> None:
    school.open()
    refused = school.teacher.zbot("leave")
    assert refused.code == 1
    assert "`zbot class stop`, or `zbot leave --yes`" in refused.err
    assert "is open at" in school.teacher.succeed("status")
    assert "left Robots" in school.teacher.succeed("leave", "--yes")


@pytest.mark.skipif(sys.platform == "win32", reason="needs a terminal of POSIX")
@pytest.mark.parametrize(("answer", "is_open"), [("n", True), ("y", False)])
def test_a_teacher_who_leaves_is_asked(school: School, answer: str, is_open: bool) -> None:
    import pty  # noqa: PLC0415 - not on Windows

    school.open()
    ours, theirs = pty.openpty()
    os.write(ours, f"{answer}\n".encode())
    words = [sys.executable, "-m", "zbot_cli", "leave"]
    env = school.teacher.environment
    done = subprocess.run(words, env=env, stdin=theirs, capture_output=True, check=False)
    assert b'closes the class "Robots"' in done.stdout + done.stderr
    assert done.returncode == is_open
    assert school.teacher.has_joined == is_open
    os.close(ours)
    os.close(theirs)


def test_after_the_class_the_hub_is_gone_and_nothing_listens(school: School) -> None:
    school.open()
    assert "closed" in school.teacher.succeed("class", "stop")
    with socket.socket() as probe:
        assert probe.connect_ex(("127.0.0.1", school.teacher.port)) != 0
    assert not (school.teacher.folder() / "class.json").exists()
    assert "no class is open" in school.teacher.zbot("class", "list").err


def test_a_taken_port_is_reported(school: School) -> None:
    with socket.create_server(("0.0.0.0", school.teacher.port)):
        refused = school.teacher.zbot("class", "start")
    assert refused.code == 1
    assert f"cannot listen on tcp/0.0.0.0:{school.teacher.port}" in refused.err
    assert "joined nothing" in school.teacher.succeed("status")


def test_the_teacher_sees_nodes_and_last_errors(school: School, domain: int) -> None:
    school.open()
    ana = school.join("Ana", "--number", str(domain))
    school.run(ana, TALKER).wait_for("ready")
    assert wait_until(lambda: school.listed()[domain]["last_error"] is not None)
    assert wait_until(lambda: school.listed()[domain]["nodes"] == ["/talker"])
    row = school.listed()[domain]
    assert row["last_error"] == {"node": "talker", "text": "the motor is hot"}
    assert "talker: the motor is hot" in school.teacher.succeed("class", "list")


def test_what_the_teacher_says_is_on_the_terminals_of_nodes_and_in_the_status(
    school: School, domain: int
) -> None:
    school.open()
    ana = school.join("Ana", "--number", str(domain))
    assert wait_until(lambda: school.listed()[domain]["here"])
    program = school.run(ana, TALKER)
    program.wait_for("ready")
    _settle(school, domain)
    assert "sent to 1 student" in school.teacher.succeed("class", "say", "\x1b[2J5 minutes")
    assert "[class]: the teacher says: [2J5 minutes" in program.wait_for("the teacher says")
    late = school.join("Ben")
    assert wait_until(lambda: "5 minutes" in late.succeed("status"))


def _settle(school: School, number: int) -> None:
    """Wait until a student's node is linked with the teacher's hub."""
    assert wait_until(lambda: bool(school.listed()[number]["nodes"]))
