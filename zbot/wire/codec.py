"""Messages to MessagePack and back: one generated pack and one unpack function for each type.

What arrives is checked in full. Any bytes give either a message whose every field is valid, or one
`CodecError`; memory stays in proportion to the bytes that arrived.
"""

from __future__ import annotations

import math
import typing
from array import array
from dataclasses import dataclass, is_dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from zbot.errors import CodecError, NotAMessageTypeError
from zbot.interfaces import get_interface, spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.interfaces.spec import MessageSpec
from zbot.wire import check, generator
from zbot.wire.check import Fault
from zbot.wire.generator import Layout, is_numeric_array
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

_ERRORS = (Fault, AttributeError, TypeError, ValueError, OverflowError, MemoryError, BufferError)


@dataclass(frozen=True, slots=True)
class Codec(Generic[MessageT]):
    """How messages of one type become bytes, and bytes messages."""

    type_name: str  #: `std_msgs/msg/String`
    encoding: str  #: Zenoh encoding of the bytes
    encode: Callable[[MessageT], bytes]
    decode: Callable[[Bytes], MessageT]
    source: str  #: the generated functions, for a person to read


def codec_for(message_class: type[MessageT]) -> Codec[MessageT]:
    """Return the codec of a message class, made at the first call for it.

    Raises:
        NotAMessageTypeError: The class is no message's.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = _codec(message_class)
    return codec


@dataclass(frozen=True, slots=True)
class _Functions:
    """The generated functions of one class."""

    spec: MessageSpec
    source: str
    to_map: Callable[[Any], dict[str, Any]]
    to_parts: Callable[[Any], tuple[Any, ...]] | None  #: only with numeric arrays
    from_map: Callable[[Any], Any]


_codecs: dict[type, Codec[Any]] = {}
_functions: dict[type, _Functions] = {}


def _codec(message_class: type[Any]) -> Codec[Any]:
    functions = _functions_of(message_class)
    name = functions.spec.name
    return Codec(
        name,
        encoding(name),
        _encoder(message_class, functions),
        _decoder(functions),
        functions.source,
    )


def _encoder(message_class: type[Any], functions: _Functions) -> Callable[[Any], bytes]:
    to_map, to_parts = functions.to_map, functions.to_parts

    def encode_map(message: Any) -> bytes:
        try:
            return pack(to_map(message))
        except _ERRORS as error:
            raise _encode_error(message_class, functions, message, error) from error

    if to_parts is None:
        return encode_map

    def encode_parts(message: Any) -> bytes:
        try:
            return b"".join(to_parts(message))
        except _ERRORS as error:
            raise _encode_error(message_class, functions, message, error) from error

    return encode_parts


def _decoder(functions: _Functions) -> Callable[[Bytes], Any]:
    name, from_map = functions.spec.name, functions.from_map
    arrays = {pack(f.name): f.name for f in functions.spec.fields if is_numeric_array(f)}

    def decode(data: Bytes) -> Any:
        try:
            if arrays and len(data) >= LARGE:
                return from_map(_unpack_large(data, arrays))
            return from_map(unpack(data))
        except Fault as fault:
            raise CodecError("decode", name, fault.path, fault.reason) from None
        except UnreadableError as error:
            raise CodecError("decode", name, "", str(error)) from error
        except Exception as error:  # a dataclass may raise anything
            raise CodecError("decode", name, "", f"{type(error).__name__}: {error}") from error

    return decode


def _unpack_large(data: Bytes, arrays: dict[bytes, str]) -> Any:
    lifted = lift_arrays(data, arrays)
    if lifted is None:
        return unpack(data)
    values = unpack(lifted[0])
    values.update(lifted[1])
    return values


def _encode_error(
    message_class: type[Any], functions: _Functions, message: Any, error: Exception
) -> CodecError:
    name = functions.spec.name
    if isinstance(error, Fault):
        return CodecError("encode", name, error.path, error.reason)
    if not isinstance(message, message_class):
        return CodecError("encode", name, "", f"expected a {name}, not {check.kind(message)}")
    if isinstance(error, UnicodeEncodeError):
        field = _path_of(error.object, functions.to_map(message))
        return CodecError("encode", name, field, f"{error.object!r:.40} cannot be written as UTF-8")
    return CodecError("encode", name, "", f"{type(error).__name__}: {error}")


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


def _functions_of(message_class: type[Any]) -> _Functions:
    functions = _functions.get(message_class)
    if functions is None:
        functions = _functions[message_class] = _generate(message_class)
    return functions


def _generate(message_class: type[Any]) -> _Functions:
    spec = spec_of(message_class)
    if not isinstance(spec, MessageSpec):
        reason = "it is a service or an action; the parts of it, such as Request, are messages"
        raise NotAMessageTypeError(message_class, reason)
    layout = _dataclass_layout(message_class) if is_dataclass(message_class) else Layout()
    sources = [
        generator.to_map_source(spec, layout),
        generator.from_map_source(spec, layout),
    ]
    if any(map(is_numeric_array, spec.fields)):
        sources.append(generator.to_parts_source(spec, layout))
    source = "\n\n".join(sources)
    names = _namespace(message_class, spec)
    exec(compile(source, f"<codec of {spec.name}>", "exec"), names)  # noqa: S102 - our own text
    return _Functions(spec, source, names["to_map"], names.get("to_parts"), names["from_map"])


def _dataclass_layout(message_class: type[Any]) -> Layout:
    # The annotations say list or bytes where a generated message class has array.array.
    conversions = {}
    for name, hint in typing.get_type_hints(message_class).items():
        if hint is bytes:
            conversions[name] = "tobytes"
        elif typing.get_origin(hint) is list:
            conversions[name] = "tolist"
    return Layout(prefix="", keywords=True, conversions=conversions)


def _namespace(message_class: type[Any], spec: MessageSpec) -> dict[str, Any]:
    """Return the names that a type's generated source uses."""
    names = dict(vars(check))
    names |= {"pack": pack, "bin_header": bin_header, "ext_header": ext_header}
    names |= {"extension": extension, "array": array, "fixed_array": fixed_array}
    names |= {"CLASS": message_class, "new": message_class.__new__, "EMPTY": {}}
    names |= {"inf": math.inf, "nan": math.nan}
    for field in spec.fields:
        names[f"KEY_{field.name}"] = pack(field.name)
        if field.type.is_message:
            nested = _functions_of(get_interface(field.type.base))
            names[generator.function_name("pack", field.type.base)] = nested.to_map
            names[generator.function_name("unpack", field.type.base)] = nested.from_map
    return names
