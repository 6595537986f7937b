"""Tests of `zbot mqtt` with a real broker."""

from __future__ import annotations

import socket
import subprocess
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.mosquitto import Mosquitto, Thing, needs_mosquitto
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.security.certificate import Validity, issue, make_authority

from std_msgs.msg import Bool, Float32, Int32, String

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from tests.conftest import MakeContext, Program, Spin, Start

pytestmark = needs_mosquitto
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def broker(tmp_path: Path) -> Iterator[Mosquitto]:
    made = Mosquitto(tmp_path)
    yield made
    made.stop()


@pytest.fixture
def thing(broker: Mosquitto) -> Iterator[Thing]:
    made = Thing(broker.port, "cmnd/#", "robot/#", "latched")
    yield made
    made.close()


@pytest.fixture
def node(make_context: MakeContext, spin: Spin) -> zbot.Node:
    made = zbot.Node("computer", context=make_context())
    spin(made)
    return made


def hear(node: zbot.Node, topic: str, kind: type[Any], profile: Any = 20000) -> list[Any]:
    heard: list[Any] = []
    node.create_subscription(kind, topic, lambda message: heard.append(message.data), profile)
    return heard


def started(start: Start, broker: Mosquitto, *words: str) -> Program:
    program = start("zbot", "mqtt", broker.address, *words)
    program.wait_for("connected with the broker")
    return program


def publish_home(thing: Thing) -> None:
    thing.publish("home/living-room/light", "ON")
    thing.publish("tele/plug/SENSOR", '{"Time": "8:00", "ENERGY": {"Power": 23.5}}')
    thing.publish("other/a", "5")


def test_topics_of_the_broker_are_topics(
    broker: Mosquitto, thing: Thing, start: Start, node: zbot.Node
) -> None:
    light = hear(node, "/home/living_room/light", Bool)
    power = hear(node, "/tele/plug/SENSOR/ENERGY/Power", Float32)
    program = started(start, broker, "--from", "home/#", "tele/+/SENSOR")
    publish_home(thing)
    program.wait_for("new topic /tele/plug/SENSOR/ENERGY/Power (std_msgs/msg/Float32)")
    assert "new topic /home/living_room/light (std_msgs/msg/Bool)" in program.output
    assert wait_until(lambda: node.count_publishers("/tele/plug/SENSOR/ENERGY/Power") > 0)
    publish_home(thing)  # the first message of a topic may come before the subscription
    assert wait_until(lambda: bool(light and power))
    assert (light[-1], power[-1]) == (True, 23.5)
    thing.publish("home/end", "1")
    program.wait_for("new topic /home/end")
    assert node.count_publishers("/other/a") == 0
    program.stop()
    assert "5 messages received, 7 published, 0 lost" in program.output


def test_topics_go_to_the_broker_by_name_and_by_pattern(
    broker: Mosquitto, thing: Thing, start: Start, node: zbot.Node
) -> None:
    led = node.create_publisher(Bool, "/led", 10)
    speed = node.create_publisher(Float32, "/robot/speed", 10)
    started(start, broker, "--to", "/led:std_msgs/msg/Bool=cmnd/lamp/POWER", "/robot/*")
    assert wait_until(lambda: led.get_subscription_count() + speed.get_subscription_count() == 2)
    led.publish(Bool(data=True))
    speed.publish(Float32(data=0.5))
    assert wait_until(lambda: len(thing.heard) == 2)
    assert sorted(thing.heard) == [
        ("cmnd/lamp/POWER", "ON", False),
        ("robot/speed", "0.5", False),
    ]


def test_a_topic_is_not_sent_back(
    broker: Mosquitto, thing: Thing, start: Start, node: zbot.Node
) -> None:
    count = hear(node, "/robot/count", Int32)
    program = started(start, broker, "--from", "#", "--to", "/*", "--type", "robot/count:Int32")
    other = node.create_publisher(Int32, "/robot/other", 10)
    assert wait_until(lambda: other.get_subscription_count() == 1)
    thing.publish("robot/count", "1")
    assert wait_until(lambda: node.count_publishers("/robot/count") == 1)
    thing.publish("robot/count", "2")
    other.publish(Int32(data=5))
    assert wait_until(lambda: count[-1:] == [2] and ("robot/other", "5", False) in thing.heard)
    thing.publish("robot/count", "3")
    assert wait_until(lambda: count[-1:] == [3])
    program.stop()
    assert "3 messages received, 3 published, 1 sent, 0 lost" in program.output
    assert [text for topic, text, _ in thing.heard if topic == "robot/count"] == ["1", "2", "3"]


