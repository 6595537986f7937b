"""Fast encoders and decoders with generated code for each type.

They work for usual messages, and for bytes as zbot sends them. For all others, they call the
functions of `walker`, which convert or reject them. Both send the same bytes.
"""

from __future__ import annotations

import math
import struct
from array import array
from typing import TYPE_CHECKING, Any

from zbot.errors import ExternalShutdownException
from zbot.interfaces import message_spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.wire import validation
from zbot.wire.function_source import compiled
from zbot.wire.messagepack import value_reader
from zbot.wire.messagepack.decoder_source import DecoderSource
from zbot.wire.messagepack.encoder_source import EncoderSource
from zbot.wire.messagepack.packing import bin_header, ext_header, pack
from zbot.wire.validation import UNUSUAL_ERRORS

if TYPE_CHECKING:
    from collections.abc import Callable

_NAMES: dict[str, Any] = {
    **vars(validation),
    **vars(value_reader),
    "BOOLS": {False: 0xC2, True: 0xC3},
    "SHUTDOWN": ExternalShutdownException,
    "UNUSUAL": UNUSUAL_ERRORS,
    "array": array,
    "bin_header": bin_header,
    "ext_header": ext_header,
    "fixed_array": fixed_array,
    "inf": math.inf,
    "pack": pack,
    "uint32": struct.Struct(">I").unpack_from,
}
_nested_functions: dict[tuple[type[Any], str], Callable[..., Any]] = {}


def encoder(message_class: type[Any], careful: Callable[[Any], bytes]) -> Callable[[Any], bytes]:
    """Return a function that encodes messages of a class. It calls `careful` if it cannot."""
    source = EncoderSource(message_class, nested=False)
    names = _names(source, "write") | {"careful": careful}
    return compiled(source.text, "encode", names, _title(message_class))


def decoder(message_class: type[Any], careful: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a function that decodes messages of a class. It calls `careful` if it cannot."""
    source = DecoderSource(message_class, nested=False)
    names = _names(source, "read") | {"careful": careful}
    if source.has_constructors or source.called:
        names["UNUSUAL"] = Exception  # a constructor may raise any exception
    return compiled(source.text, "decode", names, _title(message_class))


def source(message_class: type[Any]) -> str:
    """Return the source of the encoder and the decoder of a class."""
    encode = EncoderSource(message_class, nested=False).text
    return f"{encode}\n\n{DecoderSource(message_class, nested=False).text}"


def _names(source: EncoderSource | DecoderSource, verb: str) -> dict[str, Any]:
    """Return the values of the names in a source, with the functions that it calls."""
    called = {name: _nested_function(cls, verb) for name, cls in source.called.items()}
    return _NAMES | source.names | called


def _nested_function(message_class: type[Any], verb: str) -> Callable[..., Any]:
    """Return the function that reads or writes a class's messages inside other messages."""
    key = message_class, verb
    if key not in _nested_functions:
        source_class = EncoderSource if verb == "write" else DecoderSource
        source = source_class(message_class, nested=True)
        names, title = _names(source, verb), _title(message_class)
        _nested_functions[key] = compiled(source.nested_text, verb, names, title)
    return _nested_functions[key]


def _title(message_class: type[Any]) -> str:
    return f"MessagePack codec of {message_spec_of(message_class).name}"
