"""Tests of the CDR codec: bytes of Fast CDR, and any bytes without a crash."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import zbot  # noqa: F401 - makes the messages importable
from zbot.interfaces import get_message
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.wire.cdr import cdr_codec_for
from zbot.wire.codec import codec_for
from zbot.wire.errors import CodecError
from zbot.wire.serialization import deserialize_message, is_cdr, serialize_message

from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Empty, String, UInt8MultiArray
from std_srvs.srv import SetBool

#: Bytes of Fast CDR; its undefined padding is set to zero.
VECTORS = json.loads((Path(__file__).parent / "cdr_vectors.json").read_text(encoding="utf-8"))
TYPES = [LaserScan, PoseStamped, String, UInt8MultiArray, Empty]


@pytest.mark.parametrize("vector", VECTORS, ids=[vector["name"] for vector in VECTORS])
def test_bytes_are_those_of_fast_cdr(vector: dict[str, Any]) -> None:
    codec = cdr_codec_for(get_message(vector["type"]))
    data = bytes.fromhex(vector["cdr"])
    message = codec.decode(data)
    written = codec.encode(message)
    assert written == data[: len(written)]
    assert set(data[len(written) :]) <= {0}


def test_bytes_behind_the_message_are_ignored() -> None:
    data = serialize_message(String(data="hi"))
    assert deserialize_message(data + b"rest", String) == String(data="hi")


def test_big_endian_is_read() -> None:
    assert deserialize_message(bytes.fromhex("0000000000000003686900"), String).data == "hi"


@given(st.binary(max_size=200), st.sampled_from(TYPES))
def test_any_bytes_give_a_message_or_one_error(data: bytes, message_class: type[Any]) -> None:
    for prefix in (b"", b"\x00\x01\x00\x00", b"\x00\x00\x00\x00"):
        try:
            message = deserialize_message(prefix + data, message_class)
        except CodecError:
            continue
        assert deserialize_message(serialize_message(message), message_class) is not None


@given(st.binary(max_size=100))
def test_a_messagepack_message_is_not_detected_as_cdr(data: bytes) -> None:
    assert is_cdr(serialize_message(UInt8MultiArray(data=data)))
    assert not is_cdr(codec_for(UInt8MultiArray).encode(UInt8MultiArray(data=data)))


def test_a_wrong_sequence_length_allocates_no_memory() -> None:
    with pytest.raises(CodecError, match="longer than the bytes that follow"):
        deserialize_message(b"\x00\x01\x00\x00" + b"\xff\xff\xff\xff", String)


def test_a_message_of_another_class_is_refused() -> None:
    with pytest.raises(CodecError, match="cannot encode"):
        cdr_codec_for(PoseStamped).encode(String())


def test_a_service_is_not_a_message() -> None:
    with pytest.raises(NotAMessageTypeError):
        cdr_codec_for(SetBool)
