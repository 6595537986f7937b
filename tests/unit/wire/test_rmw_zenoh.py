"""The dialect of ROS 2, byte by byte as in the design of rmw_zenoh and as recorded on the wire."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import zenoh

from zbot.interfaces import get_interface, get_message, type_hash
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    QoSProfile,
    qos_profile_sensor_data,
)
from zbot.time import Duration
from zbot.wire import attachment
from zbot.wire.dialect import NATIVE, Dialect
from zbot.wire.errors import TokenError
from zbot.wire.messagepack.packing import pack
from zbot.wire.rmw_zenoh import HUMBLE, NO_HASH, ROS2, dds_type, dialect_of, ros_type
from zbot.wire.tokens import EndpointToken, EntityKind

STRING_HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
ADD_HASH = "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a"
STRING = f"std_msgs::msg::dds_::String_/{STRING_HASH}"
ADD = f"example_interfaces::srv::dds_::AddTwoInts_/{ADD_HASH}"
LISTENER = "aac3178e146ba6f1fc6e6a4085e77f21"
TALKER = "8b20917502ee955ac4476e0266340d5c"
# Printed in the design of rmw_zenoh, or recorded.
RECORDED = [
    f"@ros2_lv/2/{LISTENER}/0/0/NN/%/%/listener",
    f"@ros2_lv/2/{LISTENER}/0/10/MS/%/%/listener/%chatter/{STRING}/::,10:,:,:,,",
    f"@ros2_lv/2/{TALKER}/0/10/MP/%/%/talker/%chatter/{STRING}/::,7:,:,:,,",
    (
        "@ros2_lv/2/f9980ee0495eaafb3e38f0d19e2eae12/0/10/SS/%/%/add_two_ints_server/%add_two_ints/"
        f"{ADD}/::,10:,:,:,,"
    ),
    (
        "@ros2_lv/2/e1dc8d1b45ae8717fce78689cc655685/0/10/SC/%/%/add_two_ints_client/%add_two_ints/"
        f"{ADD}/::,10:,:,:,,"
    ),
    f"@ros2_lv/0/7ad86ba400170536c6f229f54b8dfe6/0/1/MP/%/%/plain/%latched/{STRING}/:1:,3:,:,:,,",
    f"@ros2_lv/0/a1/0/3/MP/%fleet%a/%fleet%robot1/cam/%fleet%robot1%text/{STRING}/2::,5:,:,:,,",
]
GIDS = {
    f"@ros2_lv/0/{LISTENER}/0/0/NN/%/%/listener": "5bd72f4daf53c0bb00c7394e7fc19547",
    f"@ros2_lv/0/{LISTENER}/0/10/MS/%/%/listener/%chatter/{STRING}/::,10:,:,:,,": (
        "f15f21d2fafc22891bb0db868309bfcb"
    ),
    f"@ros2_lv/0/{TALKER}/0/10/MP/%/%/talker/%chatter/{STRING}/::,7:,:,:,,": (
        "eb85fa883b7846dc448a4501890ad062"
    ),
}


def endpoint(
    name: str,
    type_name: str,
    *,
    kind: EntityKind = EntityKind.PUBLISHER,
    qos: QoSProfile | None = None,
    domain: int = 0,
    hash_text: str | None = None,
) -> EndpointToken:
    return EndpointToken(
        domain=domain,
        zid="a1",
        nid=0,
        eid=1,
        kind=kind,
        namespace="/",
        node="talker",
        name=name,
        type_name=type_name,
        type_hash=hash_text or type_hash(type_name),
        qos=qos or QoSProfile(depth=10),
    )


@pytest.mark.parametrize("key", RECORDED)
def test_a_recorded_token_is_read_and_written_again_byte_by_byte(key: str) -> None:
    token = ROS2.parse_token(key)
    assert token.key == key
    assert ROS2.with_key(replace(token, key="")).key == key


def test_a_recorded_token_has_the_facts_of_ros_2() -> None:
    token = ROS2.parse_token(RECORDED[2])
    assert isinstance(token, EndpointToken)
    assert (token.domain, token.zid, token.nid, token.eid) == (2, TALKER, 0, 10)
    assert (token.kind, token.node, token.namespace) == (EntityKind.PUBLISHER, "talker", "/")
    assert (token.name, token.type_name) == ("/chatter", "std_msgs/msg/String")
    assert token.type_hash == STRING_HASH
    assert token.qos.depth == 7


@pytest.mark.parametrize("key", GIDS)
def test_a_gid_is_that_of_ros_2(key: str) -> None:
    assert ROS2.parse_token(key).gid.hex() == GIDS[key]


@pytest.mark.parametrize(
    ("domain", "name", "type_name", "expected"),
    [
        (0, "/chatter", "std_msgs/msg/String", f"0/chatter/{STRING}"),
        (0, "/robot1/chatter", "std_msgs/msg/String", f"0/robot1/chatter/{STRING}"),
        (2, "/add_two_ints", "example_interfaces/srv/AddTwoInts", f"2/add_two_ints/{ADD}"),
        (
            0,
            "/fibonacci/_action/send_goal",
            "example_interfaces/action/Fibonacci_SendGoal",
            (
                "0/fibonacci/_action/send_goal/example_interfaces::action::dds_::Fibonacci_SendGoal_/"
                "RIHS01_d1a57fb2a4afe8c21e34fb10db206f16ce6729b28531141472df92277c55b557"
            ),
        ),
    ],
)
def test_keys_are_those_of_ros_2(domain: int, name: str, type_name: str, expected: str) -> None:
    token = endpoint(name, type_name, domain=domain)
    assert ROS2.data_key(token) == expected
    assert zenoh.KeyExpr(ROS2.topic_key(domain, name)).includes(zenoh.KeyExpr(expected))


LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
ROSOUT = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)


@pytest.mark.parametrize(
    ("profile", "text"),
    [
        (QoSProfile(depth=10), "::,10:,:,:,,"),
        (qos_profile_sensor_data, "2::,5:,:,:,,"),
        (QoSProfile(depth=42), "::,:,:,:,,"),
        (QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=0), "::2,:,:,:,,"),
        (LATCHED, ":1:,1:,:,:,,"),
        (QoSProfile(depth=1000), "::,1000:,:,:,,"),
        (ROSOUT, ":1:,1000:,:10,0:,,"),
        (
            QoSProfile(depth=10, deadline=Duration(nanoseconds=10**8)),
            "::,10:0,100000000:,:,,",
        ),
    ],
)
def test_the_text_of_a_profile_is_that_of_ros_2(profile: QoSProfile, text: str) -> None:
    token = ROS2.with_key(endpoint("/x", "std_msgs/msg/String", qos=profile))
    assert token.key.rpartition("/")[2] == text


@pytest.mark.parametrize("name", ["std_msgs/msg/String", "a/action/B_SendGoal", "Odd"])
def test_the_name_of_a_type_is_read_back(name: str) -> None:
    assert ros_type(dds_type(name)) == name


def test_a_type_in_another_form_stays_as_it_is() -> None:
    assert ros_type("std_msgs::msg::String") == "std_msgs::msg::String"
    assert ros_type("dds_") == "dds_"


def test_humble_has_a_text_in_place_of_the_hash() -> None:
    token = HUMBLE.with_key(endpoint("/chatter", "std_msgs/msg/String"))
    assert token.type_hash == NO_HASH
    assert token.key.endswith(f"%chatter/std_msgs::msg::dds_::String_/{NO_HASH}/::,10:,:,:,,")
    assert HUMBLE.data_key(token) == f"0/chatter/std_msgs::msg::dds_::String_/{NO_HASH}"
    assert HUMBLE.parse_token(token.key) == token


def test_the_tokens_of_a_domain_show_its_dialect() -> None:
    plain = ROS2.with_key(endpoint("/chatter", "std_msgs/msg/String")).key
    humble = HUMBLE.with_key(endpoint("/chatter", "std_msgs/msg/String")).key
    assert dialect_of([plain, RECORDED[0]]) is ROS2
    assert dialect_of([humble, "@ros2_lv/nonsense"]) is HUMBLE
    assert dialect_of([humble, plain]) is ROS2
    assert dialect_of([]) is ROS2
    assert dialect_of([RECORDED[0]], distro="humble") is HUMBLE
    assert dialect_of([plain], distro="humble") is ROS2


def test_a_subscription_to_images_also_gets_the_buffers_of_lyrical() -> None:
    image = endpoint("/camera", "sensor_msgs/msg/Image", kind=EntityKind.SUBSCRIPTION)
    token, key = ROS2.with_key(image), ROS2.data_key(image)
    assert token.key.endswith("/::,10:,:,:,,/backends:cpu:")
    assert ROS2.parse_token(token.key) == token
    selector = zenoh.KeyExpr(ROS2.subscription_key(token))
    assert selector.includes(zenoh.KeyExpr(key))
    assert selector.includes(zenoh.KeyExpr(f"{key}/_buf_cpu"))
    assert not ROS2.refusal(f"{key}/_buf_cpu", "", "")
    assert ROS2.refusal(f"{key}/_buf/00ff", "", "")


@pytest.mark.parametrize(
    "token",
    [
        endpoint("/camera", "sensor_msgs/msg/Image"),
        endpoint("/x", "std_msgs/msg/String", kind=EntityKind.SUBSCRIPTION),
        endpoint("/map", "sensor_msgs/msg/Image", kind=EntityKind.SUBSCRIPTION, qos=LATCHED),
    ],
)
def test_other_endpoints_use_the_key_of_the_topic_only(token: EndpointToken) -> None:
    assert ROS2.subscription_key(token) == ROS2.data_key(token)
    assert "backends" not in ROS2.with_key(token).key


@pytest.mark.parametrize(
    "key", [RECORDED[0].replace("@ros2_lv", "@zbot"), RECORDED[1][:-12], "@ros2_lv/2//0/0/NN/%/%/x"]
)
def test_a_token_of_another_form_is_an_error(key: str) -> None:
    with pytest.raises(TokenError):
        ROS2.parse_token(key)


def test_selectors_match_the_tokens_of_ros_2() -> None:
    (selector,) = ROS2.token_selectors(2)
    for key in RECORDED[:5]:
        assert zenoh.KeyExpr(selector).includes(zenoh.KeyExpr(key))
        namesakes = ROS2.namesake_selector(ROS2.parse_token(key))
        assert zenoh.KeyExpr(namesakes).includes(zenoh.KeyExpr(key))


def test_a_type_selector_matches_the_endpoints_of_ros_2() -> None:
    tokens = [(key, ROS2.parse_token(key)) for key in RECORDED]
    endpoints = [(key, token) for key, token in tokens if isinstance(token, EndpointToken)]
    assert endpoints
    for key, token in endpoints:
        selector = ROS2.type_selector(token.domain, token.kind, token.type_name)
        assert zenoh.KeyExpr(selector).includes(zenoh.KeyExpr(key))


def test_an_attachment_of_another_form_is_refused_with_a_reason() -> None:
    assert "no attachment" in ROS2.attachment_refusal(None)
    assert "78 bytes" in ROS2.attachment_refusal(78)
    assert not NATIVE.attachment_refusal(None)


def test_an_attachment_is_that_of_ros_2() -> None:
    packed = attachment.pack(1, 1700000000123456789, bytes(range(16)))
    expected = "010000000000000015cd853dfe9c971710000102030405060708090a0b0c0d0e0f"
    assert packed.hex() == expected


@pytest.mark.parametrize("dialect", [NATIVE, ROS2])
def test_bytes_in_either_format_become_the_payload_of_the_dialect(dialect: Dialect) -> None:
    cls: Any = get_message("std_msgs/msg/String")
    cdr = bytes.fromhex("00010000030000006869 00".replace(" ", ""))
    payload = dialect.codec_for(cls).encode(cls(data="hi"))
    assert dialect.payload_of(cdr, cls) == payload
    assert dialect.payload_of(pack({"data": "hi"}), cls) == payload
    assert dialect.raw_decoder(cls)(payload) == cdr


def test_the_payloads_are_the_recorded_ones() -> None:
    vectors = json.loads((Path(__file__).parent / "cdr_vectors.json").read_text(encoding="utf-8"))
    for vector in vectors:
        cls: Any = get_message(vector["type"])
        data = bytes.fromhex(vector["cdr"])
        codec = ROS2.codec_for(cls)
        assert codec.encode(codec.decode(data)) == data


def test_the_type_hashes_of_services_are_those_of_ros_2() -> None:
    assert type_hash(get_interface("example_interfaces/srv/AddTwoInts")) == ADD_HASH


def test_a_type_error_of_a_node_is_a_text() -> None:
    assert ROS2.error_payload(ValueError("too hot"))[0] == b"ValueError: too hot"
