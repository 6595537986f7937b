"""Codec that converts messages to MessagePack and back, with generated code for each type.

The decoder checks every field. For any bytes, the decoder either returns a valid message or raises
`CodecError`. Its memory use is proportional to the number of bytes.
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
from zbot.wire import validation
from zbot.wire.errors import CodecError
from zbot.wire.keys import encoding
from zbot.wire.messagepack import generated_codec, generator
from zbot.wire.messagepack.default_memory import begin_message, count_elements
from zbot.wire.messagepack.generator import Layout, function_name, is_numeric_array
from zbot.wire.messagepack.large_arrays import LARGE, extract_arrays
from zbot.wire.messagepack.packing import (
    Bytes,
    UnreadableError,
    bin_header,
    ext_header,
    extension,
    pack,
    unpack,
    unpack_any_text,
)
from zbot.wire.validation import Fault

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["Codec", "CodecError", "codec_for", "layout_of"]

MessageT = TypeVar("MessageT")

_Nested = Literal["to_map", "from_map"]

_ERRORS = (Fault, AttributeError, TypeError, ValueError, OverflowError, MemoryError, BufferError)
_SOURCES = {
    "encode": generator.encode_source,
    "decode": generator.decode_source,
    "to_map": generator.to_map_source,
    "from_map": generator.from_map_source,
}
#: For each generated function: prefix and kind of the function that it calls for nested messages.
_NESTED_CALLS: dict[str, tuple[str, _Nested]] = {
    "encode": ("pack", "to_map"),
    "to_map": ("pack", "to_map"),
    "decode": ("unpack", "from_map"),
    "from_map": ("unpack", "from_map"),
}
_COMMON_NAMES: dict[str, Any] = {
    **vars(validation),
    "pack": pack,
    "unpack": unpack,
    "bin_header": bin_header,
    "ext_header": ext_header,
    "extension": extension,
    "array": array,
    "fixed_array": fixed_array,
    "begin_message": begin_message,
    "count_elements": count_elements,
    "EMPTY": {},
    "inf": math.inf,
    "nan": math.nan,
}


class Codec(Generic[MessageT]):
    """Encoder and decoder for messages of one type.

    The encoder and the decoder are each generated at first use, because most processes need only
    one of them for a type.

    Args:
        message_class: A message class or a dataclass.

    Raises:
        NotAMessageTypeError: The class is not a message class or a dataclass.
    """

    def __init__(self, message_class: type[MessageT]) -> None:
        self._spec = message_spec_of(message_class)
        self._class = message_class
        self.type_name = self._spec.name  #: `std_msgs/msg/String`
        self.encoding = encoding(self._spec.name)  #: Zenoh encoding of the bytes

    @property
    def source(self) -> str:
        """Source of `encode` and `decode`, for debugging."""
        if self._has_runs:
            return generated_codec.source(self._class)
        return "\n\n".join(
            write(self._spec, layout_of(self._class))
            for write in (generator.encode_source, generator.decode_source)
        )

    @cached_property
    def encode(self) -> Callable[[MessageT], bytes]:
        """Return the bytes of a message. Raise `CodecError` if a field cannot be sent."""
        if self._has_runs:
            # The careful function is generated when it is needed for the first time.
            return generated_codec.encoder(self._class, lambda one: self.encode_carefully(one))  # noqa: PLW0108
        return self.encode_carefully

    @cached_property
    def decode(self) -> Callable[[Bytes], MessageT]:
        """Return the message that bytes contain. Raise `CodecError` if the bytes are not valid.

        Some values that are not valid are read as in rclpy: bytes of a text that are not UTF-8
        become U+FFFD, and a bool that is a number other than 0 is true.
        """
        if self._has_runs:
            return generated_codec.decoder(self._class, self._decode_tolerantly)
        return self._decode_tolerantly

    @cached_property
    def decode_strictly(self) -> Callable[[Bytes], MessageT]:
        """Do the same as `decode`, but refuse all values that are not valid."""
        if self._has_runs:
            return generated_codec.decoder(self._class, lambda data: self.decode_carefully(data))  # noqa: PLW0108
        return self.decode_carefully

    def _decode_tolerantly(self, data: Bytes) -> MessageT:
        try:
            return self.decode_carefully(data)
        except CodecError as error:
            try:
                return self._decode_any(data)
            except CodecError:
                raise error from None

    @cached_property
    def _has_runs(self) -> bool:
        return generated_codec.is_supported(self._class)

    @cached_property
    def encode_carefully(self) -> Callable[[MessageT], bytes]:
        """Do the same as `encode`, but check each value. This needs more time for some types."""
        names = {"ERRORS": _ERRORS, "explain": self._explain_encoding}
        return _function(self._class, "encode", names)

    @cached_property
    def decode_carefully(self) -> Callable[[Bytes], MessageT]:
        """Do the same as `decode_strictly`, but check each value, which may need more time."""
        # The constructor of a dataclass may raise any exception.
        names = {"ERRORS": Exception, "explain": self._explain_decoding}
        arrays = {pack(f.name): f.name for f in self._spec.fields if is_numeric_array(f)}
        names |= {"LARGE": LARGE, "unpack_large": _unpack_large, "ARRAYS": arrays}
        return _function(self._class, "decode", names)

    @cached_property
    def _decode_any(self) -> Callable[[Bytes], MessageT]:
        names = {"ERRORS": Exception, "explain": self._explain_decoding}
        names |= {"LARGE": math.inf, "unpack": unpack_any_text}
        return _function(self._class, "decode", names, tolerant=True)

    def _explain_encoding(self, message: Any, error: Exception) -> NoReturn:
        path, reason = _path_and_reason(error)
        if not isinstance(message, self._class) and not isinstance(error, Fault):
            reason = f"expected a {self.type_name}, not {validation.kind(message)}"
        elif isinstance(error, UnicodeEncodeError):
            path = _path_of(error.object, _nested_function(self._class, "to_map")(message))
            reason = f"{error.object!r:.40} cannot be written as UTF-8"
        raise CodecError("encode", self.type_name, path, reason) from error

    def _explain_decoding(self, error: Exception) -> NoReturn:
        if isinstance(error, ExternalShutdownException):
            raise error  # a signal during decoding does not make the message invalid
        cause = None if isinstance(error, Fault) else error
        raise CodecError("decode", self.type_name, *_path_and_reason(error)) from cause


_codecs: dict[type, Codec[Any]] = {}
_nested_functions: dict[tuple[type, str, bool], Callable[[Any], Any]] = {}
_TOLERANT_NAMES: dict[str, Any] = {
    "boolean": validation.any_boolean,
    "booleans": validation.any_booleans,
}


def codec_for(message_class: type[MessageT]) -> Codec[MessageT]:
    """Return the codec of a message class. It is made at the first call and then reused.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = Codec(message_class)
    return codec


