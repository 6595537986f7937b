"""Codec for XCDR1, the serialization that `rclpy.serialization` and raw subscriptions use.

A message is a header of four bytes, followed by the fields in order. The position of each number,
counted from the end of the header, is a multiple of the number's size. The rules and the test
vectors come from Fast CDR.
"""

from __future__ import annotations

import sys
from array import array
from dataclasses import dataclass
from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.errors import FieldTypeError, FieldValueError
from zbot.wire.errors import CodecError
from zbot.wire.messagepack import ITEM_SIZE
from zbot.wire.payload import is_cdr

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType

__all__ = ["cdr_codec_for"]

_LITTLE_ENDIAN = b"\x00\x01\x00\x00"
_HEADER_LENGTH = 4
_COUNT = {"<": Struct("<I"), ">": Struct(">I")}
_UNIT_BYTES = 4  # bytes that Fast CDR writes for one wide character


class _MalformedError(Exception):
    """The bytes are not a message of the type. The error's text is the reason."""


@dataclass(frozen=True, slots=True)
class CdrCodec:
    """Functions that encode and decode the messages of one type."""

    type_name: str
    encode: Callable[[Any], bytes]
    decode: Callable[[bytes], Any]


def cdr_codec_for(message_class: type[Any]) -> CdrCodec:
    """Return the codec of a message class. It is made at the first call and then reused.

    `encode` raises `CodecError` for a message of another class or with wrong values. `decode`
    raises `CodecError` for bytes that are not a message of the type. It ignores additional bytes
    after the message.

    Raises:
        NotAMessageTypeError: The class is not a message class.
    """
    codec = _codecs.get(message_class)
    if codec is None:
        codec = _codecs[message_class] = _codec(message_class)
    return codec


_codecs: dict[type, CdrCodec] = {}


def _codec(message_class: type[Any]) -> CdrCodec:
    name = message_spec_of(message_class).name
    write, read = _message_writer(message_class), _message_reader(message_class)

    def encode(message: Any) -> bytes:
        body = bytearray()
        try:
            write(body, message)
        except (AttributeError, TypeError, ValueError, OverflowError, ArithmeticError) as error:
            raise CodecError("encode", name, "", str(error)) from error
        return _LITTLE_ENDIAN + bytes(body)

    def decode(data: bytes) -> Any:
        try:
            return read(_Reader(data))
        except (_MalformedError, FieldTypeError, FieldValueError) as error:
            raise CodecError("decode", name, "", str(error)) from error

    return CdrCodec(name, encode, decode)


# -- writing ---------------------------------------------------------------------------------------


def _align(body: bytearray, size: int) -> None:
    body.extend(bytes(-len(body) % size))


def _write_count(body: bytearray, count: int) -> None:
    _align(body, 4)
    body += _COUNT["<"].pack(count)


def _message_writer(message_class: type[Any]) -> Callable[[bytearray, Any], None]:
    spec = message_spec_of(message_class)
    fields = [(field.name, _writer(field.type)) for field in spec.fields]

    def write(body: bytearray, message: Any) -> None:
        if not fields:
            body.append(0)  # a structure without members is one byte in CDR
        for name, write_field in fields:
            write_field(body, getattr(message, name))

    return write


def _writer(kind: FieldType) -> Callable[[bytearray, Any], None]:
    if kind.kind == "scalar":
        return _scalar_writer(kind)
    is_sequence = kind.kind == "sequence"
    if kind.typecode:
        return _numbers_writer(kind.typecode, is_sequence=is_sequence)
    write_item = _scalar_writer(kind)

    def write(body: bytearray, values: Any) -> None:
        if is_sequence:
            _write_count(body, len(values))
        for value in values:
            write_item(body, value)

    return write


def _numbers_writer(typecode: str, *, is_sequence: bool) -> Callable[[bytearray, Any], None]:
    def write(body: bytearray, values: Any) -> None:
        numbers = values if isinstance(values, array) else array(typecode, list(values))
        if is_sequence:
            _write_count(body, len(numbers))
        if len(numbers):
            _align(body, ITEM_SIZE[typecode])
        if sys.byteorder == "big":
            numbers = array(typecode, numbers)
            numbers.byteswap()
        body += numbers.tobytes()

    return write


def _scalar_writer(kind: FieldType) -> Callable[[bytearray, Any], None]:
    if kind.is_message:
        return _message_writer(get_interface(kind.base))
    if kind.base == "string":
        return _write_string
    if kind.base == "wstring":
        return _write_wide_string
    if kind.base == "bool":
        return lambda body, value: body.append(bool(value))
    if kind.base == "byte":
        return lambda body, value: body.append(value[0])
    layout = Struct(f"<{kind.typecode}")

    def write(body: bytearray, value: Any) -> None:
        _align(body, layout.size)
        body += layout.pack(value)

    return write


