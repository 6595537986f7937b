from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from zbot.bridge.devices.errors import DeviceError, UnreadableError
from zbot.bridge.devices.mqtt import client
from zbot.bridge.devices.mqtt.address import BrokerAddress, parse_address
from zbot.bridge.devices.mqtt.client import BrokerClient
from zbot.bridge.devices.mqtt.payload import read_payload
from zbot.interfaces.yaml_message import Word


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("broker", BrokerAddress("broker", 1883)),
        ("broker:1884", BrokerAddress("broker", 1884)),
        ("mqtts://broker", BrokerAddress("broker", 8883, has_tls=True)),
        ("mqtt://ana:a%40b@broker", BrokerAddress("broker", 1883, "ana", "a@b")),
        ("[::1]:1883", BrokerAddress("::1", 1883)),
    ],
)
def test_an_address_has_a_host_a_port_and_a_user(text: str, address: BrokerAddress) -> None:
    assert parse_address(text) == address


def test_encryption_has_a_port_of_its_own() -> None:
    assert parse_address("broker", has_tls=True).port == 8883


@pytest.mark.parametrize("text", ["", "http://a", "a:x", "a:99999", "mqtt://a/b", "[::1"])
def test_a_wrong_address_is_one_sentence(text: str) -> None:
    with pytest.raises(DeviceError, match="is not the address of a broker"):
        parse_address(text)


@pytest.mark.parametrize(
    ("payload", "value"),
    [
        (b"23.5", 23.5),
        (b"ON", True),
        (b"online", "online"),
        (b'"a"', "a"),
        (b"{x", "{x"),
        (b"23.5 \xc2\xb0C", 23.5),
    ],
)
def test_a_payload_is_a_number_a_bool_or_a_word(payload: bytes, value: object) -> None:
    word = read_payload(payload)
    assert isinstance(word, Word)
    assert word.value == value


def test_a_payload_may_be_json() -> None:
    assert read_payload(b'{"ENERGY": {"Power": 5}}') == {"ENERGY": {"Power": 5}}
    assert read_payload(b"[1, 2]") == [1, 2]


def test_a_payload_that_is_no_text_is_refused() -> None:
    with pytest.raises(UnreadableError, match="it is not text"):
        read_payload(b"\xff\xd8\xff")


class Code:
    """Answer of a broker."""

    def __init__(self, refusal: str = "") -> None:
        self.is_failure = bool(refusal)
        self._refusal = refusal

    def __str__(self) -> str:
        return self._refusal


class FakeMqtt:
    """Client of paho-mqtt without a broker. `connection` and `answers` are the broker's answers."""

    protocol = 4  # its subscriptions have no options

    def __init__(self, *answers: str) -> None:
        self.connection, self.answers = "", list(answers)

    def __getattr__(self, _name: str) -> Any:
        return lambda *_: None

    def loop_start(self) -> None:
        self.on_connect(self, None, None, Code(self.connection), None)

    def subscribe(self, _filters: Any) -> None:
        self.on_subscribe(self, None, 1, list(map(Code, self.answers)), None)

    def lose(self) -> None:
        self.on_disconnect(self, None, None, Code("Unspecified error"), None)


class Lines(list[str]):
    def info(self, message: str) -> None:
        self.append(message)

    warning = info


def connect(fake: FakeMqtt, monkeypatch: pytest.MonkeyPatch) -> Lines:
    library = SimpleNamespace(
        Client=lambda *_, **__: fake,
        CallbackAPIVersion=SimpleNamespace(VERSION2=2),
        MQTTProtocolVersion=int,
    )
    monkeypatch.setattr(client, "mqtt_library", lambda: library)
    lines = Lines()
    log: Any = lines
    BrokerClient(BrokerAddress("broker", 1883), log, ["home/#", "lab/#"], lambda _: None)
    return lines


def test_a_refused_filter_ends_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(DeviceError, match=r"the broker refuses lab/# \(Not authorized\)$"):
        connect(FakeMqtt("", "Not authorized"), monkeypatch)


def test_a_filter_that_is_refused_later_is_logged(monkeypatch: pytest.MonkeyPatch) -> None:
    fake = FakeMqtt("", "")
    lines = connect(fake, monkeypatch)
    fake.answers = ["Not authorized", ""]
    for _ in range(2):
        fake.lose()
        fake.loop_start()
    assert lines == 2 * [
        "the broker broker:1883 is gone: waiting until it is back",
        "broker:1883: the broker refuses home/# (Not authorized)",
    ]


def test_a_broker_that_is_back_and_refuses_is_logged_once(monkeypatch: pytest.MonkeyPatch) -> None:
    fake = FakeMqtt("", "")
    lines = connect(fake, monkeypatch)
    fake.lose()
    lines.clear()
    fake.connection = "Server busy"
    for _ in range(3):
        fake.loop_start()
        fake.lose()
    fake.connection = ""
    fake.loop_start()
    assert lines == [
        "broker:1883: the broker refuses: Server busy",
        "the broker broker:1883 is back",
    ]
