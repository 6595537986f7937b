"""Whether a class is a message, a service or an action, and type variables for the kinds."""

from __future__ import annotations

from typing import Any, TypeVar

from zbot.interfaces.errors import InterfaceKindError
from zbot.interfaces.message import Action, Message, Service
from zbot.interfaces.python_class import spec_of
from zbot.interfaces.spec import MessageSpec, ServiceSpec

MsgT = TypeVar("MsgT", bound=Message)
SrvT = TypeVar("SrvT", bound=Service)
SrvRequestT = TypeVar("SrvRequestT", bound=Message)
SrvResponseT = TypeVar("SrvResponseT", bound=Message)
ActionT = TypeVar("ActionT", bound=Action)


def check_for_type_support(interface: type[Any]) -> None:
    """Refuse what is no message, service or action class.

    Raises:
        NotAMessageTypeError: It is none.
    """
    spec_of(interface)


def check_is_valid_msg_type(interface: type[Any]) -> None:
    """Refuse what is no message class.

    Raises:
        NotAMessageTypeError: It is no interface's class at all.
        InterfaceKindError: It is a service's or an action's.
    """
    if not isinstance(spec_of(interface), MessageSpec):
        raise InterfaceKindError(interface, "a message")


def check_is_valid_srv_type(interface: type[Any]) -> None:
    """Refuse what is no service class.

    Raises:
        NotAMessageTypeError: It is no interface's class at all.
        InterfaceKindError: It is a message's or an action's.
    """
    if not isinstance(spec_of(interface), ServiceSpec):
        raise InterfaceKindError(interface, "a service")
