from __future__ import annotations

from dataclasses import replace

import pytest
import zenoh
from hypothesis import given
from hypothesis import strategies as st

from zbot.qos import qos_profile_sensor_data
from zbot.wire.attachment import GID_LENGTH
from zbot.wire.errors import TokenError
from zbot.wire.qos import qos_text
from zbot.wire.tokens import (
    EndpointToken,
    EntityKind,
    NodeToken,
    gid_of,
    namesake_selector,
    parse_token,
    token_selector,
    type_selector,
)

ZID = "aac3178e146ba6f1fc6e6a4085e77f21"
NODE_KEY = f"@zbot/2/{ZID}/0/0/NN/%/%fleet%robot1/lidar"
ENDPOINT_KEY = (
    f"@zbot/2/{ZID}/0/10/MP/%/%/talker/%robot1%chatter/std_msgs%msg%String/RIHS01_df66/2::,5:,:,:,,"
)

node = NodeToken(domain=2, zid=ZID, nid=0, namespace="/fleet/robot1", node="lidar")
endpoint = EndpointToken(
    domain=2,
    zid=ZID,
    nid=0,
    eid=10,
    kind=EntityKind.PUBLISHER,
    namespace="/",
    node="talker",
    name="/robot1/chatter",
    type_name="std_msgs/msg/String",
    type_hash="RIHS01_df66",
    qos=qos_profile_sensor_data,
)


def test_tokens_have_the_documented_form() -> None:
    assert node.key == NODE_KEY
    assert endpoint.key == ENDPOINT_KEY


def test_a_token_read_back_has_the_same_facts() -> None:
    read = parse_token(NODE_KEY)
    assert read == node
    assert (read.kind, read.namespace, read.node, read.enclave) == (
        EntityKind.NODE,
        "/fleet/robot1",
        "lidar",
        "/",
    )


def test_an_endpoint_read_back_has_the_same_facts() -> None:
    read = parse_token(ENDPOINT_KEY)
    assert isinstance(read, EndpointToken)
    assert read == endpoint
    for fact in ("domain", "zid", "nid", "eid", "kind", "namespace", "node", "name", "enclave"):
        assert getattr(read, fact) == getattr(endpoint, fact)
    assert (read.type_name, read.type_hash) == ("std_msgs/msg/String", "RIHS01_df66")
    assert qos_text(read.qos) == qos_text(qos_profile_sensor_data)


def test_chunks_of_a_later_version_are_ignored() -> None:
    read = parse_token(ENDPOINT_KEY + "/shm/more")
    assert isinstance(read, EndpointToken)
    assert read.name == "/robot1/chatter"
    assert read.key == ENDPOINT_KEY + "/shm/more"
    assert parse_token(NODE_KEY + "/more").key == NODE_KEY + "/more"


def test_tokens_work_in_sets() -> None:
    assert {node, endpoint, parse_token(NODE_KEY), parse_token(ENDPOINT_KEY)} == {node, endpoint}
    assert node != endpoint


@pytest.mark.parametrize(
    ("key", "reason"),
    [
        ("", "begin with @zbot"),
        ("@ros2_lv/0/a/0/0/NN/%/%/x", "begin with @zbot"),
        (f"@zbot/2/{ZID}/0/0/NN/%/%", "8 chunks"),
        (f"@zbot/2/{ZID}/0/10/MP/%/%/talker", "an endpoint needs 13"),
        (NODE_KEY.replace(ZID, ""), "empty chunk"),
        (NODE_KEY.replace("lidar", "li\x1bdar"), "control character"),
        (NODE_KEY.replace("@zbot/2", "@zbot/x"), "'x' is not a number"),
        (NODE_KEY.replace("@zbot/2", "@zbot/" + "9" * 5000), "is not a number"),
        (ENDPOINT_KEY.replace("/MP/", "/XX/"), "XX"),
        (ENDPOINT_KEY.replace("/2::,5:,:,:,,", "/nonsense"), "QoS 'nonsense'"),
    ],
)
def test_an_invalid_token_is_an_error_with_the_reason(key: str, reason: str) -> None:
    with pytest.raises(TokenError, match=reason) as caught:
        parse_token(key)
    assert caught.value.key == key


@given(
    st.lists(st.sampled_from(["@zbot", "0", "x", "", "NN", "MP", "%", "::,:,:,:,,"]), max_size=15)
)
def test_any_key_is_a_token_or_a_token_error(chunks: list[str]) -> None:
    try:
        token = parse_token("/".join(["@zbot", *chunks]))
    except TokenError:
        return
    assert parse_token(token.key) == token


def test_a_gid_is_stable_and_short() -> None:
    assert endpoint.gid == gid_of(ENDPOINT_KEY)
    assert gid_of("@zbot/0/a/0/0/NN/%/%/x").hex() == "d068bcfd0b7725b950aa56ef0885f6c6"
    assert len(node.gid) == GID_LENGTH
    assert node.gid != endpoint.gid


def test_a_domain_has_one_token_selector() -> None:
    assert token_selector(7) == "@zbot/7/**"


def test_a_namesake_selector_matches_all_tokens_with_the_same_name() -> None:
    selector = zenoh.KeyExpr(namesake_selector(node))
    assert selector.includes(zenoh.KeyExpr(NODE_KEY))
    assert selector.includes(zenoh.KeyExpr(NODE_KEY.replace(ZID, "abc")))
    assert not selector.intersects(zenoh.KeyExpr(NODE_KEY.replace("lidar", "camera")))
    selector = zenoh.KeyExpr(namesake_selector(endpoint))
    assert selector.includes(zenoh.KeyExpr(ENDPOINT_KEY))
    assert selector.includes(zenoh.KeyExpr(ENDPOINT_KEY.replace("/MP/", "/MS/")))
    other = replace(endpoint, name="/other", key="")
    assert not selector.intersects(zenoh.KeyExpr(other.key))


def test_a_type_selector_matches_all_endpoints_of_a_kind_and_type() -> None:
    selector = zenoh.KeyExpr(type_selector(endpoint.domain, endpoint.kind, endpoint.type_name))
    assert selector.includes(zenoh.KeyExpr(ENDPOINT_KEY))
    of_same_type = (
        replace(endpoint, name="/other", key=""),
        replace(endpoint, node="camera", key=""),
        replace(endpoint, type_hash="RIHS01_0", key=""),
    )
    assert all(selector.includes(zenoh.KeyExpr(token.key)) for token in of_same_type)
    others = (
        replace(endpoint, type_name="a/msg/B", key=""),
        replace(endpoint, kind=EntityKind.SERVICE, key=""),
        replace(endpoint, domain=8, key=""),
    )
    assert not any(selector.intersects(zenoh.KeyExpr(token.key)) for token in others)
