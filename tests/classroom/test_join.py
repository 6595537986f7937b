"""Joining and leaving, with real hubs, on one machine and without root."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

from tests.classroom.local_machine import LocalMachine
from tests.classroom.recording_proxy import RecordingProxy
from tests.classroom.talk import free_port, open_session
from tests.conftest import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.conftest import Program, Start

PIN = "4711"

TALKER = """
import zbot
from std_msgs.msg import String

with zbot.init():
    node = zbot.Node("talker")
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.05, lambda: publisher.publish(String(data="hello")))
    node.get_logger().error("the motor is hot")
    print("ready", flush=True)
    zbot.spin(node)
"""


@pytest.fixture
def machines(tmp_path: Path) -> Iterator[Callable[[str], LocalMachine]]:
    """Return a function that makes machines; whatever they have joined, they leave."""
    made: dict[str, LocalMachine] = {}

    def make(name: str) -> LocalMachine:
        return made.setdefault(name, LocalMachine(tmp_path / name))

    yield make
    for machine in reversed(made.values()):
        if machine.has_joined:
            machine.zbot("leave", "--yes")


class School:
    """A teacher with an open class, and students.

    Args:
        make: Makes machines.
        start: Starts programs.
    """

    def __init__(self, make: Callable[[str], LocalMachine], start: Start) -> None:
        self._make, self._start = make, start
        self.teacher = make("teacher")
        self.address = f"127.0.0.1:{self.teacher.port}"

    def open(self, *words: str) -> dict[str, Any]:
        """Open the class with the PIN; return what `zbot class start` prints."""
        told = self.teacher.succeed(
            "class", "start", "Robots", "--pin", "--json", *words, ZBOT_PIN=PIN
        )
        opened: dict[str, Any] = json.loads(told)
        return opened

    def join(self, name: str, *words: str) -> LocalMachine:
        """Let a student join."""
        student = self._make(name)
        student.succeed("join", self.address, "--name", name, *words, ZBOT_PIN=PIN)
        return student

    def run(self, machine: LocalMachine, source: str, **more: str) -> Program:
        """Start a program on a machine."""
        return self._start(source=source, env={**machine.environment, "ZBOT_DOMAIN_ID": "", **more})

    def listed(self) -> dict[int, dict[str, Any]]:
        """Return the students in the teacher's list, by number."""
        found = json.loads(self.teacher.succeed("class", "list", "--json"))
        return {student["number"]: student for student in found["students"]}


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process with the credentials of the student's laptop."""
    return free_domain


@pytest.fixture
def school(
    machines: Callable[[str], LocalMachine], start: Start, monkeypatch: pytest.MonkeyPatch
) -> School:
    monkeypatch.delenv("ZBOT_DOMAIN_ID")  # a student's domain is his number
    return School(machines, start)


def is_linked(machine: LocalMachine) -> bool:
    """Return whether the hub of a machine is linked with the teacher's."""
    return bool(json.loads(machine.succeed("status", "--json"))["linked"])


# -- joining ---------------------------------------------------------------------------------------


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


def test_commands_in_a_row_find_the_class_open(school: School) -> None:
    school.open()
    for reader in range(2, 7):  # the hub opens anew at each
        school.teacher.succeed("share", "1", str(reader))


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


def test_a_laptop_that_left_while_the_hub_was_reopened_is_not_here(school: School) -> None:
    school.open()
    ana = school.join("Ana", "--number", "17")
    assert wait_until(lambda: school.listed()[17]["here"])
    pid = json.loads((ana.folder() / "hub.json").read_text())["pid"]
    school.teacher.succeed("share", "1", "2")  # the hub is opened anew
    os.kill(pid, getattr(signal, "SIGKILL", signal.SIGTERM))
    assert wait_until(lambda: not school.listed()[17]["here"])
    assert school.listed()[17]["clock_offset"] is None


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
    assert school.teacher.zbot("join", school.address).code == 1


def test_a_class_that_no_longer_runs_does_not_prevent_joining(
    school: School, machines: Callable[[str], LocalMachine]
) -> None:
    school.open()
    ana = school.join("Ana")
    school.teacher.succeed("class", "stop")
    assert wait_until(lambda: not is_linked(ana))
    # Nobody is there, so the old class stays joined.
    assert ana.zbot("join", school.address).code == 1
    assert "Robots" in ana.succeed("status")
    other = machines("other teacher")
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


@pytest.mark.parametrize("words", [(), ("Robots",), ("Robots", "--pin")])
def test_starting_an_open_class_shows_how_students_join_it(
    school: School, words: tuple[str, ...]
) -> None:
    opened = school.open()
    ana = school.join("Ana")
    assert wait_until(lambda: is_linked(ana))
    assert json.loads(school.teacher.succeed("class", "start", *words, "--json")) == opened
    assert is_linked(ana)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("Painting",), 'this machine has the class "Robots"'),
        (("--port", "7999"), "has another port"),
        (("--pin",), "has another PIN"),
    ],
)
def test_an_open_class_is_not_replaced(
    school: School, words: tuple[str, ...], sentence: str
) -> None:
    school.open()
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


def test_a_program_that_is_not_a_hub_is_reported(machines: Callable[[str], LocalMachine]) -> None:
    with socket.create_server(("127.0.0.1", free_port())) as server:
        port = server.getsockname()[1]
        refused = machines("Ana").zbot("join", f"127.0.0.1:{port}")
    assert refused.code == 1
    assert "is not a zbot hub" in refused.err


# -- secrets ---------------------------------------------------------------------------------------


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no file modes")
def test_only_the_user_reads_what_a_class_writes(school: School) -> None:
    school.open()
    ana = school.join("Ana")
    for machine in (school.teacher, ana):
        for path in machine.folder().iterdir():
            assert path.name == "hub.lock" or path.stat().st_mode & 0o077 == 0, path


# -- the lesson ------------------------------------------------------------------------------------


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


def test_a_name_is_never_interpreted(school: School) -> None:
    school.open()
    trap = "$(touch pwned) ../../x\x1b[31m; rm -rf /<script>"
    student = school._make("trap")
    student.succeed("join", school.address, "--name", trap, ZBOT_PIN=PIN)
    (row,) = school.listed().values()
    assert row["name"] == "$(touch pwned) ../../x [31m; rm -rf /<script>"
    assert "\x1b" not in school.teacher.succeed("class", "list")
    assert not list(student.home.parent.rglob("pwned"))
