from __future__ import annotations

import pytest

from zbot.wire.keys import domain_selector, encoded_type, encoding, parse_key, topic_key


@pytest.mark.parametrize(
    ("domain", "name", "key"),
    [(0, "/chatter", "0/chatter"), (17, "/turtle1/cmd_vel", "17/turtle1/cmd_vel")],
)
def test_a_topic_key_is_its_domain_and_name(domain: int, name: str, key: str) -> None:
    assert topic_key(domain, name) == key
    assert parse_key(key) == (domain, name)


@pytest.mark.parametrize(
    "key", ["", "0", "0/", "a/b", "-1/b", "/b", "²/b", "1234/b", "@/x", "@zbot/0"]
)
def test_a_key_without_a_topic_gives_none(key: str) -> None:
    assert parse_key(key) is None


def test_a_domain_has_one_selector() -> None:
    assert domain_selector(3) == "3/**"


def test_an_encoding_names_the_type() -> None:
    assert encoding("std_msgs/msg/String") == "application/msgpack;std_msgs/msg/String"
    assert encoded_type("application/msgpack;std_msgs/msg/String") == "std_msgs/msg/String"


@pytest.mark.parametrize("text", ["", "zenoh/bytes", "application/msgpack", "application/msgpack;"])
def test_an_encoding_without_type_gives_none(text: str) -> None:
    assert encoded_type(text) is None
