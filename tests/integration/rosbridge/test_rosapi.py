"""Procedures of rosapi: the system's graph and its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zbot
from tests.conftest import wait_until
from zbot.web.rosbridge import rosapi

from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import ParameterDescriptor
from std_msgs.msg import Float64

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    from tests.conftest import Spinner
    from tests.integration.rosbridge.web_program import WebProgram
    from zbot.web.rosbridge.bridge import Bridge


def test_rosapi_describes_the_system(
    web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    node.create_publisher(Float64, "speed", 10)
    node.create_service(AddTwoInts, "add", lambda _request, response: response)
    node.declare_parameter("limit", 2.0)
    node.declare_parameter("name", "a")
    spin(node)
    graph = web.session.bridge.graph
    assert wait_until(lambda: "/add" in dict(graph().services()), 10)
    assert wait_until(lambda: "/speed" in dict(graph().topics()), 10)
    topics = web.call("/rosapi/topics")
    types = dict(zip(topics["topics"], topics["types"], strict=True))
    assert types["/speed"] == "std_msgs/msg/Float64"
    assert web.call("/rosapi/topics_for_type", type="std_msgs/Float64") == {"topics": ["/speed"]}
    raw = web.call("/rosapi/topics_and_raw_types")
    assert (
        "float64 data" in dict(zip(raw["topics"], raw["typedefs_full_text"], strict=True))["/speed"]
    )
    assert "/add" in web.call("/rosapi/services")["services"]
    found = web.call("/rosapi/services_for_type", type="example_interfaces/srv/AddTwoInts")
    assert found == {"services": ["/add"]}
    assert web.call("/rosapi/nodes") == {"nodes": ["/robot", "/rosbridge_websocket"]}
    details = web.call("/rosapi/node_details", node="/robot")
    assert "/speed" in details["publishing"]
    assert "/add" in details["services"]
    assert web.call("/rosapi/topic_type", topic="/speed") == {"type": "std_msgs/msg/Float64"}
    assert web.call("/rosapi/topic_type", topic="/none") == {"type": ""}
    found = web.call("/rosapi/service_type", service="add")
    assert found == {"type": "example_interfaces/srv/AddTwoInts"}
    assert web.call("/rosapi/publishers", topic="/speed") == {"publishers": ["/robot"]}
    assert web.call("/rosapi/subscribers", topic="/speed") == {"subscribers": []}
    assert web.call("/rosapi/service_node", service="/add") == {"node": "/robot"}
    for word in ("/add", "example_interfaces/srv/AddTwoInts"):  # rosapi's argument is a type
        assert web.call("/rosapi/service_providers", service=word) == {"providers": ["/robot"]}
    assert web.call("/rosapi/action_servers") == {"action_servers": []}
    interfaces = web.call("/rosapi/interfaces")["interfaces"]
    assert {"std_msgs/msg/String", "std_srvs/srv/Empty"} <= set(interfaces)
    [twist, vector] = web.call("/rosapi/message_details", type="geometry_msgs/Twist")["typedefs"]
    assert twist["fieldtypes"] == ["geometry_msgs/Vector3"] * 2
    assert (vector["type"], vector["fieldnames"]) == ("geometry_msgs/Vector3", ["x", "y", "z"])
    kind = "example_interfaces/AddTwoInts"
    [part] = web.call("/rosapi/service_request_details", type=kind)["typedefs"]
    assert part["fieldnames"] == ["a", "b"]
    [part] = web.call("/rosapi/service_response_details", type=kind)["typedefs"]
    assert part["fieldnames"] == ["sum"]
    assert web.call("/rosapi/get_ros_version")["version"] == 2
    assert "/robot:limit" in web.call("/rosapi/get_param_names")["names"]


def test_stuck_nodes_are_left_out_of_the_names_of_parameters(
    web: WebProgram,
    node: zbot.Node,
    spin: Callable[..., Spinner],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(rosapi, "_PATIENCE_S", 2.0)
    node.declare_parameter("limit", 2.0)
    spin(node)
    stuck = {f"stuck{number}": zbot.Node(f"stuck{number}", context=node.context) for number in "12"}
    services = {f"/{name}/list_parameters" for name in ("robot", *stuck)}
    assert wait_until(lambda: services <= set(dict(web.session.bridge.graph().services())), 10)
    names = web.call("/rosapi/get_param_names")["names"]
    assert "/robot:limit" in names
    assert not [name for name in names if name.startswith("/stuck")]


def test_a_defect_of_a_procedure_is_an_answer(
    web: WebProgram, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def defect(_bridge: Bridge, _args: dict[str, Any]) -> dict[str, Any]:
        raise KeyError("defect")

    monkeypatch.setitem(rosapi.PROCEDURES, "/rosapi/nodes", defect)
    web.send("call_service", service="/rosapi/nodes", id=1)
    answer = web.wait_for("service_response", id=1)
    assert (answer["result"], answer["values"]) == (False, "the server failed: KeyError('defect')")
    assert "Traceback" in capfd.readouterr().err


def test_parameters(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    node.declare_parameter("limit", 2.0)
    node.declare_parameter("name", "a")
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    spin(node)
    assert wait_until(
        lambda: "/robot/set_parameters" in dict(web.session.bridge.graph().services()), 10
    )
    assert web.call("rosapi/get_param", name="/robot:limit")["value"] == "2.0"
    assert web.call("rosapi/set_param", name="/robot:limit", value="3")["successful"]
    assert node.get_parameter("limit").value == 3.0
    assert web.call("rosapi/set_param", name="robot:name", value='"b"')["successful"]
    assert web.call("rosapi/get_param", name="robot:name")["value"] == '"b"'
    refused = web.call("rosapi/set_param", name="/robot:fixed", value="2")
    assert not refused["successful"]
    assert refused["reason"]
    missing = web.call("rosapi/get_param", name="/robot:nothing")
    assert (missing["successful"], missing["value"]) == (False, "null")
    given = web.call("rosapi/get_param", name="/robot:nothing", default_value="5")
    assert (given["successful"], given["value"]) == (True, "5")
    assert web.call("rosapi/has_param", name="/robot:limit") == {"exists": True}
    assert web.call("rosapi/has_param", name="/robot:nothing") == {"exists": False}
    for name, value in (("limit", "5"), ("/robot:limit", "{"), ("/robot:limit", '{"a": 1}')):
        web.send("call_service", service="/rosapi/set_param", args={"name": name, "value": value})
        assert web.wait_for("service_response")["result"] is False
