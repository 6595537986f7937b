"""Transcoder of messages from CDR to MessagePack and back, with generated code for each type.

The generated code makes no message object. If it cannot convert a message, e.g. because a field is
missing, the type's codecs decode and encode the message. The codecs fill in defaults, or raise an
error that says what is wrong.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from typing import Any

from zbot.interfaces import message_spec_of
from zbot.wire import validation
from zbot.wire.cdr import values as cdr_values
from zbot.wire.cdr.codec import cdr_codec_for
from zbot.wire.function_source import compiled
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.messagepack.packing import bin_header, ext_header, pack
from zbot.wire.transcoder import values as map_values
from zbot.wire.transcoder.source import MapReaderSource, MapWriterSource
from zbot.wire.validation import UNUSUAL_ERRORS

__all__ = ["to_cdr", "to_messagepack"]

_COMMON_NAMES: dict[str, Any] = {
    **vars(validation),
    **vars(cdr_values),
    **vars(map_values),
    "HEADER": b"\x00\x01\x00\x00",
    "array": array,
    "pack": pack,
    "bin_header": bin_header,
    "ext_header": ext_header,
}


Converter = Callable[[bytes], bytes]

_converters: dict[tuple[type, type[Any]], Converter] = {}
_functions: dict[tuple[type, type[Any], bool], Callable[..., Any]] = {}


def to_messagepack(message_class: type[Any]) -> Converter:
    """Return a function that converts a class's messages from CDR to MessagePack.

    The function may be called from any thread. It raises `CodecError` if the bytes are not a
    message of the type.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    return _converter(
        message_class, MapReaderSource, cdr_codec_for, messagepack_codec_for, begin=b"\x00\x01"
    )


def to_cdr(message_class: type[Any]) -> Converter:
    """Return a function that converts a class's messages from MessagePack to CDR, little-endian.

    The function may be called from any thread. It raises `CodecError` if the bytes are not a
    message of the type.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    return _converter(message_class, MapWriterSource, messagepack_codec_for, cdr_codec_for)


def _converter(
    message_class: type[Any],
    source_class: type[MapReaderSource | MapWriterSource],
    reader_for: Callable[[type[Any]], Any],
    writer_for: Callable[[type[Any]], Any],
    begin: bytes = b"",
) -> Converter:
    key = message_class, source_class
    if key not in _converters:
        decode, encode = reader_for(message_class).decode, writer_for(message_class).encode
        fast = _function(message_class, source_class)
        _converters[key] = _transcoder(fast, lambda data: encode(decode(data)), begin)
    return _converters[key]


def _transcoder(fast: Converter, careful: Converter, begin: bytes) -> Converter:
    """Return a function that tries `fast` first if the bytes start with `begin`.

    `fast` reads only little-endian CDR, because numbers in MessagePack arrays are little-endian.
    """

    def transcode(data: bytes) -> bytes:
        if data.startswith(begin):
            try:
                return fast(data)
            except UNUSUAL_ERRORS:
                pass  # `careful` fills in defaults or raises the error
        return careful(data)

    return transcode


def _function(
    message_class: type[Any],
    source_class: type[MapReaderSource | MapWriterSource],
    *,
    nested: bool = False,
) -> Callable[..., Any]:
    key = message_class, source_class, nested
    if key not in _functions:
        source = source_class(message_class, nested=nested)
        called = {
            name: _function(cls, source_class, nested=True) for name, cls in source.called.items()
        }
        names = _COMMON_NAMES | source.names | called
        title = f"transcoder of {message_spec_of(message_class).name}"
        _functions[key] = compiled(source.function_text, "convert", names, title)
    return _functions[key]
