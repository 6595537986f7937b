from __future__ import annotations

import pytest

from zbot.interfaces.errors import InterfaceKindError, NotAMessageTypeError
from zbot.interfaces.type_support import (
    check_for_type_support,
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)

from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger


def test_interfaces_of_every_kind_pass() -> None:
    for interface in (String, Trigger, Fibonacci, Trigger.Request):
        check_for_type_support(interface)
    check_is_valid_msg_type(String)
    check_is_valid_srv_type(Trigger)


@pytest.mark.parametrize("caught", [TypeError, AttributeError])
def test_other_classes_are_refused_as_programs_expect(caught: type[Exception]) -> None:
    with pytest.raises(caught, match="int cannot be used as an interface type"):
        check_for_type_support(int)


@pytest.mark.parametrize("caught", [NotAMessageTypeError, RuntimeError])
def test_other_kinds_are_refused(caught: type[Exception]) -> None:
    with pytest.raises(caught, match=r"Trigger .* it is a service, not a message"):
        check_is_valid_msg_type(Trigger)
    with pytest.raises(caught, match=r"String .* it is a message, not a service"):
        check_is_valid_srv_type(String)
    with pytest.raises(InterfaceKindError):
        check_is_valid_srv_type(Fibonacci)
