from __future__ import annotations

from tests.unit.tokens import endpoint_token
from zbot.wire.dialect import CLASSROOM, NATIVE
from zbot.wire.keys import SHARED_DOMAIN


def test_names_below_class_have_one_key_in_all_domains_of_a_class() -> None:
    assert CLASSROOM.topic_key(17, "/class/news") == "class/news"
    assert CLASSROOM.topic_key(17, "/classroom") == "17/classroom"
    assert CLASSROOM.topic_key(17, "/class") == "17/class"


def test_names_below_class_are_normal_names_outside_of_a_class() -> None:
    assert NATIVE.topic_key(17, "/class/news") == "17/class/news"
    assert NATIVE.domain_of(17, "/class/news") == 17


def test_tokens_of_two_domains_are_selected_in_a_class() -> None:
    assert CLASSROOM.token_selectors(17) == ("@zbot/17/**", "@zbot/class/**")
    assert NATIVE.token_selectors(17) == ("@zbot/17/**",)


def test_the_token_of_a_shared_topic_round_trips() -> None:
    domain = CLASSROOM.domain_of(17, "/class/news")
    token = endpoint_token("/class/news", domain=domain, zid="a1", nid=0, eid=1)
    assert token.key.startswith("@zbot/class/a1/0/1/MP/%/%/talker/%class%news/")
    read = CLASSROOM.parse_token(token.key)
    assert read == token
    assert read.domain == SHARED_DOMAIN
