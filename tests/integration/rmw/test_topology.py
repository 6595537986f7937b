"""Ways between sessions of ROS 2, which zbot chooses by itself, and distributions of ROS 2."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.conftest import wait_until
from tests.integration.conftest import lines_about
from tests.integration.rmw.ros2_node import STRING, Ros2Node, string, text_of
from zbot.classroom.hub.address import own_addresses
from zbot.interfaces import type_hash
from zbot.transport.config import MEETING_PORT
from zbot.transport.errors import NoRouterError, SettingError
from zbot.transport.rmw_meeting import RmwRouter
from zbot.wire.rmw_zenoh import HUMBLE, NO_HASH, ROS2

from sensor_msgs.msg import Image
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

    import zbot
    from tests.conftest import Spin
    from tests.integration.rmw.conftest import MakeNode, MakePlain, SetRouter
    from zbot.log.record import Record

OVERRIDE = "ZENOH_CONFIG_OVERRIDE"
# A peer that neither listens nor connects to other peers, as on another machine.
APART = {"listen__endpoints": [], "scouting__gossip__enabled": False}


def hear(node: zbot.Node, spin: Spin) -> list[str]:
    heard: list[str] = []
    node.create_subscription(String, "chatter", lambda msg: heard.append(msg.data), 10)
    spin(node)
    return heard


def say(plain: Ros2Node, heard: list[str], text: str = "hi") -> bool:
    publisher = plain.publisher("/chatter")

    def arrived() -> bool:
        publisher.put(string(text), attachment=plain.attachment())
        return text in heard

    return wait_until(arrived)


def test_a_node_is_a_peer_beside_its_router(plain: Ros2Node, node: zbot.Node) -> None:
    peers = {str(zid) for zid in node.context.session.info.peers_zid()}
    assert plain.zid in peers


def test_a_node_is_a_client_if_it_cannot_link_to_the_peers_of_its_router(
    router: str, make_plain: MakePlain, make_node: MakeNode, spin: Spin
) -> None:
    assert router
    plain = make_plain(**APART)
    node = make_node()
    assert list(node.context.session.info.peers_zid()) == []
    assert say(plain, hear(node, spin))


def test_a_peer_that_must_be_a_peer_says_that_nothing_can_be_heard(
    router: str,
    make_plain: MakePlain,
    make_node: MakeNode,
    spin: Spin,
    logged: list[Record],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(OVERRIDE, f'mode="peer";connect/endpoints=["{router}"]')
    plain = make_plain(**APART)
    plain.publisher("/chatter")
    heard = hear(make_node(), spin)
    assert wait_until(lambda: bool(lines_about(logged, "nothing is heard from /plain")), 10)
    (line,) = lines_about(logged, "nothing is heard")
    assert """ZENOH_CONFIG_OVERRIDE='mode="client"'""" in line
    assert heard == []


def test_programs_hear_each_other_without_a_router(
    endpoint: str,
    make_plain: MakePlain,
    make_node: MakeNode,
    spin: Spin,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(OVERRIDE, f'mode="peer";connect/endpoints=["{endpoint}"]')
    plain = make_plain(to="", listen__endpoints=[endpoint])
    node = make_node()
    assert say(plain, hear(node, spin))
    samples = plain.subscribe("/answer")
    publisher = node.create_publisher(String, "answer", 10)

    def arrived() -> bool:
        publisher.publish(String(data="here"))
        return bool(samples)

    assert wait_until(arrived)
    assert text_of(samples[0].payload.to_bytes()) == "here"


def test_a_node_is_a_client_of_a_router_on_another_machine(
    free_domain: int, make_plain: MakePlain, make_node: MakeNode, spin: Spin, set_router: SetRouter
) -> None:
    own = own_addresses()
    if not own:
        pytest.skip("this machine has only loopback addresses")
    port = MEETING_PORT + free_domain
    set_router(f"tcp/{own[0]}:{port}")
    with RmwRouter([f"tcp/0.0.0.0:{port}"], []).open():
        node = make_node()
        assert list(node.context.session.info.peers_zid()) == []
        assert say(make_plain(), hear(node, spin))


def test_two_linked_routers_join_the_programs_of_two_machines(
    router: str,
    free_domain: int,
    make_plain: MakePlain,
    make_node: MakeNode,
    spin: Spin,
    set_router: SetRouter,
) -> None:
    plain = make_plain(**APART)
    own = f"tcp/127.0.0.1:{MEETING_PORT + 2000 + free_domain}"
    set_router(own)
    with RmwRouter([own], [router]).open():
        node = make_node()
        assert say(plain, hear(node, spin))
        samples = plain.subscribe("/answer")
        publisher = node.create_publisher(String, "answer", 10)
        assert wait_until(lambda: publisher.get_subscription_count() == 1)
        publisher.publish(String(data="from here"))
        assert wait_until(lambda: bool(samples))


@pytest.mark.parametrize("where", ["variable", "file"])
def test_a_client_without_a_router_is_an_error(
    where: str,
    endpoint: str,
    make_node: MakeNode,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    if where == "variable":
        monkeypatch.setenv(OVERRIDE, f'mode="client";connect/endpoints=["{endpoint}"]')
    else:
        file = tmp_path / "ros.json5"
        file.write_text('{ mode: "client" }', encoding="utf-8")
        monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    with pytest.raises(NoRouterError, match=endpoint):
        make_node()


def test_a_node_without_a_router_warns_once_and_is_found_later(
    endpoint: str, make_plain: MakePlain, make_node: MakeNode, spin: Spin, logged: list[Record]
) -> None:
    heard = hear(make_node(), spin)
    line = lines_about(logged, "no Zenoh router answers")[0]
    assert endpoint in line
    assert "`zbot hub --rmw`" in line
    with RmwRouter([endpoint], []).open():
        assert say(make_plain(), heard)


def test_a_negative_number_of_attempts_warns_of_nothing(
    endpoint: str, make_node: MakeNode, logged: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert endpoint
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "-1")
    make_node()
    assert lines_about(logged, "router") == []


def test_a_number_of_attempts_that_is_no_number_is_refused(
    endpoint: str, make_node: MakeNode, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert endpoint
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", "often")
    with pytest.raises(SettingError, match="ZENOH_ROUTER_CHECK_ATTEMPTS is 'often'"):
        make_node()


def test_a_router_on_another_machine_that_does_not_answer_is_an_error(
    endpoint: str, make_node: MakeNode, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert endpoint
    monkeypatch.setenv(OVERRIDE, 'connect/endpoints=["tcp/192.0.2.1:7447"];connect/timeout_ms=1')
    with pytest.raises(NoRouterError, match=r"tcp/192\.0\.2\.1:7447"):
        make_node()


def test_a_node_speaks_as_humble_if_the_others_do(
    plain: Ros2Node, make_node: MakeNode, spin: Spin
) -> None:
    samples = plain.subscribe("/answer", (STRING[0], NO_HASH))
    assert wait_until(lambda: any("%answer" in token for token in plain.tokens()))
    node = make_node()
    assert node.context.dialect is HUMBLE
    publisher = node.create_publisher(String, "answer", 10)

    def arrived() -> bool:
        publisher.publish(String(data="hi"))
        return bool(samples)

    assert wait_until(arrived)
    heard = hear(node, spin)
    late = plain.publisher("/chatter", (STRING[0], NO_HASH))

    def heard_it() -> bool:
        late.put(string("old"), attachment=plain.attachment())
        return "old" in heard

    assert wait_until(heard_it)


def test_an_image_in_a_buffer_of_lyrical_arrives_once(
    plain: Ros2Node, node: zbot.Node, spin: Spin
) -> None:
    heard: list[Image] = []
    subscription = node.create_subscription(Image, "camera", heard.append, 10)
    spin(node)
    of_type = ("sensor_msgs::msg::dds_::Image_", type_hash(Image))
    key = plain.announce("MP", "/camera", of_type, "::,10:,:,:,,/backends:cpu:")
    assert wait_until(lambda: subscription.get_publisher_count() == 1)
    encode = ROS2.codec_for(Image).encode
    gid = bytes(16)
    for number, where in enumerate(("_buf_cpu", "_buf/00ff", ""), 1):
        payload = encode(Image(height=number))
        facts = plain.attachment(number, gid)
        plain.session.put(f"{key}/{where}".rstrip("/"), payload, attachment=facts)
    assert wait_until(lambda: len(heard) == 2)
    assert [image.height for image in heard] == [1, 3]
