"""Sessions of rosbridge with a running system, without a browser and without a websocket."""

from __future__ import annotations

import json
import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer, CancelResponse
from zbot.node.errors import ServiceError
from zbot.web.rosbridge import rosapi, service_operations, topic_operations
from zbot.web.rosbridge.bridge import Bridge
from zbot.web.rosbridge.session import Session
from zbot.web.system import System

from builtin_interfaces.msg import Time
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import PoseStamped
from rcl_interfaces.msg import ParameterDescriptor
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import Spinner

LATCHED = zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL)


class WebProgram:
    """Client of rosbridge, which keeps what it receives."""

    def __init__(self, bridge: Bridge) -> None:
        self.session = Session(bridge, lambda: None, self._call_later)
        self.received: list[dict[str, Any]] = []

    @staticmethod
    def _call_later(delay_s: float, function: Callable[[], None]) -> None:
        threading.Timer(delay_s, function).start()

    def send(self, op: str, **fields: Any) -> None:
        self.session.take(json.dumps({"op": op, **fields}))

    def read(self) -> list[dict[str, Any]]:
        self.received += map(json.loads, self.session.outbox.take().frames)
        return self.received

    def wait_for(self, op: str, **fields: Any) -> dict[str, Any]:
        """Return the first message with these fields, and forget it."""
        found: list[dict[str, Any]] = []

        def has_come() -> bool:
            wanted = {"op": op, **fields}
            found[:] = [one for one in self.read() if wanted.items() <= one.items()]
            return bool(found)

        assert wait_until(has_come, 10), self.received
        self.received.remove(found[0])
        return found[0]

    def call(self, service: str, /, **args: Any) -> Any:
        self.send("call_service", service=service, args=args, id=service)
        answer = self.wait_for("service_response", id=service)
        assert answer["result"], answer
        return answer["values"]


@pytest.fixture
def system(domain: int) -> Iterator[System]:
    with System(domain_id=domain) as system:
        yield system


@pytest.fixture
def web(system: System) -> Iterator[WebProgram]:
    bridge = Bridge(system)
    program = WebProgram(bridge)
    yield program
    program.session.close()
    bridge.close()


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> zbot.Node:
    return zbot.Node("robot", context=make_context())


def repeat_until_sent(publisher: Any, message: Any, web: WebProgram, op: str) -> dict[str, Any]:
    def attempt() -> bool:
        publisher.publish(message)
        return any(one["op"] == op for one in web.read())

    assert wait_until(attempt, 10)
    return web.wait_for(op)


