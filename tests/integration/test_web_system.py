from __future__ import annotations

import asyncio
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.node.errors import ServiceError
from zbot.observer.errors import ViewerError
from zbot.observer.system import System
from zbot.package.user_folders import definitions_folder
from zbot.remote.types import UnknownTypeError

from std_msgs.msg import Float64, String
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.conftest import Spinner


@pytest.fixture
def system(domain: int) -> Iterator[System]:
    with System(domain_id=domain) as system:
        yield system


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> zbot.Node:
    return zbot.Node("robot", context=make_context())


def publish_until(publisher: Any, message: Any, condition: Callable[[], bool]) -> None:
    def attempt() -> bool:
        publisher.publish(message)
        return condition()

    assert wait_until(attempt, 10)


def test_graph_is_read_and_changes_call_the_callbacks(
    system: System, make_context: Callable[[], zbot.Context]
) -> None:
    changed = threading.Event()
    undo = system.on_change(changed.set)
    node = zbot.Node("robot", context=make_context())
    assert changed.wait(5)
    assert wait_until(lambda: "robot" in [end.node for end in system.snapshot().nodes])
    assert system.snapshot() is system.snapshot()
    undo()
    undo()
    node.destroy_node()
    assert wait_until(lambda: "robot" not in [end.node for end in system.snapshot().nodes])


