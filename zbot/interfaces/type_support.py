"""Checks that a class is a message, service or action, and type variables for each kind."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from zbot.interfaces.errors import InterfaceKindError
from zbot.interfaces.message import Action, Message, Service
from zbot.interfaces.python_class import spec_of
from zbot.interfaces.spec import ActionSpec, MessageSpec, ServiceSpec

if TYPE_CHECKING:
    from zbot.interfaces.spec import InterfaceSpec

MsgT = TypeVar("MsgT", bound=Message)
SrvT = TypeVar("SrvT", bound=Service)
SrvRequestT = TypeVar("SrvRequestT", bound=Message)
SrvResponseT = TypeVar("SrvResponseT", bound=Message)
ActionT = TypeVar("ActionT", bound=Action)


def check_for_type_support(interface: type[Any]) -> None:
    """Check that a class is a message, service or action class.

    Raises:
        NotAMessageTypeError: The class is of another kind.
    """
    spec_of(interface)


def check_is_valid_msg_type(interface: type[Any]) -> None:
    """Check that a class is a message class.

    Raises:
        NotAMessageTypeError: The class is not an interface class.
        InterfaceKindError: The class is a service or action class.
    """
    spec = spec_of(interface)
    if not isinstance(spec, MessageSpec):
        raise InterfaceKindError(interface, _kind_of(spec), "a message")


def check_is_valid_srv_type(interface: type[Any]) -> None:
    """Check that a class is a service class.

    Raises:
        NotAMessageTypeError: The class is not an interface class.
        InterfaceKindError: The class is a message or action class.
    """
    spec = spec_of(interface)
    if not isinstance(spec, ServiceSpec):
        raise InterfaceKindError(interface, _kind_of(spec), "a service")


def _kind_of(spec: InterfaceSpec) -> str:
    if isinstance(spec, ActionSpec):
        return "an action"
    return "a service" if isinstance(spec, ServiceSpec) else "a message"
