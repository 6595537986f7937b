from __future__ import annotations

import pytest

from zbot.devices.errors import DeviceError, UnreadableError
from zbot.devices.mqtt.address import BrokerAddress, parse_address
from zbot.devices.mqtt.payload import read_payload
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
