"""Codec that converts messages to MessagePack and back.

For any bytes, the decoder either returns a valid message or raises `CodecError`. Its memory use is
proportional to the number of bytes.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from zbot.interfaces import message_spec_of
from zbot.wire.keys import encoding
from zbot.wire.messagepack import generated_codec
from zbot.wire.messagepack.packing import BIG_ENDIAN, Bytes
from zbot.wire.messagepack.walker import Walker

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["MessagePackCodec", "messagepack_codec_for"]

MessageT = TypeVar("MessageT")


class MessagePackCodec(Generic[MessageT]):
    """Encoder and decoder for messages of one type.

    The encoder and the decoder are each generated at first use, because most processes need only
    one of them for a type. A machine with big-endian numbers uses only the walker.

    Args:
        message_class: A message class or a dataclass.

    Raises:
        NotAMessageTypeError: The class is not a message class or a dataclass.
    """

    def __init__(self, message_class: type[MessageT]) -> None:
        self._class = message_class
        self._walker = Walker(message_class)
        self.type_name = message_spec_of(message_class).name  #: `std_msgs/msg/String`
        self.encoding = encoding(self.type_name)  #: Zenoh encoding of the bytes

    @property
    def source(self) -> str:
        """Source of the generated `encode` and `decode`, for debugging."""
        return generated_codec.source(self._class)

    @cached_property
    def encode(self) -> Callable[[MessageT], bytes]:
        """Return the bytes of a message. Raise `CodecError` if a field cannot be sent."""
        careful = self._walker.encode
        return careful if BIG_ENDIAN else generated_codec.encoder(self._class, careful)

    @cached_property
    def decode(self) -> Callable[[Bytes], MessageT]:
        """Return the message that bytes contain. Raise `CodecError` if the bytes are not valid.

        Some values that are not valid are read as in rclpy: bytes of a text that are not UTF-8
        become U+FFFD, and a bool that is a number other than 0 is true.
        """
        return self._decoder(self._walker.decode_tolerantly)

    @cached_property
    def decode_strictly(self) -> Callable[[Bytes], MessageT]:
        """Do the same as `decode`, but refuse all values that are not valid."""
        return self._decoder(self._walker.decode)

    def _decoder(self, careful: Callable[[Bytes], MessageT]) -> Callable[[Bytes], MessageT]:
        return careful if BIG_ENDIAN else generated_codec.decoder(self._class, careful)


_codecs: dict[type, MessagePackCodec[Any]] = {}


def messagepack_codec_for(message_class: type[MessageT]) -> MessagePackCodec[MessageT]:
    """Return the codec of a message class. It is made at the first call and then reused.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = MessagePackCodec(message_class)
    return codec
