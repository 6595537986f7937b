"""Tests of `zbot service` with running nodes; the output equals that of ros2."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.conftest import allowed
from zbot.node.service_introspection import ServiceIntrospectionState

from example_interfaces.srv import AddTwoInts
from std_srvs.srv import SetBool, Trigger

if TYPE_CHECKING:
    from tests.cli.conftest import Command
    from tests.conftest import MakeContext, Spin, Start

WAITING = "waiting for service to become available...\n"
NODE_SERVICES = """\
/minimal_service/describe_parameters [rcl_interfaces/srv/DescribeParameters]
/minimal_service/get_parameter_types [rcl_interfaces/srv/GetParameterTypes]
/minimal_service/get_parameters [rcl_interfaces/srv/GetParameters]
/minimal_service/get_type_description [type_description_interfaces/srv/GetTypeDescription]
/minimal_service/list_parameters [rcl_interfaces/srv/ListParameters]
/minimal_service/set_parameters [rcl_interfaces/srv/SetParameters]
/minimal_service/set_parameters_atomically [rcl_interfaces/srv/SetParametersAtomically]
"""


def switch(request: Any, response: Any) -> Any:
    response.success = request.data
    response.message = "on" if request.data else "off"
    return response


def break_down(request: Any, response: Any) -> Any:  # noqa: ARG001 - what a service calls
    raise RuntimeError("the motor is hot")


@pytest.fixture
def node(make_context: MakeContext, spin: Spin) -> library.Node:
    """Return the node of the recordings, /minimal_service with /set_bool, and more services."""
    node = library.Node("minimal_service", context=make_context())
    node.create_service(SetBool, "set_bool", switch)
    node.create_service(Trigger, "break_down", break_down)
    node.create_service(Trigger, "_secret", break_down)
    spin(node)
    return node


# -- looking -------------------------------------------------------------------------------------


@pytest.mark.usefixtures("node")
def test_list_leaves_out_the_services_of_every_node(zbot_command: Command) -> None:
    assert zbot_command("service", "list").out == "/break_down\n/set_bool\n"
    assert zbot_command("service", "list", "-t").out == (
        "/break_down [std_srvs/srv/Trigger]\n/set_bool [std_srvs/srv/SetBool]\n"
    )
    assert zbot_command("service", "list", "-c").out == "2\n"
    assert json.loads(zbot_command("service", "list", "--json").out)[1] == {
        "name": "/set_bool",
        "types": ["std_srvs/srv/SetBool"],
        "server_count": 1,
        "client_count": 0,
    }


@pytest.mark.parametrize(
    "words",
    [["list", "-a"], ["list", "--include-hidden-services"], ["--include-hidden-services", "list"]],
)
@pytest.mark.usefixtures("node")
def test_list_shows_all_services_with_the_option(zbot_command: Command, words: list[str]) -> None:
    assert zbot_command("service", *words, "-t").out == (
        "/_secret [std_srvs/srv/Trigger]\n"
        "/break_down [std_srvs/srv/Trigger]\n"
        f"{NODE_SERVICES}"
        "/set_bool [std_srvs/srv/SetBool]\n"
    )


@pytest.mark.usefixtures("domain")
def test_a_list_is_empty_in_an_empty_domain(zbot_command: Command) -> None:
    for words in (["list"], ["list", "-a"], ["find", "std_srvs/srv/Empty"]):
        done = zbot_command("service", *words)
        assert (done.code, done.out, done.err) == (0, "", "")


@pytest.mark.usefixtures("node")
def test_type_info_and_find_print_the_output_of_ros2(zbot_command: Command) -> None:
    assert zbot_command("service", "type", "/set_bool").out == "std_srvs/srv/SetBool\n"
    assert zbot_command("service", "type", "_secret").out == "std_srvs/srv/Trigger\n"
    assert zbot_command("service", "info", "/set_bool").out == (
        "Type: std_srvs/srv/SetBool\nClients count: 0\nServices count: 1\n"
    )
    assert zbot_command("service", "find", "std_srvs/srv/SetBool").out == "/set_bool\n"
    assert zbot_command("service", "find", "std_srvs/Trigger").out == "/break_down\n"
    assert zbot_command("service", "find", "std_srvs/srv/Trigger", "-ac").out == "2\n"
    assert json.loads(zbot_command("service", "find", "std_srvs/Trigger", "--json").out) == [
        "/break_down"
    ]


def test_info_shows_every_endpoint(node: library.Node, zbot_command: Command) -> None:
    node.create_client(SetBool, "set_bool")
    text = zbot_command("service", "info", "set_bool", "--verbose").out
    endpoint = (
        r"Node name: minimal_service\nNode namespace: /\nService type: std_srvs/srv/SetBool\n"
        r"Service type hash: RIHS01_[0-9a-f]{64}\nEndpoint type: {}\nEndpoint count: 1\n"
        r"GID: ([0-9a-f]{2}\.){15}[0-9a-f]{2}\nQoS profile:\n  Reliability: RELIABLE\n"
        r"  History \(Depth\): KEEP_LAST \(10\)\n  Durability: VOLATILE\n  Lifespan: Infinite\n"
        r"  Deadline: Infinite\n  Liveliness: AUTOMATIC\n"
        r"  Liveliness lease duration: Infinite\n\n"
    )
    head = r"Type: std_srvs/srv/SetBool\nClients count: 1\nServices count: 1\n"
    ends = (endpoint.replace("{}", side) for side in ("CLIENT", "SERVER"))
    assert re.fullmatch(head + "".join(ends), text)
    found = json.loads(zbot_command("service", "info", "/set_bool", "--json").out)
    assert [end["node"] for end in found["clients"]] == ["/minimal_service"]


@pytest.mark.parametrize("verb", ["info", "type"])
@pytest.mark.usefixtures("node")
def test_an_unknown_name_suggests_the_nearest(zbot_command: Command, verb: str) -> None:
    done = zbot_command("service", verb, "/set_bol")
    assert (done.code, done.out) == (1, "")
    assert done.err == "Unknown service '/set_bol'\n\nhint: did you mean '/set_bool'?\n"


# -- calling -------------------------------------------------------------------------------------


@pytest.mark.usefixtures("node")
def test_a_call_prints_the_output_of_ros2() -> None:
    done = zbot("service", "call", "/set_bool", "std_srvs/srv/SetBool", "{data: true}")
    assert (done.code, done.err) == (0, "")
    assert done.out == (
        f"{WAITING}"
        "requester: making request: std_srvs.srv.SetBool_Request(data=True)\n\n"
        "response:\nstd_srvs.srv.SetBool_Response(success=True, message='on')\n\n"
    )


@pytest.mark.parametrize(
    "words",
    [
        ["{data: true}"],
        ["std_srvs.srv.SetBool", "data=true"],
        ["std_srvs/SetBool", '{"data": true}'],
    ],
)
@pytest.mark.usefixtures("node")
def test_the_type_can_be_short_or_left_out(zbot_command: Command, words: list[str]) -> None:
    done = zbot_command("service", "call", "set_bool", *words, "--json")
    assert (done.code, done.err) == (0, "")
    assert json.loads(done.out) == {
        "request": {"data": True},
        "response": {"success": True, "message": "on"},
    }


@pytest.mark.usefixtures("node")
def test_values_are_read_from_standard_input() -> None:
    done = zbot("service", "call", "/set_bool", "--stdin", stdin="data: true\n")
    assert "SetBool_Request(data=True)" in done.out


@pytest.mark.usefixtures("node")
def test_an_exception_of_the_server_is_one_sentence(zbot_command: Command) -> None:
    done = zbot_command("service", "call", "/break_down")
    assert done.code == 1
    assert done.err == "/break_down: the motor is hot\n"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["/set_bool", "std_srvs/srv/Nope"], "The passed service type is invalid\n"),
        (["/set_bool", "std_msgs/msg/String"], "The passed type is not a service\n"),
        (
            ["/set_bool", "std_srvs/srv/Trigger"],
            "Service '/set_bool' has the type std_srvs/srv/SetBool, not std_srvs/srv/Trigger\n",
        ),
        (["/set_bool", "{dta: true}"], "Failed to populate field: "),
        (["/set_bool", "yes"], "The passed value needs to be a dictionary in YAML format\n"),
        (["/set_bool", "--rate", "0"], "rate must be greater than zero\n"),
    ],
)
@pytest.mark.usefixtures("node")
def test_mistakes_fail_at_once(zbot_command: Command, words: list[str], sentence: str) -> None:
    done = zbot_command("service", "call", *words)
    assert done.code == 1
    assert done.err.startswith(sentence)


@pytest.mark.usefixtures("node")
def test_a_call_of_a_wrong_name_suggests_the_nearest(zbot_command: Command) -> None:
    done = zbot_command("service", "call", "/set_bol", "--timeout", "0.2")
    assert (done.code, done.out) == (1, WAITING)
    assert done.err == (
        "hint: did you mean '/set_bool'?\n"
        "Service '/set_bol' is not available after waiting 0.2 seconds\n"
    )


SLEEPER = """
import threading, zbot
from std_srvs.srv import Trigger
zbot.init()
node = zbot.Node("sleeper")
def sleep(request, response):
    print("asleep", flush=True)
    threading.Event().wait(30)
    return response