def test_watch_keeps_the_latest_and_counts(system: System, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with system.watch("/chatter") as watch:
        publish_until(publisher, String(data="hello"), lambda: watch.count >= 20)
        assert watch.type_name == "std_msgs/msg/String"
        assert watch.latest.data == "hello"
        assert watch.rate_hz > 0
        assert watch.bytes_per_second > watch.rate_hz
        assert watch.problem == ""


def test_a_jump_of_the_clock_does_not_change_the_rate(
    system: System, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with system.watch("/chatter") as watch:
        publish_until(publisher, String(data="hello"), lambda: watch.rate_hz > 0)
        later_ns = time.time_ns() + 3600 * 10**9
        monkeypatch.setattr(time, "time_ns", lambda: later_ns)
        assert watch.rate_hz > 0
        assert watch.bytes_per_second > 0


def test_watch_waits_for_an_unused_topic(system: System, node: zbot.Node) -> None:
    with system.watch("/later") as watch:
        assert watch.type_name is None
        publisher = node.create_publisher(String, "later", 10)
        publish_until(publisher, String(data="now"), lambda: watch.latest is not None)


def test_watches_of_a_topic_share_one_subscription(system: System, node: zbot.Node) -> None:
    node.create_publisher(String, "chatter", 10)
    assert wait_until(lambda: bool(system.snapshot().publishers("/chatter")))
    watches = [system.watch("/chatter") for _ in range(50)]
    assert system.watched_topics == ["/chatter"]
    assert wait_until(lambda: len(system.snapshot().subscriptions("/chatter")) == 1)
    for watch in watches:
        watch.release()
        watch.release()
    assert system.watched_topics == []
    assert wait_until(lambda: not system.snapshot().subscriptions("/chatter"))
    assert wait_until(lambda: node.count_subscribers("/chatter") == 0)


def test_paused_watch_has_no_subscription(system: System, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with system.watch("/chatter", is_active=False) as watch:
        assert system.watched_topics == []
        watch.resume()
        publish_until(publisher, String(data="one"), lambda: watch.latest is not None)
        watch.pause()
        assert system.watched_topics == []
        assert watch.latest.data == "one"
        watch.resume()
        publish_until(publisher, String(data="two"), lambda: watch.latest.data == "two")


def test_history_is_kept_on_request(system: System, node: zbot.Node) -> None:
    publisher = node.create_publisher(Float64, "x", 10)
    assert wait_until(lambda: bool(system.snapshot().publishers("/x")))
    with system.watch("/x") as plain, system.watch("/x", keep=5) as watch:
        assert wait_until(lambda: publisher.get_subscription_count() == 1)
        for _ in range(9):
            publisher.publish(Float64(data=1.0))
        assert wait_until(lambda: watch.count == 9)
        records = watch.since(0)
        assert len(records) == 5
        assert [record.number for record in records] == list(
            range(records[-1].number - 4, records[-1].number + 1)
        )
        assert watch.read(records[0]).data == 1.0
        assert records[-1].time_ns == pytest.approx(time.time_ns(), abs=60e9)
        assert list(watch.since(records[-1].number)) == []
        watch.release()
        assert list(plain.since(0)) == []


def test_latest_is_decoded_no_more_often_than_a_page_shows(
    system: System, node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    decoded = 0
    with system.watch("/chatter") as watch:
        publish_until(publisher, String(data="0"), lambda: watch.latest is not None)
        feed = watch._feed
        decode = feed.decode
        assert decode is not None

        def counted(payload: bytes) -> Any:
            nonlocal decoded
            decoded += 1
            return decode(payload)

        monkeypatch.setattr(feed, "decode", counted)
        began = time.monotonic()
        publish_until(publisher, String(data="1"), lambda: watch.latest and watch.count > 300)
        assert decoded <= 30 * (time.monotonic() - began) + 2


def test_latched_message_reaches_a_late_watch(system: System, node: zbot.Node) -> None:
    publisher = node.create_publisher(
        String, "map", zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL)
    )
    publisher.publish(String(data="floor 2"))
    assert wait_until(lambda: bool(system.snapshot().publishers("/map")))
    with system.watch("/map") as watch:
        assert wait_until(lambda: watch.latest is not None)


def test_unknown_type_is_reported_with_a_sentence(system: System) -> None:
    with system.watch("/x", "nobody_msgs/msg/Thing") as watch:
        assert wait_until(lambda: "no definition of" in watch.problem, 10)
    with pytest.raises(UnknownTypeError, match="nobody_msgs"):
        system.interface("nobody_msgs/msg/Thing")


def test_a_wrong_definition_on_this_machine_is_reported_with_a_sentence(system: System) -> None:
    file = definitions_folder() / "broken_msgs" / "msg" / "Broken.msg"
    file.parent.mkdir(parents=True)
    file.write_text("int32\n")
    with system.watch("/broken", "broken_msgs/msg/Broken") as watch:
        assert f"{file}:1" in watch.problem
    assert system.watched_topics == []


def test_message_of_another_type_is_not_shown(
    system: System, node: zbot.Node, make_context: Callable[[], zbot.Context]
) -> None:
    text = node.create_publisher(String, "mixed", 10)
    number = zbot.Node("other", context=make_context()).create_publisher(Float64, "mixed", 10)
    with system.watch("/mixed", "std_msgs/msg/String") as watch:
        number.publish(Float64(data=1.0))
        publish_until(text, String(data="text"), lambda: watch.count >= 1)
        assert watch.latest.data == "text"


def test_a_watch_follows_a_new_type_of_the_topic(system: System, node: zbot.Node) -> None:
    text = node.create_publisher(String, "changing", 10)
    with system.watch("/changing", keep=10) as watch:
        publish_until(text, String(data="text"), lambda: watch.latest is not None)
        node.destroy_publisher(text)
        number = node.create_publisher(Float64, "changing", 10)
        assert wait_until(lambda: watch.type_name == "std_msgs/msg/Float64")
        assert watch.latest_record == (None, None)
        assert not watch.since(0)
        publish_until(number, Float64(data=2.0), lambda: watch.latest is not None)
        assert watch.latest.data == 2.0


def test_a_watch_keeps_its_type_while_a_node_publishes_it(
    system: System, node: zbot.Node, make_context: Callable[[], zbot.Context]
) -> None:
    text = node.create_publisher(String, "mixed", 10)
    with system.watch("/mixed") as watch:
        publish_until(text, String(data="text"), lambda: watch.latest is not None)
        zbot.Node("other", context=make_context()).create_publisher(Float64, "mixed", 10)
        assert wait_until(lambda: len(system.snapshot().publishers("/mixed")) == 2)
        publish_until(text, String(data="again"), lambda: watch.latest.data == "again")
        assert watch.type_name == "std_msgs/msg/String"


def test_publisher_is_shared_and_destroyed_with_its_last_user(system: System) -> None:
    first = system.publisher("/cmd", "std_msgs/msg/String")
    second = system.publisher("/cmd", "std_msgs/msg/String")
    assert first.entity is second.entity
    first.release()
    assert len(system.snapshot().publishers("/cmd")) == 1
    second.release()
    assert wait_until(lambda: not system.snapshot().publishers("/cmd"))


def test_service_can_be_called_in_asyncio(
    system: System, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    def handle(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        if not request.data:
            raise ValueError("no")
        response.message = "done"
        return response

    node.create_service(SetBool, "switch", handle)
    spinner = spin(node)
    with system.client("/switch", "std_srvs/srv/SetBool") as reference:

        async def call(data: bool) -> Any:
            future = reference.entity.call_async(SetBool.Request(data=data))
            return await asyncio.wait_for(future, 10)

        assert asyncio.run(call(True)).message == "done"
        with pytest.raises(ServiceError, match="no"):
            asyncio.run(call(False))
    spinner.join()
    assert isinstance(spinner.error, ValueError)


def test_read_only_refuses_to_change_anything(domain: int) -> None:
    with System(read_only=True, domain_id=domain) as system:
        for make in (
            lambda: system.publisher("/cmd", "std_msgs/msg/String"),
            lambda: system.client("/switch", "std_srvs/srv/SetBool"),
            lambda: system.action_client("/fibonacci", "example_interfaces/action/Fibonacci"),
        ):
            with pytest.raises(ViewerError, match="read-only"):
                make()


def test_log_lines_of_all_nodes_are_kept(system: System, node: zbot.Node) -> None:
    node.get_logger().warning("low battery")
    assert wait_until(lambda: [line.text for line in system.logs.since(0)] == ["low battery"])
