"""A program that ends without spinning is told so, once, and only if it has callbacks."""

from __future__ import annotations

import sys

import pytest

from zbot.executor import forgotten_spin
from zbot.executor.forgotten_spin import Program, callback_place, note_callback, waiting_text
from zbot.lifecycle.services import LifecycleServices
from zbot.process import at_exit, signals

WARNING = (
    "robot.py:6: create_timer: the callback never ran, because the program ended without "
    "spinning: write {}.spin(node) before its end\n"
)


@pytest.fixture(autouse=True)
def program(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the process be a program that has done nothing yet."""
    flags = dict.fromkeys(("has_spun", "takes_itself", "was_told"), False)
    new = {**flags, "first_callback": "", "pid": 0}
    for name, value in new.items():
        monkeypatch.setattr(Program, name, value)
    monkeypatch.setattr(at_exit, "when_closed", [])
    monkeypatch.setattr(signals._Process, "count", 0)
    monkeypatch.setattr(forgotten_spin, "is_program", lambda: True)
    monkeypatch.setattr(forgotten_spin, "calling_line", lambda: "robot.py:6")
    monkeypatch.setattr(forgotten_spin, "library_name", lambda: "zbot")
    monkeypatch.delattr(sys, "last_value", raising=False)


PLACE = "robot.py:6: create_timer"


def end(*, was_interrupted: bool = False) -> None:
    for function in at_exit.when_closed:
        function(was_interrupted)


def test_the_first_callback_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    note_callback(callback_place("robot", "create_timer", print))
    note_callback(callback_place("robot", "create_subscription", print))
    end()
    assert capsys.readouterr().err == WARNING.format("zbot")


def test_the_services_of_a_lifecycle_node_are_not_named() -> None:
    place = callback_place("robot", "create_service", LifecycleServices.publish_event)
    assert place == "robot.py:6: LifecycleNode"


def test_a_callback_that_waits_is_named_once(capsys: pytest.CaptureFixture[str]) -> None:
    note_callback(PLACE)
    assert waiting_text(PLACE, 10) == (
        "robot.py:6: create_timer: the callback has waited for 10 s, because nothing spins the "
        "node: write zbot.spin(node), and no endless loop before it"
    )
    end()
    assert capsys.readouterr().err == ""


def test_a_callback_beside_a_node_that_spins_needs_the_same_executor() -> None:
    Program.has_spun = True
    assert waiting_text(PLACE, 10).endswith(
        "because nothing spins this node, only another one: give both nodes to one executor with "
        "add_node(), and spin that executor"
    )


def test_a_program_that_takes_its_messages_itself_is_left_alone(
    capsys: pytest.CaptureFixture[str],
) -> None:
    note_callback(PLACE)
    Program.takes_itself = True
    assert callback_place("robot", "create_timer", print) == waiting_text(PLACE, 10) == ""
    end()
    assert capsys.readouterr().err == ""


def test_a_program_that_has_spun_is_left_alone(capsys: pytest.CaptureFixture[str]) -> None:
    note_callback(PLACE)
    Program.has_spun = True
    end()
    assert capsys.readouterr().err == ""


def test_a_callback_after_spinning_is_not_noted() -> None:
    Program.has_spun = True
    note_callback(PLACE)
    assert at_exit.when_closed == []


@pytest.mark.parametrize("node", ["_ros2cli_1", "_hidden"])
def test_nodes_of_tools_are_left_alone(node: str) -> None:
    assert callback_place(node, "create_timer", print) == ""


def test_a_program_that_a_signal_ends_is_left_alone(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    note_callback(PLACE)
    end(was_interrupted=True)
    monkeypatch.setattr(signals._Process, "count", 1)
    end()
    assert capsys.readouterr().err == ""


def test_a_program_that_failed_shows_only_its_error(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    note_callback(PLACE)
    monkeypatch.setattr(sys, "last_value", ValueError("my own"), raising=False)
    end()
    assert capsys.readouterr().err == ""


def test_a_forked_child_is_not_told_about_callbacks_of_its_parent(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    note_callback(PLACE)
    monkeypatch.setattr("os.getpid", lambda: -1)
    end()
    assert capsys.readouterr().err == ""