def _write_string(body: bytearray, text: str) -> None:
    data = text.encode()
    _write_count(body, len(data) + 1)
    body += data
    body.append(0)


def _write_wide_string(body: bytearray, text: str) -> None:
    units = array("H", text.encode("utf-16-le" if sys.byteorder == "little" else "utf-16-be"))
    _write_count(body, len(units))
    for unit in units:
        body += unit.to_bytes(_UNIT_BYTES, "little")


# -- reading ---------------------------------------------------------------------------------------


class _Reader:
    """Cursor over the bytes of a message. It raises an error if a read goes beyond the end."""

    def __init__(self, data: bytes) -> None:
        if not is_cdr(data) or len(data) < _HEADER_LENGTH:
            raise _MalformedError("the bytes do not begin with a CDR header")
        self.order = "<" if data[1] else ">"
        self._body = memoryview(data)[_HEADER_LENGTH:]
        self._position = 0

    def align(self, size: int) -> None:
        self._position += -self._position % size

    def take(self, size: int) -> memoryview:
        begin, end = self._position, self._position + size
        if end > len(self._body):
            raise _MalformedError("the bytes end before the message does")
        self._position = end
        return self._body[begin:end]

    def count(self, item_size: int) -> int:
        """Return the number of items that follow. Each item has at least `item_size` bytes."""
        self.align(4)
        count: int = _COUNT[self.order].unpack(self.take(4))[0]
        if count * item_size > len(self._body) - self._position:
            raise _MalformedError("a sequence is longer than the bytes that follow")
        return count


def _message_reader(message_class: type[Any]) -> Callable[[_Reader], Any]:
    spec = message_spec_of(message_class)
    fields = [(field.name, _reader(field.type)) for field in spec.fields]

    def read(reader: _Reader) -> Any:
        if not fields:
            reader.take(1)
        return message_class(**{name: read_field(reader) for name, read_field in fields})

    return read


def _reader(kind: FieldType) -> Callable[[_Reader], Any]:
    if kind.kind == "scalar":
        return _scalar_reader(kind)
    size = kind.size if kind.kind == "array" else None
    if kind.typecode:
        return _numbers_reader(kind.typecode, size)
    read_item = _scalar_reader(kind)

    def read(reader: _Reader) -> Any:
        count = reader.count(1) if size is None else size
        return [read_item(reader) for _ in range(count)]

    return read


def _numbers_reader(typecode: str, size: int | None) -> Callable[[_Reader], Any]:
    width = ITEM_SIZE[typecode]

    def read(reader: _Reader) -> Any:
        count = reader.count(width) if size is None else size
        numbers: array[Any] = array(typecode)
        if count:
            reader.align(width)
            numbers.frombytes(reader.take(count * width))
        if (reader.order == "<") != (sys.byteorder == "little"):
            numbers.byteswap()
        return numbers

    return read


def _scalar_reader(kind: FieldType) -> Callable[[_Reader], Any]:
    if kind.is_message:
        return _message_reader(get_interface(kind.base))
    if kind.base == "string":
        return _read_string
    if kind.base == "wstring":
        return _read_wide_string
    if kind.base == "bool":
        return _read_bool
    if kind.base == "byte":
        return lambda reader: bytes(reader.take(1))
    layouts = {order: Struct(f"{order}{kind.typecode}") for order in "<>"}
    size = layouts["<"].size

    def read(reader: _Reader) -> Any:
        reader.align(size)
        return layouts[reader.order].unpack(reader.take(size))[0]

    return read


def _read_bool(reader: _Reader) -> bool:
    value = reader.take(1)[0]
    if value > 1:
        raise _MalformedError(f"{value} is not a bool")
    return bool(value)


def _read_string(reader: _Reader) -> str:
    count = reader.count(1)
    data = bytes(reader.take(count))
    try:
        return data.rstrip(b"\0").decode() if count else ""
    except UnicodeDecodeError:
        raise _MalformedError("a text is not valid UTF-8") from None


def _read_wide_string(reader: _Reader) -> str:
    count = reader.count(_UNIT_BYTES)
    order = "little" if reader.order == "<" else "big"
    units = [int.from_bytes(reader.take(_UNIT_BYTES), order) for _ in range(count)]  # type: ignore[arg-type]
    try:
        return b"".join(unit.to_bytes(2, "little") for unit in units).decode("utf-16-le")
    except (OverflowError, UnicodeDecodeError):
        raise _MalformedError("a wide text is not valid UTF-16") from None
