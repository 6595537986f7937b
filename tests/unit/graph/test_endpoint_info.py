from __future__ import annotations

import pytest

from zbot.graph.endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum, TypeHash
from zbot.qos import QoSProfile

TEXT = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"


def test_a_hash_is_parsed_and_printed() -> None:
    parsed = TypeHash.parse(TEXT)
    assert (parsed.version, len(parsed.value), str(parsed)) == (1, 32, TEXT)
    assert parsed == TypeHash(1, parsed.value)


def test_a_misspelt_field_is_refused() -> None:
    for thing in (TypeHash(), TopicEndpointInfo()):
        with pytest.raises(AttributeError):
            thing.vale = b""  # type: ignore[union-attr]  # pyright: ignore[reportAttributeAccessIssue]


def test_other_texts_are_invalid_hashes() -> None:
    assert {str(TypeHash.parse(text)) for text in ("", "RIHS01_xy", "RIHS01_00")} == {"INVALID"}
    assert str(TypeHash()) == "INVALID"


def test_an_endpoint_prints_as_topic_info_does() -> None:
    info = TopicEndpointInfo(
        node_name="eye",
        node_namespace="/robot",
        topic_type="std_msgs/msg/String",
        topic_type_hash=TypeHash.parse(TEXT),
        endpoint_type=TopicEndpointTypeEnum.PUBLISHER,
        endpoint_gid=[1, 255],
        qos_profile=QoSProfile(depth=7),
    )
    lines = str(info).splitlines()
    assert lines[:6] == [
        "Node name: eye",
        "Node namespace: /robot",
        "Topic type: std_msgs/msg/String",
        f"Topic type hash: {TEXT}",
        "Endpoint type: PUBLISHER",
        "GID: 01.ff",
    ]
    assert "  History (Depth): KEEP_LAST (7)" in lines


def test_default_endpoint_info_can_be_printed() -> None:
    assert "Endpoint type: INVALID" in str(TopicEndpointInfo())
