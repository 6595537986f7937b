"""Base classes of the generated message, service and action classes."""

from __future__ import annotations

import copy
from types import GenericAlias
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

    from typing_extensions import Self

    from zbot.interfaces.slot_type import AbstractType
    from zbot.interfaces.spec import ActionSpec, MessageSpec, ServiceSpec

MessageT = TypeVar("MessageT", bound="Message")

_IMMUTABLE = {bool, int, float, str, bytes}


class ConstantsMeta(type):
    """Metaclass of message classes with constants. As in ROS 2, constants cannot be assigned.

    Message classes without constants have the metaclass `type`: their instances are made faster.
    """

    _SPEC: MessageSpec

    def __setattr__(cls, name: str, value: object) -> None:
        cls._refuse_constant(name)
        super().__setattr__(name, value)

    def __delattr__(cls, name: str) -> None:
        cls._refuse_constant(name)
        super().__delattr__(name)

    def _refuse_constant(cls, name: str) -> None:
        constants = {constant.name for constant in cls._SPEC.constants}
        if name in constants or name.endswith("__DEFAULT"):
            raise AttributeError(f"{name!r} of {cls._SPEC.name} is a constant")


class Message:
    """Base of the generated message classes. A field `x` is a property `x` with a slot `_x`."""

    __slots__ = ()

    _SPEC: ClassVar[MessageSpec]
    _TYPE_NAME: ClassVar[str]
    _REBUILD: ClassVar[tuple[Callable[..., Any], Any]]  # what pickle calls, and with which key
    SLOT_TYPES: ClassVar[tuple[AbstractType, ...]]
    _fields_and_field_types: ClassVar[dict[str, str]]

    if TYPE_CHECKING:  # each class has its own constructor, with its fields as keywords

        def __init__(self, **fields: Any) -> None: ...

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return a new dictionary of the fields in order, with each type as ROS 2 writes it."""
        return dict(cls._fields_and_field_types)

    def __copy__(self) -> Self:
        return _duplicate(self, lambda value: value)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return _duplicate(
            self, lambda value: value if type(value) in _IMMUTABLE else copy.deepcopy(value, memo)
        )

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...], Any]:
        # The registry lets a pickle contain the type's name: then a process that unpickles it only
        # has to import zbot.
        cls = type(self)
        function, key = cls.__dict__.get("_REBUILD", (rebuild, cls))
        values = tuple([getattr(self, f"_{field.name}") for field in cls._SPEC.fields])
        return function, (key, values), getattr(self, "__dict__", None)


# This function is not a method, because a field `duplicate` would have the slot `_duplicate`.
def _duplicate(message: MessageT, duplicated: Callable[[Any], Any]) -> MessageT:
    # The values in the slots are valid, so the properties do not check them again.
    twin = type(message).__new__(type(message))
    for field in message._SPEC.fields:  # noqa: SLF001 - our own class
        slot = f"_{field.name}"
        setattr(twin, slot, duplicated(getattr(message, slot)))
    for name, value in getattr(message, "__dict__", {}).items():  # attributes of a subclass
        setattr(twin, name, duplicated(value))
    return twin


class Service:
    """Base of the generated service classes, which are namespaces of three messages."""

    _SPEC: ClassVar[ServiceSpec]
    _TYPE_NAME: ClassVar[str]
    __class_getitem__: ClassVar[Any] = classmethod(GenericAlias)

    def __init__(self, *_: object, **fields: object) -> None:
        advice = _part_call(type(self), ("Request", "Response"), fields)
        raise NotImplementedError(f"Service classes can not be instantiated: write {advice}")


class Action:
    """Base of the generated action classes, which are namespaces of messages and services."""

    _SPEC: ClassVar[ActionSpec]
    _TYPE_NAME: ClassVar[str]
    __class_getitem__: ClassVar[Any] = classmethod(GenericAlias)

    def __init__(self, *_: object, **fields: object) -> None:
        advice = _part_call(type(self), ("Goal", "Result", "Feedback"), fields)
        raise NotImplementedError(f"Action classes can not be instantiated: write {advice}")


def _part_call(cls: type[Any], parts: tuple[str, ...], fields: Collection[str]) -> str:
    """Return the call of the first part with all the fields, e.g. `SetBool.Request(data=...)`."""
    known = ((part, getattr(cls, part).get_fields_and_field_types()) for part in parts)
    fitting = (part for part, names in known if set(fields) <= names.keys())
    given = ", ".join(f"{field}=..." for field in fields)
    return f"{cls.__name__}.{next(fitting, parts[0])}({given})"


class Impl:
    """Base of classes such as `Fibonacci.Impl`, with an action's services and topic messages."""

    __class_getitem__: ClassVar[Any] = classmethod(GenericAlias)


def shown_name(message: Message) -> str:
    """Return the class name in a message's `repr`, as in ROS 2: `std_msgs.msg.String`."""
    cls = type(message)
    package = cls.__module__.rpartition(".")[0]
    return f"{package}.{cls.__name__}" if package else cls.__name__


def call_text(cls: type[Any]) -> str:
    """Return how a program makes a message: `Vector3(x=...)`, `SetBool.Request(data=...)`."""
    fields: dict[str, str] = getattr(cls, "get_fields_and_field_types", dict)()
    first = next(iter(fields), "")
    return f"{cls.__name__.replace('_', '.')}({first and f'{first}=...'})"


def rebuild(cls: type[Message], values: tuple[Any, ...]) -> Message:
    """Return the message that `Message.__reduce__` described. pickle calls this function."""
    message = cls.__new__(cls)
    for field, value in zip(cls._SPEC.fields, values, strict=True):
        setattr(message, f"_{field.name}", value)
    return message