def _unpack_large(data: Bytes, arrays: dict[bytes, str]) -> Any:
    extracted = extract_arrays(data, arrays)
    if extracted is None:
        return unpack(data)
    values = unpack(extracted[0])
    values.update(extracted[1])
    return values


def _path_and_reason(error: Exception) -> tuple[str, str]:
    if isinstance(error, Fault):
        return error.path, error.reason
    return "", str(error) if isinstance(
        error, UnreadableError
    ) else f"{type(error).__name__}: {error}"


def _path_of(text: str, value: Any) -> str:
    """Return the path of a text in a map. Return an empty string if the text is not there."""
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


def layout_of(message_class: type[Any]) -> Layout:
    """Return how a message class or a dataclass stores its fields."""
    return _dataclass_layout(message_class) if is_dataclass(message_class) else Layout()


def _nested_function(
    message_class: type[Any], name: _Nested, *, tolerant: bool = False
) -> Callable[[Any], Any]:
    """Return the function that converts a class's messages if they are inside other messages."""
    key = message_class, name, tolerant
    function = _nested_functions.get(key)
    if function is None:
        function = _nested_functions[key] = _function(message_class, name, {}, tolerant=tolerant)
    return function


def _function(
    message_class: type[Any],
    name: _Nested | Literal["encode", "decode"],
    more: dict[str, Any],
    *,
    tolerant: bool = False,
) -> Callable[[Any], Any]:
    """Return one of a type's generated functions. `more` has additional globals for it."""
    spec = message_spec_of(message_class)
    source = _SOURCES[name](spec, layout_of(message_class))
    verb, nested = _NESTED_CALLS[name]
    names = _COMMON_NAMES | more | {"CLASS": message_class, "new": message_class.__new__}
    names |= _TOLERANT_NAMES if tolerant else {}
    for field in spec.fields:
        names[f"KEY_{field.name}"] = pack(field.name)
        if field.type.is_message:
            inner = get_interface(field.type.base)
            names[function_name(verb, field.type.base)] = _nested_function(
                inner, nested, tolerant=tolerant
            )
    exec(compile(source, f"<codec of {spec.name}>", "exec"), names)  # noqa: S102 - our own text
    function: Callable[[Any], Any] = names[name]
    return function


def _dataclass_layout(message_class: type[Any]) -> Layout:
    # A dataclass has a list or bytes where a generated message class has an array.array.
    conversions = {}
    for name, hint in typing.get_type_hints(message_class).items():
        if hint is bytes:
            conversions[name] = "tobytes"
        elif typing.get_origin(hint) is list:
            conversions[name] = "tolist"
    return Layout(prefix="", keywords=True, conversions=conversions)
