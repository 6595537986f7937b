"""Tests of the services in the lessons: the bundled nodes and the command lines."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from tests.conftest import Program, Start

WAITING = "waiting for service to become available...\n"
SUM = (
    "requester: making request: example_interfaces.srv.AddTwoInts_Request(a=5, b=3)\n\n"
    "response:\nexample_interfaces.srv.AddTwoInts_Response(sum=8)\n\n"
)


@pytest.fixture
def server(start: Start) -> Program:
    """The bundled server, once the others can see it."""
    program = start("zbot", "run", "add_two_ints_server")
    asking = start("zbot", "run", "add_two_ints_client", "1", "2")
    asking.wait_for("Result of add_two_ints: for 1 + 2 = 3")
    asking.wait()
    program.wait_for("1 + 2 = 3")
    return program


def test_the_server_and_the_client_say_what_the_lesson_says(server: Program, start: Start) -> None:
    log = r"\[INFO\] \[\d+\.\d{9}\] \[service_node\]: 1 \+ 2 = 3"
    assert re.fullmatch(log, server.lines[-1])
    asking = start("zbot", "run", "demo_nodes_py", "add_two_ints_client", "4", "-5")
    asking.wait_for("[add_two_ints_client]: Result of add_two_ints: for 4 + -5 = -1")
    assert asking.wait() == 0
    server.stop()
    assert "Traceback" not in server.output + asking.output


def test_the_client_waits_for_a_server(start: Start) -> None:
    asking = start("zbot", "run", "add_two_ints_client")
    asking.wait_for("[add_two_ints_client]: service not available, waiting again...")
    start("zbot", "run", "add_two_ints_server")
    asking.wait_for("Result of add_two_ints: for 2 + 3 = 5")
    assert asking.wait() == 0


@pytest.mark.usefixtures("server")
def test_the_services_are_listed() -> None:
    assert zbot("service", "list").out == "/add_two_ints\n"
    assert zbot("service", "list", "-t").out == (
        "/add_two_ints [example_interfaces/srv/AddTwoInts]\n"
    )
    assert zbot("service", "type", "/add_two_ints").out == "example_interfaces/srv/AddTwoInts\n"
    assert zbot("service", "find", "example_interfaces/srv/AddTwoInts").out == "/add_two_ints\n"
    assert zbot("service", "info", "/add_two_ints").out == (
        "Type: example_interfaces/srv/AddTwoInts\nClients count: 0\nServices count: 1\n"
    )
    assert "    /add_two_ints: example_interfaces/srv/AddTwoInts\n" in (
        zbot("node", "info", "/service_node").out
    )


def test_a_service_is_called(server: Program) -> None:
    done = zbot(
        "service", "call", "/add_two_ints", "example_interfaces/srv/AddTwoInts", "{a: 5, b: 3}"
    )
    assert (done.code, done.out, done.err) == (0, WAITING + SUM, "")
    server.wait_for("[service_node]: 5 + 3 = 8")


def test_the_definition_is_shown() -> None:
    shown = zbot("interface", "show", "example_interfaces/srv/AddTwoInts").out.splitlines()
    assert [line for line in shown if line and not line.startswith("#")] == [
        "int64 a",
        "int64 b",
        "---",
        "int64 sum",
    ]
