"""Messages and services with values in all fields, for tests that send every type.

`test_msgs.message_fixtures` and `test_msgs.service_fixtures` have some of these functions.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, cast

from zbot.interfaces import registry
from zbot.interfaces.spec import INTEGER_RANGES

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import Field, FieldType, MessageSpec

_SEQUENCE_LENGTH = 3  # for sequences without a bound


def sample_messages(name: str) -> list[Any]:
    """Return three messages of a type: with the default, with the highest and the lowest values.

    The list has only one message if the type has no fields.

    Args:
        name: The type's full name, e.g. `test_msgs/msg/Arrays`.

    Raises:
        UnknownInterfaceError: There is no such type.
    """
    empty = registry.get_message(name)()
    if not _fields(name):
        return [empty]
    return [empty, _filled(name, is_high=True), _filled(name, is_high=False)]


def sample_services(name: str) -> list[tuple[Any, Any]]:
    """Return pairs of request and response, with values as in `sample_messages`."""
    requests = sample_messages(f"{name}_Request")
    return list(zip(requests, sample_messages(f"{name}_Response"), strict=True))


def get_test_msg(message_name: str) -> list[Any]:
    """Return filled messages of a type of `test_msgs`, e.g. `Arrays`.

    Raises:
        UnknownInterfaceError: There is no such type.
    """
    return sample_messages(f"test_msgs/msg/{message_name}")


def get_test_srv(service_name: str) -> list[tuple[Any, Any]]:
    """Return pairs of a filled request and response of a service of `test_msgs`, e.g. `Arrays`.

    Raises:
        UnknownInterfaceError: There is no such service.
    """
    return sample_services(f"test_msgs/srv/{service_name}")


def function_of_type(name: str) -> Callable[[], list[Any]]:
    """Return the function of one type, e.g. `get_msg_wstrings` for `WStrings`.

    This is the `__getattr__` of `test_msgs.message_fixtures`.
    """
    if name.startswith("get_msg_"):
        wanted = name.removeprefix("get_msg_").replace("_", "")
        for full in registry.interface_names("test_msgs"):
            _, kind, short = full.split("/")
            if kind == "msg" and short.lower() == wanted:
                return partial(get_test_msg, short)
    raise AttributeError(f"module 'test_msgs.message_fixtures' has no attribute {name!r}")


def _filled(name: str, *, is_high: bool) -> Any:
    message = registry.get_message(name)()
    for field in _fields(name):
        setattr(message, field.name, _value(field.type, is_high=is_high))
    return message


def _fields(message: str) -> tuple[Field, ...]:
    return cast("MessageSpec", registry.get_spec(message)).fields


def _value(kind: FieldType, *, is_high: bool) -> Any:
    if kind.kind == "scalar":
        return _scalar(kind, is_high=is_high)
    if kind.kind == "sequence" and not is_high:
        return []
    length = kind.size or _SEQUENCE_LENGTH
    return [_scalar(kind, is_high=is_high != bool(index % 2)) for index in range(length)]


def _scalar(kind: FieldType, *, is_high: bool) -> Any:
    if kind.is_message:
        return _filled(kind.base, is_high=is_high)
    if kind.is_string:
        text = "Grüße, 世界" if kind.base == "wstring" else "a string"
        return text[: kind.string_bound or None] if is_high else ""
    if kind.base in INTEGER_RANGES:
        return INTEGER_RANGES[kind.base][is_high]
    if kind.base == "bool":
        return is_high
    if kind.base == "byte":
        return b"\xff" if is_high else b"\x00"
    return 1.125 if is_high else -2.125  # float32 and float64 contain exactly these values
