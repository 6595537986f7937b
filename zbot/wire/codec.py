"""Messages to MessagePack and back: one generated pack and one unpack function for each type.

What arrives is checked in full. Any bytes give either a message whose every field is valid, or one
`CodecError`; memory stays in proportion to the bytes that arrived.
"""

from __future__ import annotations

import math
import typing
from array import array
from dataclasses import is_dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, Literal, NoReturn, TypeVar

from zbot.errors import ExternalShutdownException
from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.wire import check, generator
from zbot.wire.check import Fault
from zbot.wire.errors import CodecError
from zbot.wire.generator import Layout, function_name, is_numeric_array
from zbot.wire.keys import encoding
from zbot.wire.lift import LARGE, lift_arrays
from zbot.wire.messagepack import (
    Bytes,
    UnreadableError,
    bin_header,
    ext_header,
    extension,
    pack,
    unpack,
)

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["Codec", "CodecError", "codec_for"]

MessageT = TypeVar("MessageT")

_Nested = Literal["to_map", "from_map"]

_ERRORS = (Fault, AttributeError, TypeError, ValueError, OverflowError, MemoryError, BufferError)
_SOURCES = {
    "encode": generator.encode_source,
    "decode": generator.decode_source,
    "to_map": generator.to_map_source,
    "from_map": generator.from_map_source,
}
#: For each generated function, what it calls for the messages inside, and under which verb.
_INSIDE: dict[str, tuple[str, _Nested]] = {
    "encode": ("pack", "to_map"),
    "to_map": ("pack", "to_map"),
    "decode": ("unpack", "from_map"),
    "from_map": ("unpack", "from_map"),
}
_COMMON_NAMES: dict[str, Any] = {
    **vars(check),
    "pack": pack,
    "unpack": unpack,
    "bin_header": bin_header,
    "ext_header": ext_header,
    "extension": extension,
    "array": array,
    "fixed_array": fixed_array,
    "EMPTY": {},
    "inf": math.inf,
    "nan": math.nan,
}


class Codec(Generic[MessageT]):
    """How messages of one type become bytes, and bytes messages.

    Each way's function is made when it is asked for: most processes use one way of a type only.

    Args:
        message_class: A message class or a dataclass.

    Raises:
        NotAMessageTypeError: It is neither.
    """

    def __init__(self, message_class: type[MessageT]) -> None:
        self._spec = message_spec_of(message_class)
        self._class = message_class
        self.type_name = self._spec.name  #: `std_msgs/msg/String`
        self.encoding = encoding(self._spec.name)  #: Zenoh encoding of the bytes

    @property
    def source(self) -> str:
        """The generated functions, for a person to read."""
        return "\n\n".join(
            write(self._spec, _layout(self._class))
            for write in (generator.encode_source, generator.decode_source)
        )

    @cached_property
    def encode(self) -> Callable[[MessageT], bytes]:
        """Return the bytes of a message; raises `CodecError` where a field cannot be sent."""
        names = {"ERRORS": _ERRORS, "explain": self._explain_encoding}
        return _function(self._class, "encode", names)

    @cached_property
    def decode(self) -> Callable[[Bytes], MessageT]:
        """Return the message that bytes stand for; raises `CodecError` where they are none."""
        names = {"ERRORS": Exception, "explain": self._explain_decoding}  # dataclasses raise any
        arrays = {pack(f.name): f.name for f in self._spec.fields if is_numeric_array(f)}
        names |= {"LARGE": LARGE, "unpack_large": _unpack_large, "ARRAYS": arrays}
        return _function(self._class, "decode", names)

    def _explain_encoding(self, message: Any, error: Exception) -> NoReturn:
        path, reason = _path_and_reason(error)
        if not isinstance(message, self._class) and not isinstance(error, Fault):
            reason = f"expected a {self.type_name}, not {check.kind(message)}"
        elif isinstance(error, UnicodeEncodeError):
            path = _path_of(error.object, _nested_function(self._class, "to_map")(message))
            reason = f"{error.object!r:.40} cannot be written as UTF-8"
        raise CodecError("encode", self.type_name, path, reason) from error

    def _explain_decoding(self, error: Exception) -> NoReturn:
        if isinstance(error, ExternalShutdownException):
            raise error  # a signal came meanwhile: that is not the message's fault
        cause = None if isinstance(error, Fault) else error
        raise CodecError("decode", self.type_name, *_path_and_reason(error)) from cause


_codecs: dict[type, Codec[Any]] = {}
_nested_functions: dict[tuple[type, str], Callable[[Any], Any]] = {}


def codec_for(message_class: type[MessageT]) -> Codec[MessageT]:
    """Return the codec of a message class, made at the first call for it.

    Raises:
        NotAMessageTypeError: The class is no message's.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = Codec(message_class)
    return codec


def _unpack_large(data: Bytes, arrays: dict[bytes, str]) -> Any:
    lifted = lift_arrays(data, arrays)
    if lifted is None:
        return unpack(data)
    values = unpack(lifted[0])
    values.update(lifted[1])
    return values


def _path_and_reason(error: Exception) -> tuple[str, str]:
    if isinstance(error, Fault):
        return error.path, error.reason
    return "", str(error) if isinstance(
        error, UnreadableError
    ) else f"{type(error).__name__}: {error}"


def _path_of(text: str, value: Any) -> str:
    """Return where in a map a text stands."""
    entries: Any = ()
    if isinstance(value, dict):
        entries = value.items()
    elif isinstance(value, list):
        entries = enumerate(value)
    for key, item in entries:
        here = f"[{key}]" if isinstance(key, int) else key
        if item == text:
            return here
        below = _path_of(text, item)
        if below:
            return f"{here}{'' if below.startswith('[') else '.'}{below}"
    return ""


def _layout(message_class: type[Any]) -> Layout:
    return _dataclass_layout(message_class) if is_dataclass(message_class) else Layout()


def _nested_function(message_class: type[Any], name: _Nested) -> Callable[[Any], Any]:
    """Return the function for messages of a class that stand in others."""
    function = _nested_functions.get((message_class, name))
    if function is None:
        function = _nested_functions[message_class, name] = _function(message_class, name, {})
    return function


def _function(
    message_class: type[Any], name: _Nested | Literal["encode", "decode"], more: dict[str, Any]
) -> Callable[[Any], Any]:
    """Return one of a type's generated functions, which uses some names more than all do."""
    spec = message_spec_of(message_class)
    source = _SOURCES[name](spec, _layout(message_class))
    verb, nested = _INSIDE[name]
    names = _COMMON_NAMES | more | {"CLASS": message_class, "new": message_class.__new__}
    for field in spec.fields:
        names[f"KEY_{field.name}"] = pack(field.name)
        if field.type.is_message:
            inner = get_interface(field.type.base)
            names[function_name(verb, field.type.base)] = _nested_function(inner, nested)
    exec(compile(source, f"<codec of {spec.name}>", "exec"), names)  # noqa: S102 - our own text
    function: Callable[[Any], Any] = names[name]
    return function


def _dataclass_layout(message_class: type[Any]) -> Layout:
    # The annotations say list or bytes where a generated message class has array.array.
    conversions = {}
    for name, hint in typing.get_type_hints(message_class).items():
        if hint is bytes:
            conversions[name] = "tobytes"
        elif typing.get_origin(hint) is list:
            conversions[name] = "tolist"
    return Layout(prefix="", keywords=True, conversions=conversions)