def test_retained_messages_are_latched_both_ways(
    broker: Mosquitto, thing: Thing, start: Start, node: zbot.Node
) -> None:
    thing.publish("home/state", "open", is_retained=True)
    node.create_publisher(Int32, "/latched", LATCHED).publish(Int32(data=5))
    program = started(start, broker, "--from", "home/#", "--to", "/latched")
    program.see("new topic /home/state")
    state = hear(node, "/home/state", String, LATCHED)
    assert wait_until(lambda: state == ["open"])
    thing.publish("home/state", "closed", is_retained=True)
    assert wait_until(lambda: state == ["open", "closed"])
    assert wait_until(lambda: ("latched", "5", False) in thing.heard)
    late = Thing(broker.port, "latched")
    assert wait_until(lambda: late.heard == [("latched", "5", True)])
    late.close()
    thing.publish("home/state", "", is_retained=True)
    assert wait_until(lambda: node.count_publishers("/home/state") == 0)


def test_a_broker_that_restarts_is_found_again(
    broker: Mosquitto, start: Start, node: zbot.Node
) -> None:
    count = hear(node, "/home/count", Int32)
    program = started(start, broker, "--from", "home/#")
    broker.stop()
    program.wait_for("is gone: waiting until it is back")
    broker.start()
    program.wait_for("is back")
    thing = Thing(broker.port)
    thing.publish("home/count", "1")
    program.wait_for("new topic /home/count")
    assert wait_until(lambda: node.count_publishers("/home/count") == 1)
    thing.publish("home/count", "2")
    assert wait_until(lambda: count[-1:] == [2])
    thing.close()


def test_five_thousand_messages_in_a_second_arrive(
    broker: Mosquitto, thing: Thing, start: Start, node: zbot.Node
) -> None:
    count = hear(node, "/home/count", Int32)
    program = started(start, broker, "--from", "home/#")
    thing.publish("home/count", "-1")
    assert wait_until(lambda: node.count_publishers("/home/count") == 1)
    begun, pause = time.monotonic(), threading.Event()
    for number in range(5000):
        thing.publish("home/count", str(number))
        pause.wait(max(0.0, begun + number / 5000 - time.monotonic()))
    assert wait_until(lambda: count[-1:] == [4999])
    program.stop()
    assert "5001 messages received, 5001 published, 0 lost" in program.output


def test_a_user_needs_the_right_password(tmp_path: Path, start: Start) -> None:
    passwords = tmp_path / "passwords"
    passwords.write_text("ana:secret\n")
    subprocess.run(["mosquitto_passwd", "-U", str(passwords)], check=True)
    passwords.chmod(0o644)
    broker = Mosquitto(tmp_path, "allow_anonymous false", f"password_file {passwords}")
    words = ("zbot", "mqtt", broker.address, "--from", "home/#")
    stranger = start(*words)
    assert "asks for a user and a password: use --user" in stranger.wait_for("asks for")
    assert stranger.wait() == 1
    wrong = start(*words, "--user", "ana", env={"ZBOT_MQTT_PASSWORD": "x"})
    wrong.wait_for("the broker refuses ana: is the password in ZBOT_MQTT_PASSWORD right?")
    right = start(*words, "--user", "ana", env={"ZBOT_MQTT_PASSWORD": "secret"})
    right.wait_for("connected with the broker")
    broker.stop()


def test_without_a_broker_one_sentence_says_so(start: Start) -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    program = start("zbot", "mqtt", f"127.0.0.1:{port}", "--from", "#")
    program.wait_for(f"no MQTT broker answers on 127.0.0.1:{port}: Connection refused")
    assert program.wait() == 1


def test_an_encrypted_connection_needs_the_authority(tmp_path: Path, start: Start) -> None:
    authority = make_authority(Validity.days(2))
    pair = issue(authority, "broker", ["127.0.0.1"], Validity.days(1))
    files = {"ca.pem": authority.certificate, "cert.pem": pair.certificate, "key.pem": pair.key}
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
        (tmp_path / name).chmod(0o644)
    broker = Mosquitto(
        tmp_path,
        "allow_anonymous true",
        *(
            f"{setting} {tmp_path / name}"
            for setting, name in (
                ("cafile", "ca.pem"),
                ("certfile", "cert.pem"),
                ("keyfile", "key.pem"),
            )
        ),
    )
    words = ("zbot", "mqtt", f"mqtts://{broker.address}", "--from", "home/#")
    assert "certificate" in start(*words).wait_for("no MQTT broker answers")
    start(*words, "--ca", str(tmp_path / "ca.pem")).wait_for("connected with the broker")
    broker.stop()
