"""Generators of the Python source that converts CDR to MessagePack and back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.interfaces import message_spec_of
from zbot.wire.cdr.alignment import COUNT_SIZE
from zbot.wire.cdr.decoder_source import DecoderSource
from zbot.wire.cdr.encoder_source import EncoderSource
from zbot.wire.messagepack.packing import ITEM_SIZE, map_header, pack

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.interfaces.spec import Field, FieldType, MessageSpec
    from zbot.wire.class_layout import ClassLayout


class MapReaderSource(DecoderSource):
    """Source of `convert(data)`, which returns MessagePack.

    For messages inside others, `convert(data, p, end)` returns the message as a map, and the
    position after the message.
    """

    def __init__(self, message_class: type[Any], *, nested: bool) -> None:
        self._is_nested = nested
        super().__init__(message_class, "<", nested=nested)

    @property
    def function_text(self) -> str:
        """The source of `convert`."""
        if self._is_nested:
            return "\n".join(["def convert(data, p, end):", *self.lines]) + "\n"
        return "\n".join(["def convert(data):", "    end = len(data)", *self.lines]) + "\n"

    def _message(self, message_class: type[Any], path: str) -> str:
        spec = message_spec_of(message_class)
        if not spec.fields:
            self._put("c", 1, self.fresh("x"))  # a structure without members is one byte in CDR
        is_outer = not path and not self._is_nested
        values = {}
        for field in spec.fields:
            value = self._field(field, f"{path}{field.name}")
            values[field.name] = value if is_outer else _wire_value(field, value)
        message = self.fresh("m")
        self._then(f"{message} = {_packed(spec, values) if is_outer else _map(values)}")
        return message

    def _value(self, kind: FieldType, path: str) -> str:
        if kind.kind == "scalar" and kind.base == "byte":
            value = self.fresh("x")
            self._put("B", 1, value)
            return value
        return super()._value(kind, path)

    def _fixed(self, kind: FieldType, path: str) -> str:
        if kind.base == "bool":
            return super()._fixed(kind, path)
        raw, size = self.fresh("r"), ITEM_SIZE.get(kind.typecode, 1)
        self._put(f"{kind.size * size}s", kind.size * size, raw, size)
        return raw

    def _packed_items(self, kind: FieldType, begin: str, end: str, path: str) -> str:
        if kind.base == "bool":
            return super()._packed_items(kind, begin, end, path)
        return f"data[{begin}:{end}]"


def _is_numeric_array(field: Field) -> bool:
    """Return whether a field is an array of numbers, which is sent as a binary or an extension."""
    return field.type.kind != "scalar" and bool(field.type.typecode)


def _wire_value(field: Field, value: str) -> str:
    if not _is_numeric_array(field) or field.type.typecode == "B":
        return value
    return f"extension_of({ord(field.type.typecode)}, {value})"


def _map(values: dict[str, str]) -> str:
    return f"{{{', '.join(f'{name!r}: {value}' for name, value in values.items())}}}"


def _packed(spec: MessageSpec, values: dict[str, str]) -> str:
    """Return the expression of a message's bytes. Arrays are copied once, into the joined bytes."""
    if not any(map(_is_numeric_array, spec.fields)):
        return f"pack({_map(values)})"
    parts, others = [repr(map_header(len(spec.fields)))], dict[str, str]()
    for field in spec.fields:
        value = values[field.name]
        if not _is_numeric_array(field):
            others[field.name] = value
            continue
        parts += _entries(others)
        others = {}
        code = field.type.typecode
        is_binary = code == "B"
        header = f"bin_header(len({value}))" if is_binary else ""
        parts += [repr(pack(field.name)), header or f"ext_header({ord(code)}, len({value}))", value]
    return f"b''.join(({', '.join([*parts, *_entries(others)])},))"


def _entries(values: dict[str, str]) -> Sequence[str]:
    """Return the expression for the entries of a map without the map's header."""
    return [f"pack({_map(values)})[{len(map_header(len(values)))}:]"] if values else []


class MapWriterSource(EncoderSource):
    """Source of `convert(data)`, which returns CDR.

    For messages inside others, `convert(parts, p, message)` appends the CDR of the map `message` to
    `parts`, and returns the position after this CDR.
    """

    def __init__(self, message_class: type[Any], *, nested: bool) -> None:
        self._is_nested = nested
        super().__init__(message_class, nested=nested)

    @property
    def function_text(self) -> str:
        """The source of `convert`."""
        if self._is_nested:
            return "\n".join(["def convert(parts, p, message):", *self.lines]) + "\n"
        begin = ["    message = unpack_raw(data)"]
        begin += ["    parts = []"] if self._has_list else []
        return "\n".join(["def convert(data):", *begin, *self.lines]) + "\n"

    def _member(self, layout: ClassLayout, variable: str, field: Field, path: str) -> str:
        del layout, path
        value = f"{variable}[{field.name!r}]"
        is_bool = field.type.kind == "scalar" and field.type.base == "bool"
        return f"BOOL[{value}]" if is_bool else value

    def _value(self, kind: FieldType, value: str, path: str) -> None:
        if kind.base == "byte":
            self._put("B", 1, value)
        else:
            super()._value(kind, value, path)

    def _packed(self, kind: FieldType, value: str, path: str) -> None:
        if kind.base == "bool":
            super()._packed(kind, value, path)
            return
        size, data = ITEM_SIZE.get(kind.typecode, 1), self.fresh("v")
        if kind.typecode in {"", "B"}:
            self.add(f"{data} = plain_bytes({path!r}, {value})")
        else:
            code = ord(kind.typecode)
            self.add(f"{data} = number_bytes({path!r}, {value}, {code}, {size})")
        if kind.size:
            compare = "!=" if kind.kind == "array" else ">"
            with self.block(f"if len({data}) {compare} {kind.size * size}:"):
                self.add(f"raise Fault({path!r}, '')")
        if kind.kind == "array":
            self._put(f"{kind.size * size}s", kind.size * size, data, size)
            return
        self._put("I", COUNT_SIZE, f"len({data}) // {size}" if size > 1 else f"len({data})")
        if self.known.padding(size) != 0:
            self._pad_items(data)
        self._part(data, f"len({data})", self.known.after_items(size))
