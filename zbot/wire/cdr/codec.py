"""Codec for XCDR1, the serialization that `rclpy.serialization` and raw subscriptions use.

A message is a header of four bytes, followed by the fields in order. The position of each number,
counted from the end of the header, is a multiple of the number's size. The rules and the test
vectors come from Fast CDR. Each type has generated code, which is compiled at first use.
"""

from __future__ import annotations

import struct
from array import array
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, NoReturn, TypeVar

from zbot.errors import ExternalShutdownException
from zbot.interfaces import message_spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.wire import validation
from zbot.wire.cdr import values
from zbot.wire.cdr.decoder_source import HEADER_SIZE, DecoderSource
from zbot.wire.cdr.encoder_source import EncoderSource
from zbot.wire.errors import CodecError
from zbot.wire.function_source import compiled
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.messagepack.packing import BIG_ENDIAN
from zbot.wire.payload import is_cdr
from zbot.wire.validation import Fault

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.wire.cdr.source import Source

__all__ = ["CdrCodec", "cdr_codec_for"]

MessageT = TypeVar("MessageT")

_LITTLE_ENDIAN = b"\x00\x01\x00\x00"
_ERRORS = (
    Fault,
    struct.error,
    AttributeError,
    TypeError,
    ValueError,
    ArithmeticError,
    MemoryError,
    BufferError,
)
_REASONS: dict[type[Exception], str] = {
    struct.error: "the bytes end before the message does",
    IndexError: "a text is longer than the bytes that follow",
    UnicodeDecodeError: "a text is not valid UTF-8",
    MemoryError: "it is too large for this machine's memory",
}
_COMMON_NAMES: dict[str, Any] = {
    **vars(validation),
    **vars(values),
    "BIG_ENDIAN": BIG_ENDIAN,
    "HEADER": _LITTLE_ENDIAN,
    "array": array,
    "fixed_array": fixed_array,
}
_TOLERANT_NAMES: dict[str, Any] = {
    "bool_items": values.any_bool_items,
    "wide_text": values.any_wide_text,
}


class CdrCodec(Generic[MessageT]):
    """Encoder and decoder for messages of one type, each generated at first use.

    Args:
        message_class: A message class or a dataclass.

    Raises:
        NotAMessageTypeError: The class is not a message class or a dataclass.
    """

    def __init__(self, message_class: type[MessageT]) -> None:
        self.type_name = message_spec_of(message_class).name  #: `std_msgs/msg/String`
        self._class = message_class

    @cached_property
    def encode(self) -> Callable[[MessageT], bytes]:
        """Return the bytes of a message. Raise `CodecError` if a field has a wrong value."""
        source = EncoderSource(self._class, nested=False)
        names = {"ERRORS": _ERRORS, "explain": self._explain_encoding}
        return _compiled(self._class, source, source.text, "encode", names | _writers(source))

    def decode(self, data: bytes) -> MessageT:
        """Return the message that bytes contain. Ignore additional bytes after the message.

        Values that are not valid are read as in rclpy: bytes of a text that are not UTF-8 become
        U+FFFD, and a bool of 2 is true.

        Raises:
            CodecError: The bytes are not a message of the type.
        """
        try:
            return self.decode_strictly(data)
        except CodecError as error:
            if not is_cdr(data):
                raise
            try:
                return self._tolerant_decoders[data[1] & 1](data)
            except CodecError:
                raise error from None

    def decode_strictly(self, data: bytes) -> MessageT:
        """Do the same as `decode`, but refuse values that are not valid.

        Raises:
            CodecError: The bytes are not a message of the type, or a value is not valid.
        """
        if data[:2] == b"\0\1" and len(data) >= HEADER_SIZE:
            return self._decode_little(data)
        if is_cdr(data) and len(data) >= HEADER_SIZE:
            return self._decode_big(data)
        reason = "the bytes do not begin with a CDR header"
        raise CodecError("decode", self.type_name, "", reason)

    @cached_property
    def _decode_little(self) -> Callable[[bytes], MessageT]:
        return self._decoder("<", tolerant=False)

    @cached_property
    def _decode_big(self) -> Callable[[bytes], MessageT]:
        return self._decoder(">", tolerant=False)

    @cached_property
    def _tolerant_decoders(self) -> Sequence[Callable[[bytes], MessageT]]:
        return [self._decoder(order, tolerant=True) for order in "><"]

    def _decoder(self, order: str, *, tolerant: bool) -> Callable[[bytes], MessageT]:
        source = DecoderSource(self._class, order, nested=False, tolerant=tolerant)
        # The constructor of a dataclass may raise any exception.
        names = {"ERRORS": Exception, "explain": self._explain_decoding}
        names |= _readers(source, order, tolerant=tolerant)
        return _compiled(self._class, source, source.text, "decode", names)

    def _explain_encoding(self, message: Any, error: Exception) -> NoReturn:
        if isinstance(error, Fault):
            raise CodecError("encode", self.type_name, error.path, error.reason) from None
        # The MessagePack codec checks each value. Its error contains the name of the wrong field.
        messagepack_codec_for(self._class).encode(message)
        raise CodecError("encode", self.type_name, "", str(error)) from error

    def _explain_decoding(self, error: Exception) -> NoReturn:
        if isinstance(error, ExternalShutdownException):
            raise error  # a signal during decoding does not make the message invalid
        if isinstance(error, Fault):
            raise CodecError("decode", self.type_name, error.path, error.reason) from None
        other = f"{type(error).__name__}: {error}"
        reason = next((_REASONS[cls] for cls in type(error).__mro__ if cls in _REASONS), other)
        raise CodecError("decode", self.type_name, "", reason) from error


_codecs: dict[type, CdrCodec[Any]] = {}
_nested_functions: dict[tuple[type, str], Callable[..., Any]] = {}


def cdr_codec_for(message_class: type[MessageT]) -> CdrCodec[MessageT]:
    """Return the codec of a message class. It is made at the first call and then reused.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = CdrCodec(message_class)
    return codec


def _writers(source: Source) -> dict[str, Any]:
    """Return the functions that write nested messages, by their names in a source."""
    return {name: _writer(cls) for name, cls in source.called.items()}


def _readers(source: Source, order: str, *, tolerant: bool) -> dict[str, Any]:
    """Return what a decoder calls: the readers of nested messages, and of some values."""
    values = _TOLERANT_NAMES if tolerant else {}
    return values | {name: _reader(cls, order, tolerant) for name, cls in source.called.items()}


def _writer(message_class: type[Any]) -> Callable[..., Any]:
    key = message_class, "write"
    if key not in _nested_functions:
        source = EncoderSource(message_class, nested=True)
        _nested_functions[key] = _compiled(
            message_class, source, source.nested_text, "write", _writers(source)
        )
    return _nested_functions[key]


def _reader(message_class: type[Any], order: str, tolerant: bool) -> Callable[..., Any]:
    key = message_class, f"tolerant {order}" if tolerant else order
    if key not in _nested_functions:
        source = DecoderSource(message_class, order, nested=True, tolerant=tolerant)
        names = _readers(source, order, tolerant=tolerant)
        _nested_functions[key] = _compiled(message_class, source, source.nested_text, "read", names)
    return _nested_functions[key]


def _compiled(
    message_class: type[Any], source: Source, text: str, name: str, more: dict[str, Any]
) -> Callable[..., Any]:
    title = f"CDR codec of {message_spec_of(message_class).name}"
    return compiled(text, name, _COMMON_NAMES | source.names | more, title)
