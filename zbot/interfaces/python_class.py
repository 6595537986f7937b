"""From a Python class to its spec, its type name and its hash, whatever it was made by."""

from __future__ import annotations

import dataclasses
import weakref
from typing import TYPE_CHECKING, Any

from zbot.interfaces import description, registry
from zbot.interfaces.errors import NotAMessageTypeError
from zbot.interfaces.message import Action, Message, Service
from zbot.interfaces.spec import MessageSpec

if TYPE_CHECKING:
    from zbot.interfaces.spec import InterfaceSpec

_specs: weakref.WeakKeyDictionary[type[Any], InterfaceSpec] = weakref.WeakKeyDictionary()
_hashes: dict[InterfaceSpec, str] = {}


def spec_of(cls: type[Any]) -> InterfaceSpec:
    """Look up the definition of a class: one of zbot's, a dataclass, or one of a real ROS 2.

    Raises:
        NotAMessageTypeError: It is none of these, or a dataclass with a field that no message can
            have; says which and why.
    """
    if not isinstance(cls, type):
        raise NotAMessageTypeError(cls, _why_no_class(cls))
    if issubclass(cls, (Message, Service, Action)) and hasattr(cls, "SPEC"):
        return cls.SPEC
    spec = _specs.get(cls)
    if spec is None:
        spec = _specs[cls] = _derived(cls)
    return spec


def message_spec_of(cls: type[Any]) -> MessageSpec:
    """Look up the definition of a message class, as `spec_of` does.

    Raises:
        NotAMessageTypeError: It is no message's.
    """
    spec = spec_of(cls)
    if not isinstance(spec, MessageSpec):
        reason = "it is a service or an action; the parts of it, such as Request, are messages"
        raise NotAMessageTypeError(cls, reason)
    return spec


def type_name(cls: type[Any]) -> str:
    """Return the ROS name of a class, `std_msgs/msg/String`; raises what `spec_of` raises."""
    return spec_of(cls).name


def type_hash(interface: str | type[Any]) -> str:
    """Return the RIHS01 hash of an interface, given its name or its class.

    Raises:
        NotAMessageTypeError: The class is no interface's.
        UnknownPackageError: No such package here; has suggestions.
        UnknownInterfaceError: The package has no such interface; has suggestions.
    """
    spec = _spec_for(interface)
    known = _hashes.get(spec)
    if known is None:
        known = _hashes[spec] = description.hash_of(spec, registry.get_spec)
    return known


def type_description(interface: str | type[Any]) -> dict[str, Any]:
    """Return what a type consists of, as the dict that its hash is made from.

    The shape is that of `type_description_interfaces/msg/TypeDescription`. Raises what
    `type_hash` raises.
    """
    return description.type_description(_spec_for(interface), registry.get_spec)


def has_sequences(interface: str | type[Any]) -> bool:
    """Return whether a message holds a sequence, at any depth: it may be of any size then.

    Raises what `type_hash` raises.
    """
    spec = _spec_for(interface)
    fields = (field.type for field in spec.fields) if isinstance(spec, MessageSpec) else ()
    return any(
        one.kind == "sequence" or (one.is_message and has_sequences(one.base)) for one in fields
    )


def _spec_for(interface: str | type[Any]) -> InterfaceSpec:
    return registry.get_spec(interface) if isinstance(interface, str) else spec_of(interface)


def _derived(cls: type[Any]) -> InterfaceSpec:
    # Programs that use only ROS 2's own types never load either.
    if dataclasses.is_dataclass(cls):
        from zbot.interfaces.dataclass_spec import dataclass_spec  # noqa: PLC0415

        return dataclass_spec(cls, spec_of)
    if (
        hasattr(cls, "get_fields_and_field_types")
        or hasattr(cls, "Request")
        or hasattr(cls, "Goal")
    ):
        from zbot.interfaces.foreign_spec import foreign_spec  # noqa: PLC0415

        return foreign_spec(cls)
    reason = "it is no message, service or action; a dataclass can be one"
    raise NotAMessageTypeError(cls, reason)


def _why_no_class(value: object) -> str:
    if isinstance(value, (Message, Service, Action)) or dataclasses.is_dataclass(value):
        return f"it is an instance; pass its class, {type(value).__name__}"
    if isinstance(value, str):
        return "it is a string; get_interface() gives the class of a name"
    return "it is no class"