def test_subscribe_sends_messages_until_unsubscribe(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    web.send("subscribe", topic="chatter", type="std_msgs/String", id="a")
    web.send("subscribe", topic="chatter", id="b")
    sent = repeat_until_sent(publisher, String(data="hello"), web, "publish")
    # The name is the client's own, as it finds its callback by it.
    assert sent == {"op": "publish", "topic": "chatter", "msg": {"data": "hello"}}
    web.send("unsubscribe", topic="chatter", id="a")
    assert repeat_until_sent(publisher, String(), web, "publish")
    web.send("unsubscribe", topic="chatter", id="b")
    assert wait_until(lambda: node.count_subscribers("chatter") == 0, 10)
    assert not [one for one in web.read() if one["op"] == "status"]


def test_a_latched_message_and_nan_arrive(web: WebProgram, node: zbot.Node) -> None:
    node.create_publisher(LaserScan, "map", LATCHED).publish(LaserScan(ranges=[float("inf"), 1.0]))
    bridge = web.session.bridge
    assert wait_until(lambda: bool(bridge.graph().publishers("/map")), 10)
    web.send("subscribe", topic="/map")
    assert web.wait_for("publish")["msg"]["ranges"] == [None, 1.0]


def take_one(web: WebProgram) -> list[Any]:
    frames: list[Any] = []

    def has_come() -> bool:
        frames.extend(web.session.outbox.take().frames)
        return bool(frames)

    assert wait_until(has_come, 10)
    return frames


def test_compressions_and_fragments(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(LaserScan, "scan", LATCHED)
    publisher.publish(LaserScan(ranges=[1.5] * 20))
    for compression, start in (("cbor", b"\xa3\x62op"), ("cbor-raw", b"\xa3\x62op")):
        web.send("subscribe", topic="/scan", type="sensor_msgs/LaserScan", compression=compression)
        [frame] = take_one(web)
        assert frame.startswith(start)
        assert (b"secs" in frame) == (compression == "cbor-raw")
        web.send("unsubscribe", topic="/scan")
    web.send("subscribe", topic="/scan", fragment_size=100)
    total = web.wait_for("fragment", num=0)["total"]
    assert total > 3
    assert web.wait_for("fragment", num=total - 1)
    web.send("subscribe", topic="/scan", compression="zip", id="z")
    assert "'zip' is not one of" in web.wait_for("status", id="z")["msg"]


def test_publish_reaches_nodes(
    web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    texts: list[str] = []
    poses: list[Any] = []
    node.create_subscription(String, "text", lambda message: texts.append(message.data), 10)
    node.create_subscription(PoseStamped, "pose", poses.append, 10)
    spin(node)
    web.send("advertise", topic="/text", type="std_msgs/String")
    assert wait_until(lambda: node.count_publishers("text") == 1, 10)
    web.send("publish", topic="/text", msg={"data": "a"})
    # Without an advertisement, the graph knows the type.
    assert wait_until(lambda: bool(web.session.bridge.graph().subscriptions("/pose")), 10)
    web.send("publish", topic="pose", msg={"pose": {"position": {"x": 2}}})
    assert wait_until(lambda: texts == ["a"] and len(poses) == 1, 10)
    assert poses[0].pose.position.x == 2.0
    assert poses[0].header.stamp != Time()
    web.send("unadvertise", topic="/text")
    assert wait_until(lambda: node.count_publishers("text") == 0, 10)
    assert web.read() == []


@pytest.mark.parametrize(
    ("op", "fields", "reason"),
    [
        ("dance", {}, "no operation 'dance'"),
        ("publish", {"topic": "/unknown", "msg": {}}, "advertise it first"),
        ("publish", {"topic": "a b", "msg": {}}, "a b"),
        ("advertise", {"topic": "/a", "type": "std_msgs/Nothing"}, "std_msgs/msg/Nothing"),
        ("advertise", {"topic": "/a", "type": "../etc/passwd"}, "not the name of a type"),
        ("advertise", {"topic": "/a", "type": "std_srvs/srv/Empty"}, "not the name of a type"),
        ("advertise", {"topic": "/rosout", "type": "std_msgs/String"}, "has the type rcl_inter"),
        ("subscribe", {"topic": "/unknown"}, "nobody uses /unknown"),
        ("subscribe", {"topic": "/rosout", "type": "std_msgs/String"}, "has the type rcl_interf"),
        ("subscribe", {"topic": "/rosout", "throttle_rate": "5"}, "'throttle_rate' must be"),
        ("service_response", {"service": "/a"}, "you do not serve /a"),
        ("action_feedback", {"action": "/a"}, "you do not serve /a"),
        ("action_result", {"action": "/a"}, "you do not serve /a"),
        ("cancel_action_goal", {"action": "/a"}, "you have no goal"),
        ("unadvertise_service", {"service": "/a"}, "you do not serve /a"),
        ("unadvertise_action", {"action": "/a"}, "you do not serve /a"),
        ("set_level", {"level": "loud"}, "'loud' is not one of"),
        ("fragment", {"num": 0, "total": 1, "data": "{}"}, "needs an id"),
    ],
)
def test_a_wrong_message_is_a_status_and_the_next_one_works(
    web: WebProgram, op: str, fields: dict[str, Any], reason: str
) -> None:
    web.send(op, **{"id": "wrong", **fields}) if op != "fragment" else web.send(op, **fields)
    status = web.wait_for("status")
    assert status["level"] == "error"
    assert reason in status["msg"]
    assert web.call("/rosapi/nodes")["nodes"] == ["/rosbridge_websocket"]


def test_status_levels(web: WebProgram) -> None:
    web.send("unsubscribe", topic="/a")
    web.send("set_level", level="warning")
    web.send("unsubscribe", topic="/a")
    web.send("advertise", topic="/a", type="std_msgs/String")
    web.send("set_level", level="info")
    web.send("advertise", topic="/b", type="std_msgs/String", id=5)
    web.send("set_level", level="none")
    web.send("dance")
    levels = [one["level"] for one in web.read()]
    assert levels == ["warning", "info"]
    assert web.received[1]["id"] == 5


def test_fragments_are_joined(web: WebProgram) -> None:
    text = json.dumps({"op": "call_service", "service": "/rosapi/get_time", "id": "t"})
    web.send("fragment", id="f", num=1, total=2, data=text[9:])
    web.send("fragment", id="f", num=0, total=2, data=text[:9])
    assert web.wait_for("service_response", id="t")["values"]["time"]["sec"] > 0


def test_call_service(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    def add(request: Any, response: Any) -> Any:
        if request.a < 0:
            raise ValueError("a is negative")
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "add", add)
    spin(node)
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/add")), 10)
    assert web.call("/add", a=1, b=2**53 + 1) == {"sum": 2**53 + 2}
    web.send("call_service", service="/add", args=[4, 5])
    assert web.wait_for("service_response")["values"] == {"sum": 9}
    for service, args, reason in (
        ("/nothing", {}, "no service /nothing"),
        ("/add", {"a": "1"}, "a needs an integer"),
        ("/add", {"a": -1}, "a is negative"),
    ):
        web.send("call_service", service=service, args=args, id=3)
        answer = web.wait_for("service_response", id=3)
        assert answer["result"] is False
        assert reason in answer["values"]


def test_a_call_has_a_timeout(web: WebProgram, node: zbot.Node) -> None:
    node.create_service(AddTwoInts, "busy", lambda _request, response: response)  # nobody spins
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/busy")), 10)
    web.send("call_service", service="/busy", timeout=0.2, id="slow")
    answer = web.wait_for("service_response", id="slow")
    assert (answer["result"], answer["values"]) == (False, "/busy did not answer within 0.2 s")


def test_a_call_beyond_the_most_gets_an_answer(
    web: WebProgram, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(service_operations, "MAX_CALLS", 1)
    node.create_service(AddTwoInts, "busy", lambda _request, response: response)  # nobody spins
    assert wait_until(lambda: bool(dict(web.session.bridge.graph().services()).get("/busy")), 10)
    for id_ in ("first", "second"):
        web.send("call_service", service="/busy", timeout=0, id=id_)
    answer = web.wait_for("service_response", id="second")
    assert (answer["result"], answer["values"]) == (False, "you wait for 1 responses already")


def test_a_defect_at_the_start_does_not_take_a_place_for_ever(
    web: WebProgram, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def defect() -> None:
        raise KeyError("defect")

    fields: dict[str, Any] = {"action": "/a", "action_type": "example_interfaces/Fibonacci"}
    with monkeypatch.context() as defective:
        defective.setattr(web.session.bridge, "graph", defect)
        defective.setattr(web.session, "require_writable", lambda _what: defect())
        web.send("call_service", service="/rosapi/nodes", id=1)
        web.send("send_action_goal", **fields, id=2)
    for op, id_ in (("service_response", 1), ("action_result", 2)):
        answer = web.wait_for(op, id=id_)
        values = "the server failed: KeyError('defect')"
        assert (answer["result"], answer["values"]) == (False, values)
    assert "Traceback" in capfd.readouterr().err
    assert not web.session._services._calls
    assert not web.session._actions._goals


def test_serve_a_service(web: WebProgram, node: zbot.Node) -> None:
    web.send("advertise_service", service="add", type="example_interfaces/AddTwoInts")
    client = node.create_client(AddTwoInts, "/add")
    assert client.wait_for_service(10)
    answers: list[Any] = []

    def call(a: int) -> None:
        try:
            answers.append(client.call(AddTwoInts.Request(a=a, b=1), 10).sum)
        except ServiceError as error:
            answers.append(str(error))

    def answer(a: int, **fields: Any) -> Any:
        thread = threading.Thread(target=call, args=(a,))
        thread.start()
        request = web.wait_for("call_service", service="add")
        assert request["args"] == {"a": a, "b": 1}
        web.send("service_response", service="add", id=request["id"], **fields)
        thread.join(10)
        return answers.pop()

    assert answer(1, values={"sum": 2}, result=True) == 2
    assert "no cable" in answer(2, values="no cable", result=False)
    assert "sum needs an integer" in answer(3, values={"sum": "x"}, result=True)
    assert "sum needs an integer" in web.wait_for("status")["msg"]
    thread = threading.Thread(target=call, args=(4,))
    thread.start()
    web.wait_for("call_service")
    web.send("unadvertise_service", service="add")
    thread.join(10)
    assert "has ended" in answers.pop()


def test_send_a_goal(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    async def count(goal: Any) -> Any:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[0, 1]))
        if goal.request.order > 100:
            ended: zbot.Future[None] = zbot.Future()  # it waits until it is cancelled
            waiting.append((goal, ended))
            await ended
            goal.canceled()
        else:
            goal.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])

    waiting: list[Any] = []

    def cancel(_goal: Any) -> CancelResponse:
        node.executor.create_task(lambda: waiting[0][1].set_result(None))  # type: ignore[union-attr]
        return CancelResponse.ACCEPT

    ActionServer(node, Fibonacci, "count", count, cancel_callback=cancel)
    spin(node)
    goal = {"action": "/count", "action_type": "example_interfaces/Fibonacci", "feedback": True}
    web.send("send_action_goal", id="g", args={"order": 5}, **goal)
    feedback = web.wait_for("action_feedback", id="g", action="/count")
    assert feedback["values"] == {"sequence": [0, 1]}
    result = web.wait_for("action_result", id="g")
    assert (result["status"], result["result"]) == (4, True)
    assert result["values"] == {"sequence": [0, 1, 1]}
    web.send("send_action_goal", id="long", args={"order": 500}, **goal)
    assert wait_until(lambda: bool(waiting), 10)
    web.send("cancel_action_goal", id="long", action="/count")
    assert web.wait_for("action_result", id="long")["status"] == 5
    web.send("send_action_goal", id="bad", args={"order": "x"}, **goal)
    result = web.wait_for("action_result", id="bad")
    assert (result["status"], result["result"]) == (0, False)
    assert "order needs an integer" in result["values"]


def test_serve_an_action(web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]) -> None:
    web.send("advertise_action", action="/fold", type="example_interfaces/Fibonacci")
    client: ActionClient[Any, Any, Any] = ActionClient(node, Fibonacci, "fold")
    spin(node)
    assert client.wait_for_server(10)
    feedback: list[Any] = []

    def send(order: int) -> tuple[Any, str]:
        goal = Fibonacci.Goal(order=order)
        future = client.send_goal_async(goal, lambda one: feedback.append(one.feedback.sequence))
        request = web.wait_for("send_action_goal", action="/fold")
        assert request["args"] == {"order": order}
        assert wait_until(future.done, 10)
        return future.result(), request["id"]

    def outcome(handle: Any) -> tuple[int, list[int]]:
        future = handle.get_result_async()
        assert wait_until(future.done, 10)
        return future.result().status, list(future.result().result.sequence)

    handle, id_ = send(3)
    web.send("action_feedback", action="/fold", id=id_, values={"sequence": [7]})
    assert wait_until(lambda: [list(one) for one in feedback] == [[7]], 10)
    values = {"sequence": [1, 2]}
    web.send("action_result", action="/fold", id=id_, values=values, status=4, result=True)
    assert outcome(handle) == (4, [1, 2])
    handle, id_ = send(4)
    web.send("action_result", action="/fold", id=id_, status=6, result=False)
    assert outcome(handle) == (6, [])
    handle, id_ = send(5)
    handle.cancel_goal_async()
    assert web.wait_for("cancel_action_goal")["id"] == id_
    web.send("action_result", action="/fold", id=id_, values=values, status=5, result=True)
    assert outcome(handle) == (5, [1, 2])


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
    assert web.call("/rosapi/service_providers", service="/add") == {"providers": ["/robot"]}
    assert web.call("/rosapi/action_servers") == {"action_servers": []}
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
    assert not [one for one in names if one.startswith("/stuck")]


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


def test_a_read_only_server_only_reads(
    domain: int, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    node.create_service(AddTwoInts, "add", lambda _request, response: response)
    node.declare_parameter("limit", 2.0)
    spin(node)
    with System(domain_id=domain, read_only=True) as system:
        web = WebProgram(Bridge(system))
        graph = web.session.bridge.graph
        assert wait_until(lambda: "/add" in dict(graph().services()), 10)
        action = "example_interfaces/Fibonacci"
        for op, fields in (
            ("advertise", {"topic": "/a", "type": "std_msgs/String"}),
            ("publish", {"topic": "/a", "msg": {}}),
            ("advertise_service", {"service": "/a", "type": "std_srvs/Empty"}),
            ("advertise_action", {"action": "/a", "type": action}),
        ):
            web.send(op, **fields)
            assert "--read-only" in web.wait_for("status")["msg"]
        web.send("call_service", service="/add", id=1)
        assert "--read-only" in web.wait_for("service_response", id=1)["values"]
        web.send("send_action_goal", action="/a", action_type=action, id=2)
        assert "--read-only" in web.wait_for("action_result", id=2)["values"]
        args = {"name": "/robot:limit", "value": "3"}
        web.send("call_service", service="/rosapi/set_param", args=args, id=3)
        assert "--read-only" in web.wait_for("service_response", id=3)["values"]
        assert web.call("/rosapi/get_param", name="/robot:limit")["value"] == "2.0"
        web.session.bridge.close()


def test_what_a_client_has_created_ends_with_it(web: WebProgram, node: zbot.Node) -> None:
    web.send("advertise", topic="/a", type="std_msgs/String")
    web.send("subscribe", topic="/b", type="std_msgs/String")
    web.send("advertise_service", service="/c", type="std_srvs/Empty")
    web.send("advertise_action", action="/d", type="example_interfaces/Fibonacci")
    assert wait_until(lambda: node.count_services("/d/_action/send_goal") == 1, 10)
    assert node.count_publishers("/a") == node.count_subscribers("/b") == 1
    assert node.count_services("/c") == 1
    web.session.close()
    assert wait_until(lambda: node.count_services("/d/_action/send_goal") == 0, 10)
    assert wait_until(lambda: node.count_publishers("/a") == node.count_subscribers("/b") == 0, 10)
    assert wait_until(lambda: node.count_services("/c") == 0, 10)
    web.send("advertise", topic="/late", type="std_msgs/String")
    assert node.count_publishers("/late") == 0
    assert len(web.session.bridge.shared) == 0


def test_a_client_has_limits(web: WebProgram, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(topic_operations, "MAX_TOPICS", 1)
    monkeypatch.setattr(service_operations, "MAX_SERVICES", 1)
    for op, name, kind in (
        ("advertise", "topic", "std_msgs/String"),
        ("subscribe", "topic", "std_msgs/String"),
        ("advertise_service", "service", "std_srvs/Empty"),
    ):
        web.send(op, **{name: "/one", "type": kind})
        assert web.read() == []
        web.send(op, **{name: "/two", "type": kind})
        assert "a client can" in web.wait_for("status")["msg"]


def test_a_slow_client_gets_a_warning_and_the_newest(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "fast", 100)
    web.send("set_level", level="warning")
    web.send("subscribe", topic="/fast", type="std_msgs/String", queue_length=2)
    assert repeat_until_sent(publisher, String(data="first"), web, "publish")
    for number in range(50):
        publisher.publish(String(data=str(number)))
    queue = next(iter(web.session.outbox._topics))
    assert wait_until(lambda: bool(queue.payloads) and b"49" in queue.payloads[-1], 10)
    assert len(queue.payloads) == 2
    assert "were dropped" in web.wait_for("status", level="warning")["msg"]
    assert web.wait_for("publish", msg={"data": "49"})
