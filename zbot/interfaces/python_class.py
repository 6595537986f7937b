"""Spec, type name and hash of any Python class that can be an interface."""

from __future__ import annotations

import dataclasses
import weakref
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

from zbot.interfaces import description, registry
from zbot.interfaces.errors import InterfaceKindError, NotAMessageTypeError
from zbot.interfaces.message import Action, Message, Service
from zbot.interfaces.spec import ActionSpec, MessageSpec, ServiceSpec

if TYPE_CHECKING:
    from zbot.interfaces.spec import InterfaceSpec

_specs: weakref.WeakKeyDictionary[type[Any], InterfaceSpec] = weakref.WeakKeyDictionary()
_hashes: dict[InterfaceSpec, str] = {}
_KINDS: dict[type[Any], str] = {
    ActionSpec: "an action",
    MessageSpec: "a message",
    ServiceSpec: "a service",
}


def spec_of(cls: type[Any]) -> InterfaceSpec:
    """Return the spec of a class that zbot or an installed ROS 2 made, or of a dataclass.

    Raises:
        NotAMessageTypeError: The class is of another kind, or is a dataclass with a field that a
            message cannot have. The error contains the reason.
    """
    if not isinstance(cls, type):
        raise NotAMessageTypeError(cls, _not_a_class_reason(cls))
    if issubclass(cls, (Message, Service, Action)) and hasattr(cls, "_SPEC"):
        return cls._SPEC
    spec = _specs.get(cls)
    if spec is None:
        spec = _specs[cls] = _derived_spec(cls)
    return spec


def message_spec_of(cls: type[Any]) -> MessageSpec:
    """Return the spec of a message class, as `spec_of` does.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    spec = spec_of(cls)
    if not isinstance(spec, MessageSpec):
        reason = "it is a service or an action; the parts of it, such as Request, are messages"
        raise NotAMessageTypeError(cls, reason)
    return spec


def type_name(cls: type[Any]) -> str:
    """Return the type name of a class. Raise the errors of `spec_of`."""
    return spec_of(cls).name


def type_hash(interface: str | type[Any]) -> str:
    """Return the RIHS01 hash of an interface. The argument is the name or the class.

    Raises:
        NotAMessageTypeError: The class is not an interface class.
        UnknownPackageError: The package does not exist here. The error suggests similar names.
        UnknownInterfaceError: The package has no such interface. The error suggests similar names.
    """
    spec = _spec_for(interface)
    known = _hashes.get(spec)
    if known is None:
        known = _hashes[spec] = description.hash_of(spec, registry.get_spec)
    return known


def type_description(interface: str | type[Any]) -> dict[str, Any]:
    """Return the description of a type. The type's hash is computed from this dictionary.

    It has the fields of `type_description_interfaces/msg/TypeDescription`. The function raises the
    errors of `type_hash`.
    """
    return description.type_description(_spec_for(interface), registry.get_spec)


def has_sequences(interface: str | type[Any]) -> bool:
    """Return whether a message has a sequence at any depth. The size of such a message can vary.

    The function raises the errors of `type_hash`.
    """
    spec = _spec_for(interface)
    fields = (field.type for field in spec.fields) if isinstance(spec, MessageSpec) else ()
    return any(
        kind.kind == "sequence" or (kind.is_message and has_sequences(kind.base)) for kind in fields
    )


def has_byte_sequences(interface: str | type[Any]) -> bool:
    """Return whether a message has a field `uint8[]` at any depth, e.g. an image.

    The function raises the errors of `type_hash`.
    """
    spec = _spec_for(interface)
    fields = (field.type for field in spec.fields) if isinstance(spec, MessageSpec) else ()
    return any(
        (kind.base == "uint8" and kind.kind == "sequence" and not kind.size)
        or (kind.is_message and has_byte_sequences(kind.base))
        for kind in fields
    )


def _spec_for(interface: str | type[Any]) -> InterfaceSpec:
    return registry.get_spec(interface) if isinstance(interface, str) else spec_of(interface)


def _derived_spec(cls: type[Any]) -> InterfaceSpec:
    # Imported here, because most programs use only zbot's classes and do not need these modules.
    if dataclasses.is_dataclass(cls):
        from zbot.interfaces.dataclass_spec import dataclass_spec  # noqa: PLC0415

        return dataclass_spec(cls, spec_of)
    if (
        hasattr(cls, "get_fields_and_field_types")
        or hasattr(cls, "Request")
        or hasattr(cls, "Goal")
    ):
        from zbot.interfaces.ros2_class_spec import ros2_class_spec  # noqa: PLC0415

        return ros2_class_spec(cls)
    reason = "it is not a message, service or action: use an interface class or a dataclass"
    raise NotAMessageTypeError(cls, reason)


def _not_a_class_reason(value: object) -> str:
    if isinstance(value, (Message, Service, Action)) or dataclasses.is_dataclass(value):
        return f"it is an instance; pass its class, {type(value).__name__}"
    if isinstance(value, str):
        name = value.rpartition("/")[2]
        return f"it is a text; import the class and write {name} without quotes"
    if isinstance(value, ModuleType):
        return "it is a module; write one of its classes"
    return "it is not a class"


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
    _check_kind(interface, MessageSpec)


def check_is_valid_srv_type(interface: type[Any]) -> None:
    """Check that a class is a service class.

    Raises:
        NotAMessageTypeError: The class is not an interface class.
        InterfaceKindError: The class is a message or action class.
    """
    _check_kind(interface, ServiceSpec)


def _check_kind(interface: type[Any], wanted: type[InterfaceSpec]) -> None:
    spec = spec_of(interface)
    if not isinstance(spec, wanted):
        raise InterfaceKindError(interface, _KINDS[type(spec)], _KINDS[wanted])
