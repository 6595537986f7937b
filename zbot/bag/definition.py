"""Message definitions in bags. In the encoding `ros2msg`, they contain all types inside a type."""

from __future__ import annotations

import re
from typing import Any

from zbot.bag.errors import BagTypeError
from zbot.errors import ZbotError
from zbot.interfaces import MessageSpec, get_message, get_spec, register_spec
from zbot.interfaces.definition_limits import check_limits
from zbot.interfaces.errors import UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.remote_definition import specs_from_sources

ENCODING = "ros2msg"
_SEPARATOR = "=" * 80
_SPLIT = re.compile(rf"^{_SEPARATOR}[ \t]*\r?\n", re.MULTILINE)


def definition_text(type_name: str) -> str:
    """Return the definition of a message type and of all types inside it.

    Before each further definition, there are a line of 80 `=` and a line `MSG: pkg/Name`.

    Raises:
        UnknownPackageError: The type is not known here.
        UnknownInterfaceError: The type is not known here, but its package is known.
    """
    return _with_parts(type_name, {type_name})


def _with_parts(type_name: str, seen: set[str]) -> str:
    spec = get_spec(type_name)
    fields = spec.fields if isinstance(spec, MessageSpec) else ()
    text = spec.text or "".join(f"{field.type.text} {field.name}\n" for field in fields)
    for part in sorted({field.type.base for field in fields if field.type.is_message}):
        if part not in seen:
            seen.add(part)
            text += f"\n{_SEPARATOR}\nMSG: {_short(part)}\n{_with_parts(part, seen)}"
    return text


def _short(type_name: str) -> str:
    return type_name.replace("/msg/", "/")


def message_class(type_name: str, encoding: str = "", text: str = "") -> type[Any]:
    """Return the class of a bag's message type. Register the bag's definition of a new type.

    Args:
        type_name: `std_msgs/msg/String`.
        encoding: Encoding of the bag's definition, or empty if there is none.
        text: The bag's definition.

    Raises:
        BagTypeError: There is no definition that zbot can read, or the bag's definition is
            different from this machine's definition.
    """
    type_name = _full(type_name)  # an old bag has names without `msg`
    is_own = encoding == ENCODING and text.strip() and "_" not in type_name.rpartition("/")[2]
    try:
        if is_own:
            specs = specs_from_sources(type_name, split_definitions(type_name, text))
            check_limits(specs)
            for spec in specs:
                register_spec(spec)
        return get_message(type_name)
    except (UnknownPackageError, UnknownInterfaceError):
        if encoding in {"", ENCODING}:
            reason = "neither the bag nor this machine has its definition"
        else:
            reason = f"its definition has the encoding {encoding}, and this machine has none"
        raise BagTypeError(type_name, reason) from None
    except ZbotError as error:
        raise BagTypeError(type_name, str(error)) from error


def split_definitions(type_name: str, text: str) -> dict[str, str]:
    """Return the definitions in a text by the full names of their types."""
    first, *others = _SPLIT.split(text)
    found = {type_name: first}
    for other in others:
        title, _, body = other.partition("\n")
        found[_full(title.strip().removeprefix("MSG:").strip())] = body
    return found


def _full(name: str) -> str:
    package, slash, rest = name.partition("/")
    return name if not slash or "/" in rest else f"{package}/msg/{rest}"
