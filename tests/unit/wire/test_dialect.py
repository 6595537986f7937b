from __future__ import annotations

from zbot.qos import QoSProfile
from zbot.wire.dialect import IN_CLASS, NATIVE
from zbot.wire.keys import SHARED_DOMAIN
from zbot.wire.tokens import EndpointToken, EntityKind


def test_in_a_class_names_below_class_have_one_key_in_all_domains() -> None:
    assert IN_CLASS.topic_key(17, "/class/news") == "class/news"
    assert IN_CLASS.topic_key(17, "/classroom") == "17/classroom"
    assert IN_CLASS.topic_key(17, "/class") == "17/class"


def test_elsewhere_they_are_names_like_others() -> None:
    assert NATIVE.topic_key(17, "/class/news") == "17/class/news"
    assert NATIVE.domain_of(17, "/class/news") == 17


def test_in_a_class_two_sets_of_tokens_are_of_interest() -> None:
    assert IN_CLASS.tokens_keys(17) == ("@zbot/17/**", "@zbot/class/**")
    assert NATIVE.tokens_keys(17) == ("@zbot/17/**",)


def test_the_token_of_a_shared_topic_survives_the_wire() -> None:
    token = EndpointToken(
        domain=IN_CLASS.domain_of(17, "/class/news"),
        zid="a1",
        nid=0,
        eid=1,
        kind=EntityKind.PUBLISHER,
        namespace="/",
        node="talker",
        name="/class/news",
        type_name="std_msgs/msg/String",
        type_hash="RIHS01_0",
        qos=QoSProfile(depth=10),
    )
    assert token.key.startswith("@zbot/class/a1/0/1/MP/%/%/talker/%class%news/")
    read = IN_CLASS.parse_token(token.key)
    assert read == token
    assert read.domain == SHARED_DOMAIN
