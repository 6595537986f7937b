"""Reference codec of MessagePack: it walks over the fields of a message and checks each value.

The generated code of `generated_codec` is faster, and gives all that is unusual to this codec:
values that must be converted or rejected, and bytes that other programs send, e.g. with fields in
another order. For any bytes, the decoder either returns a valid message or raises `CodecError`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, NoReturn, TypeVar

from zbot.errors import ExternalShutdownException
from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.interfaces.default_size import DefaultMemory
from zbot.interfaces.spec import STRING_TYPES, TYPECODES
from zbot.wire import validation
from zbot.wire.class_layout import ClassLayout, layout_of
from zbot.wire.errors import CodecError
from zbot.wire.messagepack.packing import (
    Bytes,
    UnreadableError,
    extension,
    pack,
    unpack,
    unpack_any_text,
)
from zbot.wire.validation import Fault

if TYPE_CHECKING:
    from zbot.interfaces.spec import Field, FieldType

MessageT = TypeVar("MessageT")

_ENCODING_ERRORS = (
    Fault,
    AttributeError,
    TypeError,
    ValueError,
    OverflowError,
    MemoryError,
    BufferError,
)
_ZERO: dict[str, Any] = {"bool": False, "byte": b"\0"}
_ZERO |= dict.fromkeys(TYPECODES, 0) | dict.fromkeys(STRING_TYPES, "")
_MISSING: Any = object()  # in place of a field that the sender left out


class Walker(Generic[MessageT]):
    """Encoder and decoder for messages of one type."""

    def __init__(self, message_class: type[MessageT]) -> None:
        self._class = message_class
        self._type_name = message_spec_of(message_class).name

    def encode(self, message: MessageT) -> bytes:
        """Return the bytes of a message. Raise `CodecError` if a field cannot be sent."""
        try:
            return pack(_map_of(self._class, message))
        except _ENCODING_ERRORS as error:
            self._explain_encoding(message, error)

    def decode(self, data: Bytes) -> MessageT:
        """Return the message that bytes contain. Raise `CodecError` if the bytes are not valid."""
        return self._decode(data, tolerant=False)

    def decode_tolerantly(self, data: Bytes) -> MessageT:
        """Do the same as `decode`, but read some values that are not valid, as rclpy does.

        Bytes of a text that are not UTF-8 become U+FFFD, and a bool that is a number other than 0
        is true.
        """
        try:
            return self.decode(data)
        except CodecError as error:
            try:
                return self._decode(data, tolerant=True)
            except CodecError:
                raise error from None

    def _decode(self, data: Bytes, *, tolerant: bool) -> MessageT:
        try:
            values = unpack_any_text(data) if tolerant else unpack(data)
            reader = _MapReader(len(data), tolerant=tolerant)
            message: MessageT = reader.message(self._class, values)
        except ExternalShutdownException:
            raise  # a signal during decoding does not make the message invalid
        except Exception as error:  # noqa: BLE001 - the constructor of a dataclass may raise any
            cause = None if isinstance(error, Fault) else error
            raise CodecError("decode", self._type_name, *_path_and_reason(error)) from cause
        return message

    def _explain_encoding(self, message: Any, error: Exception) -> NoReturn:
        path, reason = _path_and_reason(error)
        if not isinstance(message, self._class) and not isinstance(error, Fault):
            reason = f"expected a {self._type_name}, not {validation.kind(message)}"
        elif isinstance(error, UnicodeEncodeError):
            path = _path_of(error.object, _map_of(self._class, message))
            reason = f"{error.object!r:.40} cannot be written as UTF-8"
        cause = None if isinstance(error, Fault) else error
        raise CodecError("encode", self._type_name, path, reason) from cause


_members: dict[type, tuple[ClassLayout, tuple[Field, ...]]] = {}


def _layout_and_fields(message_class: type[Any]) -> tuple[ClassLayout, tuple[Field, ...]]:
    found = _members.get(message_class)
    if found is None:
        fields = message_spec_of(message_class).fields
        found = _members[message_class] = layout_of(message_class), fields
    return found


def _map_of(message_class: type[Any], message: Any) -> dict[str, Any]:
    """Return a message as a map of plain values, which `pack` writes."""
    layout, fields = _layout_and_fields(message_class)
    return {
        field.name: _packable(field.type, field.name, getattr(message, layout.prefix + field.name))
        for field in fields
    }


def _packable(kind: FieldType, path: str, value: Any) -> Any:
    """Return the value of a field as a plain value."""
    fixed = kind.kind == "array"
    if kind.kind == "scalar":
        return _packable_item(kind, path, value)
    if kind.typecode:
        numbers = validation.numbers(path, value, kind.typecode, kind.size, fixed=fixed)
        return (
            memoryview(numbers) if kind.typecode == "B" else extension(ord(kind.typecode), numbers)
        )
    if kind.base == "byte":
        return validation.octets(path, value, kind.size, fixed=fixed)
    items = validation.items(path, value, kind.size, fixed=fixed)
    return [_packable_item(kind, f"{path}[{index}]", item) for index, item in enumerate(items)]


def _packable_item(kind: FieldType, path: str, value: Any) -> Any:
    if kind.base == "byte":
        return validation.octet(path, value)
    if not kind.is_message:
        return validation.scalar(kind, path, value)
    try:
        return _map_of(get_interface(kind.base), value)
    except Fault as fault:
        raise fault.inside(path) from None
    except AttributeError:
        raise validation.wrong(path, f"a {kind.base}", value) from None


class _MapReader:
    """Maker of messages from maps, which `unpack` returned for one message of `size` bytes."""

    def __init__(self, size: int, *, tolerant: bool) -> None:
        self._memory = DefaultMemory(size)
        self._tolerant = tolerant

    def message(self, message_class: type[Any], values: Any) -> Any:
        """Return the message in a map."""
        if type(values) is not dict:
            raise validation.wrong("", "a map", values)
        layout, members = _layout_and_fields(message_class)
        fields = dict[str, Any]()
        for field in members:
            value = self._field(field, values.get(field.name, _MISSING))
            if field.type.typecode and field.name in layout.conversions:
                value = getattr(value, layout.conversions[field.name])()
            fields[field.name] = value
        if layout.keywords:
            return message_class(**fields)
        new: Any = message_class.__new__
        message = new(message_class)
        for name, value in fields.items():
            setattr(message, layout.prefix + name, value)
        return message

    def _field(self, field: Field, value: Any) -> Any:
        """Return the value of a field. A field that the sender left out has its default."""
        kind, path, fixed = field.type, field.name, field.type.kind == "array"
        value = _default(field) if value is _MISSING else value
        if kind.kind == "scalar":
            return self._item(kind, path, value)
        if kind.typecode:
            numbers = validation.numbers_from(path, value, kind.typecode, kind.size, fixed=fixed)
            return fixed_array(kind.typecode, numbers) if fixed else numbers
        if kind.base == "byte" and isinstance(value, bytes):
            value = list(value)
        items = validation.items(path, value, kind.size, fixed=fixed)
        if not self._memory.suffices(kind, len(items)):
            raise Fault(path, "the messages in it leave out too many values")
        return [self._item(kind, f"{path}[{index}]", item) for index, item in enumerate(items)]

    def _item(self, kind: FieldType, path: str, value: Any) -> Any:
        if kind.is_message:
            try:
                return self.message(get_interface(kind.base), value)
            except Fault as fault:
                raise fault.inside(path) from None
        if kind.base == "byte":
            return validation.octet_from(path, value)
        if kind.base == "bool" and self._tolerant:
            return validation.any_boolean(path, value)
        return validation.scalar(kind, path, value)


def _default(field: Field) -> Any:
    """Return the value of a field that the sender left out, as a sender could send it."""
    kind = field.type
    if field.default is not None:
        return list(field.default) if isinstance(field.default, tuple) else field.default
    zero: Any = {} if kind.is_message else _ZERO[kind.base]
    return zero if kind.kind == "scalar" else [zero] * kind.size * (kind.kind == "array")


def _path_and_reason(error: Exception) -> tuple[str, str]:
    if isinstance(error, Fault):
        return error.path, error.reason
    is_unreadable = isinstance(error, UnreadableError)
    return "", str(error) if is_unreadable else f"{type(error).__name__}: {error}"


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