node.create_service(Trigger, "sleep", sleep)
print("ready", flush=True)
zbot.spin(node)
"""


def test_a_server_that_does_not_answer_in_time_is_reported(start: Start) -> None:
    start(source=SLEEPER).wait_for("ready")
    done = zbot("service", "call", "/sleep", "--timeout", "1.5")
    assert done.code == 1
    assert done.err == "Service '/sleep' did not respond within 1.5 seconds\n"


def test_a_server_that_is_killed_ends_the_call(start: Start) -> None:
    server = start(source=SLEEPER)
    server.wait_for("ready")
    caller = start("zbot", "service", "call", "/sleep")
    server.wait_for("asleep")
    server.process.kill()
    assert caller.wait() == 1
    assert caller.lines[-1] == "/sleep: the server ended before it answered"


def test_a_call_waits_for_its_server_and_repeats(
    start: Start, make_context: MakeContext, spin: Spin
) -> None:
    caller = start("zbot", "service", "call", "/set_bool", "{data: true}", "--rate", "20")
    caller.wait_for(WAITING.strip())
    node = library.Node("late", context=make_context())
    node.create_service(SetBool, "set_bool", switch)
    spin(node)
    for _ in range(3):
        caller.wait_for("requester: making request: std_srvs.srv.SetBool_Request(data=True)")
        caller.wait_for("std_srvs.srv.SetBool_Response(success=True, message='on')")
    assert caller.stop() == 130
    assert "Traceback" not in caller.output


def test_a_wait_for_a_server_that_does_not_come_is_explained(start: Start) -> None:
    caller = start("zbot", "service", "call", "/nope", "std_srvs/srv/SetBool")
    caller.wait_for("nobody serves /nope; no node is running")


def test_ctrl_c_ends_the_wait_without_output(start: Start) -> None:
    caller = start("zbot", "service", "call", "/nope", "std_srvs/srv/SetBool", "{data: true}")
    caller.wait_for(WAITING.strip())
    assert caller.stop() == 130
    assert caller.output == WAITING.strip()


# -- listening to calls --------------------------------------------------------------------------


def event_text(step: str, request: str, response: str) -> str:
    return (
        rf"info:\n  event_type: {step}\n  stamp:\n    sec: \d+\n    nanosec: \d+\n"
        rf"  client_gid: \[\d+(, \d+){{15}}\]\n  sequence_number: 1\n"
        rf"request: {request}\nresponse: {response}\n---\n"
    )


def test_echo_prints_the_output_of_ros2(
    make_context: MakeContext, spin: Spin, start: Start
) -> None:
    node = library.Node("introspected", context=make_context())
    service = node.create_service(AddTwoInts, "add_two_ints", sum_up)
    client = node.create_client(AddTwoInts, "add_two_ints")
    for end in (service, client):
        end.configure_introspection(
            node.get_clock(), library.QoSProfile(depth=10), ServiceIntrospectionState.CONTENTS
        )
    spin(node)
    echo = start("zbot", "service", "echo", "--flow-style", "/add_two_ints")
    assert node.context.graph.wait_for(
        lambda graph: bool(graph.subscriptions("/add_two_ints/_service_event")), 10
    )
    client.call(AddTwoInts.Request(a=2, b=3))
    echo.wait_for("RESPONSE_RECEIVED")
    echo.wait_for("---")
    assert echo.stop() == 130
    steps = [
        event_text("REQUEST_SENT", r"\[\{a: 2, b: 3\}\]", r"\[\]"),
        event_text("REQUEST_RECEIVED", r"\[\{a: 2, b: 3\}\]", r"\[\]"),
        event_text("RESPONSE_SENT", r"\[\]", r"\[\{sum: 5\}\]"),
        event_text("RESPONSE_RECEIVED", r"\[\]", r"\[\{sum: 5\}\]"),
    ]
    assert re.fullmatch("".join(steps), echo.output + "\n")


def sum_up(request: Any, response: Any) -> Any:
    response.sum = request.a + request.b
    return response


@pytest.mark.usefixtures("node")
def test_echo_explains_why_no_events_may_come(start: Start) -> None:
    echo = start("zbot", "service", "echo", "/set_bool")
    echo.wait_for(
        "No publishers on topic '/set_bool/_service_event'; is service introspection on the client "
        "or server enabled?"
    )
    assert echo.stop() == 130
    nobody = start("zbot", "service", "echo", "/set_bol")
    nobody.wait_for("waiting for /set_bol to appear; did you mean '/set_bool'?")
    assert nobody.stop() == 130


# -- completing ----------------------------------------------------------------------------------


@pytest.mark.usefixtures("node")
def test_names_types_and_requests_are_completed() -> None:
    def complete(*words: str) -> list[str]:
        command = [sys.executable, "-m", "zbot_cli", "complete", "--", *words]
        return subprocess.run(
            command, capture_output=True, encoding="utf-8", check=True, timeout=allowed(30)
        ).stdout.splitlines()

    assert "/set_bool" in complete("service", "call", "/set")
    assert complete("service", "call", "/set_bool", "std") == ["std_srvs/srv/SetBool"]
    assert complete("service", "call", "/set_bool", "std_srvs/srv/SetBool", "") == [
        """'{"data": false}'"""
    ]
