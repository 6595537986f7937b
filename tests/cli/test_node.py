"""Tests of `zbot node info`: its output equals that of ros2 for services and actions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from zbot.action import ActionClient, ActionServer

from example_interfaces.action import Fibonacci
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from tests.cli.conftest import Command
    from tests.conftest import MakeContext

SERVED = """\
{0}
  Subscribers:

  Publishers:
    /parameter_events: rcl_interfaces/msg/ParameterEvent
    /rosout: rcl_interfaces/msg/Log
  Service Servers:
    {0}/describe_parameters: rcl_interfaces/srv/DescribeParameters
    {0}/get_parameter_types: rcl_interfaces/srv/GetParameterTypes
    {0}/get_parameters: rcl_interfaces/srv/GetParameters
    {0}/list_parameters: rcl_interfaces/srv/ListParameters
    {0}/set_parameters: rcl_interfaces/srv/SetParameters
    {0}/set_parameters_atomically: rcl_interfaces/srv/SetParametersAtomically
"""


def unused(*_: Any) -> Any:
    pytest.fail("nobody calls this")


@pytest.fixture
def context(make_context: MakeContext) -> library.Context:
    return make_context()


def test_info_of_a_service_server(context: library.Context, zbot_command: Command) -> None:
    node = library.Node("minimal_service", context=context)
    node.create_service(SetBool, "set_bool", unused)
    assert zbot_command("node", "info", "/minimal_service").out == (
        SERVED.format("/minimal_service") + "    /set_bool: std_srvs/srv/SetBool\n"
        "  Service Clients:\n\n  Action Servers:\n\n  Action Clients:\n\n"
    )


def test_info_of_an_action_server(context: library.Context, zbot_command: Command) -> None:
    node = library.Node("fib_server", context=context)
    server = ActionServer(node, Fibonacci, "fibonacci", unused)
    assert zbot_command("node", "info", "/fib_server").out == (
        SERVED.format("/fib_server") + "  Service Clients:\n\n  Action Servers:\n"
        "    /fibonacci: example_interfaces/action/Fibonacci\n  Action Clients:\n\n"
    )
    server.destroy()


def test_info_of_clients(context: library.Context, zbot_command: Command) -> None:
    node = library.Node("caller", context=context, start_parameter_services=False)
    node.create_client(SetBool, "set_bool")
    client: Any = ActionClient(node, Fibonacci, "fibonacci")
    assert zbot_command("node", "info", "/caller").out == (
        "/caller\n  Subscribers:\n\n  Publishers:\n"
        "    /parameter_events: rcl_interfaces/msg/ParameterEvent\n"
        "    /rosout: rcl_interfaces/msg/Log\n"
        "  Service Servers:\n\n  Service Clients:\n    /set_bool: std_srvs/srv/SetBool\n"
        "  Action Servers:\n\n  Action Clients:\n"
        "    /fibonacci: example_interfaces/action/Fibonacci\n"
    )
    client.destroy()


def test_hidden_names_are_shown_on_request(context: library.Context, zbot_command: Command) -> None:
    library.Node("robot", context=context)
    shown = zbot_command("node", "info", "/robot", "--include-hidden").out
    service = "type_description_interfaces/srv/GetTypeDescription"
    assert f"    /robot/get_type_description: {service}\n" in shown
