"""Tests of `zbot lifecycle` with managed nodes."""

from __future__ import annotations

import json
import signal
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.conftest import wait_until
from zbot.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from zbot.remote import managed_nodes

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.cli.conftest import Command
    from tests.conftest import MakeContext, Spin, Start


class Robot(LifecycleNode):
    """Managed node whose `on_configure` runs a function of the test."""

    def __init__(self, name: str, context: library.Context) -> None:
        super().__init__(name, context=context)
        self.configuration: Callable[[], TransitionCallbackReturn] | None = None

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self.configuration() if self.configuration else super().on_configure(state)


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin) -> Robot:
    """Return a managed node; run a node that is not managed beside it."""
    context = make_context()
    robot = Robot("lc_talker", context)
    spin(robot, library.Node("plain", context=context))
    return robot


@pytest.fixture
def silent(make_context: MakeContext) -> Robot:
    """Return a managed node that does not spin."""
    return Robot("silent", make_context())


@pytest.mark.usefixtures("robot")
def test_nodes_lists_managed_nodes(make_context: MakeContext) -> None:
    assert zbot("lifecycle", "nodes").out == "/lc_talker\n"
    hidden = Robot("_hidden", make_context())
    assert zbot("lifecycle", "nodes").out == "/lc_talker\n"
    assert zbot("lifecycle", "nodes", "-a").out == "/_hidden\n/lc_talker\n"
    assert zbot("lifecycle", "nodes", "-c").out == "1\n"
    assert json.loads(zbot("lifecycle", "nodes", "--all", "--json").out) == [
        "/_hidden",
        "/lc_talker",
    ]
    hidden.destroy_node()


@pytest.mark.usefixtures("domain")
def test_without_managed_nodes_lists_are_empty() -> None:
    for words in (["nodes"], ["get"]):
        done = zbot("lifecycle", *words)
        assert (done.code, done.out, done.err) == (0, "", "")
    done = zbot("lifecycle", "get", "/lc_talker", "--timeout", "0.1")
    assert (done.code, done.out) == (1, "")
    assert done.err == (
        "Node not found\n\nhint: no node /lc_talker is running; no managed node is running\n"
    )


@pytest.mark.usefixtures("robot")
def test_get_shows_the_state() -> None:
    done = zbot("lifecycle", "get", "/lc_talker")
    assert (done.code, done.out, done.err) == (0, "unconfigured [1]\n", "")
    assert zbot("lifecycle", "get", "lc_talker").out == "unconfigured [1]\n"
    assert zbot("lifecycle", "get").out == "/lc_talker: unconfigured [1]\n"
    assert json.loads(zbot("lifecycle", "get", "--json").out) == {
        "/lc_talker": {"id": 1, "label": "unconfigured"}
    }
    assert json.loads(zbot("lifecycle", "get", "/lc_talker", "--json").out) == {
        "id": 1,
        "label": "unconfigured",
    }


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("/lc_talkr", "no node /lc_talkr is running; did you mean '/lc_talker'?"),
        ("/plan", "no node /plan is running; did you mean '/plain'?"),
        ("/zzz", "no node /zzz is running; managed nodes are /lc_talker"),
        ("/plain", "/plain is running, but it is not a managed node"),
    ],
)
@pytest.mark.parametrize("words", [("get",), ("list",), ("set", "configure")])
def test_an_unknown_node_is_refused(words: tuple[str, ...], name: str, hint: str) -> None:
    done = zbot("lifecycle", words[0], name, *words[1:], "--timeout", "0.1")
    assert (done.code, done.out, done.err) == (1, "", f"Node not found\n\nhint: {hint}\n")


@pytest.mark.usefixtures("robot")
def test_list_shows_the_possible_or_all_transitions() -> None:
    done = zbot("lifecycle", "list", "/lc_talker")
    assert (done.code, done.err) == (0, "")
    assert done.out == (
        "- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n"
        "- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n"
    )
    every = zbot("lifecycle", "list", "/lc_talker", "--all").out
    assert every.count("- ") == 25
    assert "- transition_error [62]\n\tStart: errorprocessing\n\tGoal: finalized\n" in every
    assert json.loads(zbot("lifecycle", "list", "/lc_talker", "--json").out)[0] == {
        "id": 1,
        "label": "configure",
        "start": "unconfigured",
        "goal": "configuring",
    }


@pytest.mark.usefixtures("robot")
def test_set_takes_labels_and_numbers() -> None:
    for transition, state in (("configure", "inactive [2]"), ("3", "active [3]")):
        done = zbot("lifecycle", "set", "/lc_talker", transition)
        assert (done.code, done.out, done.err) == (0, "Transitioning successful\n", "")
        assert zbot("lifecycle", "get", "/lc_talker").out == f"{state}\n"
    assert zbot("lifecycle", "set", "/lc_talker", "shutdown").code == 0
    assert zbot("lifecycle", "get", "/lc_talker").out == "finalized [4]\n"


