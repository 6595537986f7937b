"""Tests of sample messages with filled fields."""

from __future__ import annotations

import importlib

import pytest

import zbot.compat
from zbot.compat.sample_messages import sample_messages, sample_services
from zbot.interfaces import registry
from zbot.interfaces.errors import UnknownInterfaceError
from zbot.wire.serialization import deserialize_message, serialize_message

MESSAGES = [name for name in registry.interface_names("test_msgs") if "/msg/" in name]


@pytest.mark.parametrize("name", MESSAGES)
def test_every_sample_survives_being_sent(name: str) -> None:
    for sample in sample_messages(name):
        assert deserialize_message(serialize_message(sample), type(sample)) == sample


def test_samples_reach_the_ends_of_each_type() -> None:
    _, high, low = sample_messages("test_msgs/msg/BasicTypes")
    assert (high.int8_value, low.int8_value) == (127, -128)
    assert (high.uint64_value, low.uint64_value) == (2**64 - 1, 0)
    _, high, low = sample_messages("test_msgs/msg/BoundedSequences")
    assert (len(high.int32_values), len(low.int32_values)) == (3, 0)


def test_services_have_a_response_for_each_request() -> None:
    for request, response in sample_services("test_msgs/srv/Arrays"):
        assert type(request).__name__ == "Arrays_Request"
        assert type(response).__name__ == "Arrays_Response"


def test_a_type_that_does_not_exist_is_refused() -> None:
    with pytest.raises(UnknownInterfaceError):
        sample_messages("test_msgs/msg/Strng")


def test_the_modules_have_the_names_of_ros() -> None:
    assert zbot.compat
    fixtures = importlib.import_module("test_msgs.message_fixtures")
    assert len(fixtures.get_test_msg("Strings")) == 3
    assert fixtures.get_msg_wstrings() == fixtures.get_test_msg("WStrings")
    assert not hasattr(fixtures, "get_msg_strng")
    services = importlib.import_module("test_msgs.service_fixtures")
    assert len(services.get_test_srv("Empty")) == 1
    assert importlib.import_module("test_msgs.msg").Strings(string_value="x").string_value == "x"
