from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest

from tests.unit.bridge.fake_side import FakeAnswer, FakeSide
from zbot.bridge.errors import CallError
from zbot.bridge.route_manager import RouteManager
from zbot.bridge.selection import Direction, Selection, patterns
from zbot.bridge.side import End
from zbot.interfaces import get_interface
from zbot.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Iterator

PUBLISHER, SUBSCRIPTION = EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION
SERVICE, CLIENT = EntityKind.SERVICE, EntityKind.CLIENT
STRING: Any = get_interface("std_msgs/msg/String")


class Lines(list[str]):
    def warning(self, message: str) -> None:
        self.append(message)


@pytest.fixture
def zbot() -> FakeSide:
    return FakeSide("zbot", "messagepack")


@pytest.fixture
def ros() -> FakeSide:
    return FakeSide("ROS 2")


@pytest.fixture
def log() -> Lines:
    return Lines()


def manager(
    zbot: FakeSide, ros: FakeSide, log: Lines, selection: Selection | None = None, **options: Any
) -> RouteManager:
    made = RouteManager(
        zbot, ros, selection or Selection(), bridge_id=options.pop("own", "b"), log=log, **options
    )
    made.update()
    return made


def test_a_topic_of_ros_is_carried_in_with_its_bytes_converted(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    manager(zbot, ros, log)
    assert not ros.open("sender")
    ros.open("receiver")["/scan"].call_back(cdr_codec_for(STRING).encode(STRING(data="hi")))
    assert zbot.open("sender")["/scan"].sent == [
        messagepack_codec_for(STRING).encode(STRING(data="hi"))
    ]
    assert {end.name for end in zbot.shown} == {"/scan"}
    assert zbot.shown_nodes == {"/node"}


def test_a_message_that_nobody_hears_is_not_converted(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    manager(zbot, ros, log)
    zbot.open("sender")["/scan"].is_heard = False
    ros.open("receiver")["/scan"].call_back(b"not CDR")
    assert (zbot.open("sender")["/scan"].sent, log) == ([], [])


def test_a_damaged_message_is_told_once(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/scan")
    manager(zbot, ros, log)
    for _ in range(3):
        ros.open("receiver")["/scan"].call_back(b"not CDR")
    assert len(log) == 1
    assert log[0].startswith("/scan: cannot carry a message")


def test_a_route_exists_before_the_publisher_if_the_robot_subscribes(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(SUBSCRIPTION, "/cmd_vel")
    manager(zbot, ros, log)
    assert set(zbot.open("receiver")) == {"/cmd_vel"}
    assert set(ros.open("sender")) == {"/cmd_vel"}


def test_routes_end_with_their_publishers(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/scan")
    made = manager(zbot, ros, log)
    ros.close()
    made.update()
    assert not ros.open("receiver")
    assert not zbot.open("sender")
    assert zbot.shown == frozenset()


def test_what_every_node_has_is_left_out(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/rosout", "rcl_interfaces/msg/Log")
    ros.add(PUBLISHER, "/parameter_events", "rcl_interfaces/msg/ParameterEvent")
    ros.add(SERVICE, "/node/set_parameters", "rcl_interfaces/srv/SetParameters")
    made = manager(zbot, ros, log)
    assert made.carried == []
    made = manager(zbot, ros, log, Selection(parameters=True))
    assert [name for name, _ in made.carried] == ["/node/set_parameters", "/parameter_events"]


def test_a_prefix_is_added_in_zbot_and_removed_in_ros(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan", node="/base")
    zbot.add(PUBLISHER, "/robot1/cmd_vel")
    zbot.add(PUBLISHER, "/other")
    manager(zbot, ros, log, prefix="/robot1")
    assert set(zbot.open("sender")) == {"/robot1/scan"}
    assert set(ros.open("sender")) == {"/cmd_vel"}
    assert zbot.shown_nodes == {"/robot1/base"}


def test_profiles_are_those_of_the_other_side(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    latched = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    loose = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
    ros.add(PUBLISHER, "/map", qos=latched)
    zbot.add(PUBLISHER, "/image", qos=loose)
    manager(zbot, ros, log)
    for profile in (ros.open("receiver")["/map"].qos, zbot.open("sender")["/map"].qos):
        assert profile is not None
        assert profile.durability is DurabilityPolicy.TRANSIENT_LOCAL
        assert profile.reliability is ReliabilityPolicy.RELIABLE
    for profile in (zbot.open("receiver")["/image"].qos, ros.open("sender")["/image"].qos):
        assert profile is not None
        assert profile.reliability is ReliabilityPolicy.BEST_EFFORT
        assert profile.durability is DurabilityPolicy.VOLATILE


def test_another_profile_reopens_the_route(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/scan")
    made = manager(zbot, ros, log)
    first = zbot.open("sender")["/scan"]
    loose = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    ros.add(PUBLISHER, "/scan", node="/second", qos=loose)
    made.update()
    assert first.is_closed
    qos = zbot.open("sender")["/scan"].qos
    assert qos is not None
    assert qos.reliability is ReliabilityPolicy.BEST_EFFORT


def test_a_mismatch_of_profiles_is_told(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    loose = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    zbot.add(PUBLISHER, "/scan", node="/laptop", qos=loose)
    ros.add(SUBSCRIPTION, "/scan", node="/robot")
    made = manager(zbot, ros, log)
    made.update()
    assert len(log) == 1
    assert "/robot gets no messages of /laptop" in log[0]


class CountedEnds(frozenset[End]):
    """Endpoints that count how often a program goes through them."""

    passes = 0

    def __iter__(self) -> Iterator[End]:
        self.passes += 1
        return super().__iter__()


@pytest.mark.parametrize("count", [1, 30])
def test_the_endpoints_are_not_searched_again_for_each_topic(
    zbot: FakeSide, ros: FakeSide, log: Lines, count: int
) -> None:
    for number in range(count):
        zbot.add(PUBLISHER, f"/topic{number}")
        ros.add(SUBSCRIPTION, f"/topic{number}")
    ends = CountedEnds(ros.present.ends)
    ros.present = replace(ros.present, ends=ends)
    assert len(manager(zbot, ros, log).carried) == count
    assert ends.passes < 10


def test_a_route_that_failed_is_tried_again_and_leaves_nothing_open(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    ros.add(SERVICE, "/lamp", "std_srvs/srv/SetBool")
    ros.broken_kinds, zbot.broken_kinds = {"receiver"}, {"server"}
    made = manager(zbot, ros, log)
    made.update()
    assert made.carried == []
    assert [*zbot.open("sender"), *ros.open("caller")] == []
    assert sorted(log) == [
        "/lamp is not carried: too many open files",
        "/scan is not carried: too many open files",
    ]
    ros.broken_kinds, zbot.broken_kinds = set(), set()
    made.update()
    assert [name for name, _ in made.carried] == ["/lamp", "/scan"]


@pytest.mark.parametrize("side", ["zbot", "ros"])
def test_a_missing_type_is_told_once(zbot: FakeSide, ros: FakeSide, log: Lines, side: str) -> None:
    {"zbot": zbot, "ros": ros}[side].missing_types["std_msgs/msg/String"] = "it has no String"
    ros.add(PUBLISHER, "/scan")
    manager(zbot, ros, log).update()
    assert log == ["/scan is not carried: it has no String"]


@pytest.mark.parametrize("hashes", [("RIHS01_1", ""), ("", "RIHS01_1")])
def test_another_definition_than_that_of_zbot_is_told(
    zbot: FakeSide, ros: FakeSide, log: Lines, hashes: tuple[str, str]
) -> None:
    ros.add(PUBLISHER, "/scan", type_hash=hashes[0])
    zbot.add(SUBSCRIPTION, "/scan", type_hash=hashes[1])
    assert manager(zbot, ros, log).carried == []
    assert log == [
        "/scan is not carried: zbot and ROS 2 have different definitions of std_msgs/msg/String"
    ]


def test_two_types_on_one_name_are_told(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/scan")
    zbot.add(PUBLISHER, "/scan", "std_msgs/msg/Int32")
    made = manager(zbot, ros, log)
    assert made.carried == []
    assert log == ["/scan has several types (std_msgs/msg/Int32, std_msgs/msg/String)"]


def test_a_call_is_carried_and_its_response_comes_back(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(SERVICE, "/lamp", "std_srvs/srv/SetBool")
    manager(zbot, ros, log)
    request: Any = get_interface("std_srvs/srv/SetBool_Request")
    response: Any = get_interface("std_srvs/srv/SetBool_Response")
    answer = FakeAnswer()
    zbot.open("server")["/lamp"].call_back(
        messagepack_codec_for(request).encode(request(data=True)), answer
    )
    caller = ros.open("caller")["/lamp"]
    assert caller.sent == [cdr_codec_for(request).encode(request(data=True))]
    caller.call_back.reply(cdr_codec_for(response).encode(response(message="on")))
    assert answer.outcome == messagepack_codec_for(response).encode(response(message="on"))


def test_a_damaged_request_or_response_lets_the_call_fail(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(SERVICE, "/lamp", "std_srvs/srv/SetBool")
    manager(zbot, ros, log)
    answers = [FakeAnswer(), FakeAnswer()]
    serve = zbot.open("server")["/lamp"].call_back
    serve(b"\xc1", answers[0])
    serve(b"\x80", answers[1])
    ros.open("caller")["/lamp"].call_back.reply(b"")
    assert [type(answer.outcome) for answer in answers] == [CallError, CallError]


def test_a_service_of_both_sides_is_not_carried(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    for side in (zbot, ros):
        side.add(SERVICE, "/lamp", "std_srvs/srv/SetBool")
    assert manager(zbot, ros, log).carried == []
    assert log == ["the service /lamp exists in zbot and in ROS 2, so each keeps its own"]


def test_all_parts_of_an_action_are_carried(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    action, name = "test_msgs/action/Fibonacci", "/turn/_action"
    ros.add(SERVICE, f"{name}/send_goal", f"{action}_SendGoal")
    ros.add(SERVICE, f"{name}/get_result", f"{action}_GetResult")
    ros.add(SERVICE, f"{name}/cancel_goal", "action_msgs/srv/CancelGoal")
    ros.add(PUBLISHER, f"{name}/feedback", f"{action}_FeedbackMessage")
    ros.add(PUBLISHER, f"{name}/status", "action_msgs/msg/GoalStatusArray")
    for selection in (Selection(), Selection(actions=patterns(["/turn:in"]))):
        assert len(manager(zbot, ros, log, selection).carried) == 5
    for selection in (
        Selection(actions=patterns(["/turn:out"])),
        Selection(topics=patterns(["*"]), services=patterns(["*"])),
    ):
        assert manager(zbot, ros, log, selection).carried == []


def with_bridge(side: FakeSide, bridge: str, *offers: tuple[EntityKind, str]) -> None:
    side.present = replace(side.present, bridges={bridge: frozenset(offers)})


def test_of_two_bridges_the_one_with_the_smaller_id_carries(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    ros.add(SUBSCRIPTION, "/cmd_vel")
    with_bridge(ros, "a")
    with_bridge(zbot, "a", (PUBLISHER, "/scan"))
    assert manager(zbot, ros, log, own="b").carried == [("/cmd_vel", Direction.OUT)]
    assert {end.name for end in zbot.shown} == {"/cmd_vel"}
    with_bridge(ros, "c")
    with_bridge(zbot, "c", (PUBLISHER, "/scan"))
    assert len(manager(zbot, ros, log, own="b").carried) == 2


def test_a_bridge_to_another_robot_changes_nothing(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    with_bridge(zbot, "a", (PUBLISHER, "/scan"))
    assert manager(zbot, ros, log, own="b").carried == [("/scan", Direction.IN)]


def test_the_second_bridge_takes_over(zbot: FakeSide, ros: FakeSide, log: Lines) -> None:
    ros.add(PUBLISHER, "/scan")
    with_bridge(ros, "a")
    with_bridge(zbot, "a", (PUBLISHER, "/scan"))
    made = manager(zbot, ros, log, own="b")
    assert made.carried == []
    zbot.present = replace(zbot.present, bridges={})
    made.update()
    assert made.carried == [("/scan", Direction.IN)]


def test_at_first_a_bridge_leaves_to_another_one_what_it_carries(
    zbot: FakeSide, ros: FakeSide, log: Lines
) -> None:
    ros.add(PUBLISHER, "/scan")
    ros.add(PUBLISHER, "/pose")
    with_bridge(zbot, "a", (PUBLISHER, "/scan"))
    assert manager(zbot, ros, log, own="b", patience_s=60.0).carried == [("/pose", Direction.IN)]