def test_set_refuses_an_impossible_transition(robot: Robot) -> None:
    robot.trigger_configure()
    done = zbot("lifecycle", "set", "/lc_talker", "bogus")
    assert (done.code, done.out) == (1, "")
    assert done.err == (
        "Unknown transition requested, available ones are:\n"
        "- cleanup [2]\n- activate [3]\n- shutdown [6]\n"
    )
    near = zbot("lifecycle", "set", "/lc_talker", "actvate").err
    assert near.endswith("- shutdown [6]\n\nhint: did you mean 'activate'?\n")
    assert zbot("lifecycle", "set", "/lc_talker", "1").code == 1


def test_set_reports_a_failed_callback(robot: Robot) -> None:
    robot.configuration = lambda: TransitionCallbackReturn.FAILURE
    done = zbot("lifecycle", "set", "/lc_talker", "configure")
    assert (done.code, done.out) == (1, "")
    assert done.err == (
        "Transitioning failed\n\nhint: /lc_talker is unconfigured now; see its log for the reason\n"
    )


@pytest.mark.usefixtures("robot", "silent")
def test_a_node_that_does_not_answer_is_named(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(managed_nodes, "ANSWER_TIMEOUT_S", 3)  # the other node answers in it
    done = zbot_command("lifecycle", "get")
    assert (done.code, done.out) == (1, "/lc_talker: unconfigured [1]\n")
    sentence = (
        "Exception while calling service of node '/silent': no answer in 3 s; does it spin?\n"
    )
    assert done.err == sentence
    done = zbot_command("lifecycle", "set", "/silent", "configure")
    assert (done.code, done.out, done.err) == (1, "", sentence)


@pytest.mark.usefixtures("robot")
def test_tab_completes_managed_nodes_and_transitions() -> None:
    assert zbot("complete", "--", "lifecycle", "get", "").out == "/lc_talker\n"
    assert zbot("complete", "--", "lifecycle", "list", "lc").out == "lc_talker\n"
    assert zbot("complete", "--", "lifecycle", "set", "/lc_talker", "c").out == (
        "cleanup\nconfigure\n"
    )


DYING = """
import os
import zbot
from zbot.lifecycle import LifecycleNode


class Dying(LifecycleNode):
    def on_configure(self, state):
        os.kill(os.getpid(), 9)


with zbot.init():
    node = Dying("dying")
    print("ready", flush=True)
    zbot.spin(node)
"""


def test_a_node_that_dies_in_its_transition_is_named(start: Start) -> None:
    start(source=DYING).wait_for("ready")
    done = zbot("lifecycle", "set", "/dying", "configure")
    assert (done.code, done.out) == (1, "")
    assert done.err == (
        "Exception while calling service of node '/dying': "
        "/dying/change_state: the server ended before it answered\n"
    )


def test_ctrl_c_ends_the_wait_for_a_long_transition(robot: Robot, start: Start) -> None:
    begun: list[Any] = []

    def wait() -> TransitionCallbackReturn:
        begun.append(True)
        wait_until(lambda: len(begun) == 2, 20)
        return TransitionCallbackReturn.SUCCESS

    robot.configuration = wait
    command = start("zbot", "lifecycle", "set", "/lc_talker", "configure")
    assert wait_until(lambda: bool(begun), 10)
    code = command.stop(signal.SIGINT)
    begun.append(True)
    assert (code, command.output) == (130, "")


def test_the_bundled_talker_publishes_while_it_is_active(start: Start) -> None:
    talker = start("zbot", "run", "lifecycle_talker")
    assert zbot("lifecycle", "set", "/lc_talker", "configure", "--timeout", "10").code == 0
    talker.wait_for("on_configure() is called.")
    talker.wait_for("currently inactive")
    talker.wait_for("/lifecycle_chatter was dropped")
    events = start("zbot", "topic", "echo", "/lc_talker/transition_event", "--once")
    chatter = start("zbot", "topic", "echo", "/lifecycle_chatter", "--once")
    assert wait_until(
        lambda: "Subscription count: 1" in zbot("topic", "info", "/lc_talker/transition_event").out
    )
    assert zbot("lifecycle", "set", "/lc_talker", "activate").code == 0
    events.wait_for("label: activate")
    talker.wait_for("Lifecycle publisher is active. Publishing: [Lifecycle HelloWorld #")
    chatter.wait_for("data: 'Lifecycle HelloWorld #")
    assert (events.wait(), chatter.wait()) == (0, 0)
    for transition in ("deactivate", "cleanup", "configure", "shutdown"):
        assert zbot("lifecycle", "set", "/lc_talker", transition).code == 0
    assert zbot("topic", "list").out.count("lifecycle_chatter") == 0
    assert talker.stop() == -signal.SIGINT
