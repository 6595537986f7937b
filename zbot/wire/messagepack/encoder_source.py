"""Generator of the Python source that encodes messages of a type as MessagePack.

Neighbouring bytes whose number is known form a *struct*: names of fields, floats, bools and arrays
of fixed size. One `struct.Struct` packs a struct. The generated function joins structs and other
parts. The bytes are the same as those of `walker`.
"""

from __future__ import annotations

from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.spec import INTEGER_RANGES
from zbot.wire.class_layout import layout_of
from zbot.wire.function_source import FunctionSource, element, is_inline
from zbot.wire.messagepack.packing import ITEM_SIZE, bin_header, ext_header, map_header, pack
from zbot.wire.messagepack.value_reader import array_header

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType

#: MessagePack's tag of a float of 64 bits
FLOAT = b"\xcb"


def fixed_numbers_header(kind: FieldType) -> tuple[bytes, int]:
    """Return the header of a numeric array of fixed size, and the size of its data in bytes."""
    code = kind.typecode
    size = ITEM_SIZE[code] * kind.size
    return bin_header(size) if code == "B" else ext_header(ord(code), size), size


class EncoderSource(FunctionSource):
    """Source of `encode(message)`, or of `write(parts, message)` for messages inside others.

    `write` appends the parts of the inner message to `parts`.
    """

    def __init__(self, message_class: type[Any], *, nested: bool) -> None:
        super().__init__()
        self._format = ""
        self._values: list[str] = []
        self._constant = b""  # bytes at the end of the struct that are the same in each message
        self._parts: list[str] = []  # expressions of the parts that are not yet in the list
        self._has_list = nested
        self._inline = is_inline(message_spec_of(message_class))
        self._message(message_class, "message")
        self._flush_struct()
        if self._has_list:
            self._add_parts()
        if not nested:
            parts = "parts" if self._has_list else f"({', '.join(self._parts)},)"
            self.add(f"return b''.join({parts})")

    @property
    def text(self) -> str:
        """The source of `encode`. For an unusual message, it returns `careful(message)`."""
        body = ["    parts = []", *self.lines] if self._has_list else self.lines
        guarded = "\n".join(f"    {line}" for line in body)
        return (
            f"def encode(message):\n    try:\n{guarded}\n"
            "    except UNUSUAL:\n        return careful(message)\n"
        )

    @property
    def nested_text(self) -> str:
        """The source of `write`."""
        return "\n".join(["def write(parts, message):", *self.lines]) + "\n"

    # -- messages and fields ---------------------------------------------------------------------

    def _message(self, message_class: type[Any], variable: str) -> None:
        layout, fields = layout_of(message_class), message_spec_of(message_class).fields
        self._constant += map_header(len(fields))
        for field in fields:
            self._constant += pack(field.name)
            value = f"{variable}.{layout.prefix}{field.name}"
            # A dataclass does not check its fields, and has lists in place of arrays.
            self._field(field.type, _checked(field.type, value) if layout.keywords else value)

    def _field(self, kind: FieldType, value: str) -> None:
        if kind.kind == "scalar":
            self._value(kind, value)
        elif kind.base == "byte":
            octets = f"octets('', {value}, {kind.size}, fixed={kind.kind == 'array'})"
            self._binary(self.variable("v", octets))
        elif not kind.typecode:
            self._items(kind, self.variable("v", value))
        elif kind.kind == "array":
            self._fixed_numbers(kind, value)
        else:
            self._numbers(kind, self.variable("v", value))

    def _value(self, kind: FieldType, value: str) -> None:
        if kind.is_message:
            self._nested(kind, value)
        elif kind.base == "float64":
            self._put(FLOAT, "d", value)
        elif kind.base == "float32":
            number = self.variable("x", value)
            self._refuse(f"abs({number}) > FLOAT32_MAX and abs({number}) != inf")
            self._put(FLOAT, "d", number)
        elif kind.base == "bool":
            self._put(b"", "B", f"BOOLS[{value}]")
        else:
            self._packed(kind, self.variable("x", value))

    def _nested(self, kind: FieldType, value: str) -> None:
        if self._inline:
            self._message(get_interface(kind.base), self.variable("m", value))
            return
        self._add_parts()
        self.add(f"{self.function_for('write', kind)}(parts, {value})")

    def _packed(self, kind: FieldType, variable: str) -> None:
        """Write an integer, a `byte` or a text, whose size differs between messages."""
        if kind.base == "byte":
            self._part(f"pack(octet('', {variable}))")
            return
        usual = f"type({variable}) is str"
        if kind.string_bound:
            usual += f" and len({variable}) <= {kind.string_bound}"
        if kind.base in INTEGER_RANGES:
            low, high = INTEGER_RANGES[kind.base]
            usual = f"type({variable}) is int and {low} <= {variable} <= {high}"
        self._refuse(f"not ({usual})")
        self._part(f"pack({variable})")

    # -- arrays and sequences --------------------------------------------------------------------

    def _fixed_numbers(self, kind: FieldType, value: str) -> None:
        header, size = fixed_numbers_header(kind)
        convert = f"fixed_bytes('', {value}, {kind.typecode!r}, {kind.size})"
        self._put(header, f"{size}s", convert)

    def _numbers(self, kind: FieldType, values: str) -> None:
        code = kind.typecode
        wrong = f"type({values}) is not array or {values}.typecode != {code!r}"
        self._refuse(wrong + _wrong_length(kind, values))
        if code == "B":
            self._binary(values)
            return
        self._part(f"ext_header({ord(code)}, {ITEM_SIZE[code]} * len({values}))")
        self._part(values)

    def _binary(self, data: str) -> None:
        self._part(f"bin_header(len({data}))")
        self._part(data)

    def _items(self, kind: FieldType, values: str) -> None:
        """Write an array or a sequence of messages, texts or bools."""
        wrong = f"type({values}) is not list{_wrong_length(kind, values)}"
        if not kind.is_message:
            wrong += f" or set(map(type, {values})) - {{{'str' if kind.is_string else 'bool'}}}"
        if kind.string_bound:
            wrong += f" or max(map(len, {values}), default=0) > {kind.string_bound}"
        self._refuse(wrong)
        if kind.is_message:
            self._loop(kind, values)
        else:
            self._part(f"pack({values})")

    def _loop(self, kind: FieldType, values: str) -> None:
        item = self.fresh("i")
        self.add(f"{values} = {values}.copy()")  # another thread may change the list
        if kind.kind == "array":
            self._constant += array_header(kind.size)
        else:
            self._part(f"array_header(len({values}))")
        self._add_parts()
        with self.block(f"for {item} in {values}:"):
            self._value(element(kind), item)
            self._add_parts()

    # -- structs and parts -----------------------------------------------------------------------

    def _refuse(self, condition: str) -> None:
        self.add(f"if {condition}: raise UnusualError")

    def _put(self, header: bytes, code: str, value: str) -> None:
        """Put a value and its constant header at the end of the struct."""
        self._constant += header
        self._take_constant()
        self._format += code
        self._values.append(value)

    def _take_constant(self) -> None:
        if self._constant:
            self._format += f"{len(self._constant)}s"
            self._values.append(repr(self._constant))
            self._constant = b""

    def _flush_struct(self) -> None:
        """Make the struct a part."""
        if self._values:
            self._take_constant()
            pack_struct = self.constant("PACK", Struct(f">{self._format}").pack)
            self._parts.append(self.variable("b", f"{pack_struct}({', '.join(self._values)})"))
            self._format, self._values = "", []
        elif self._constant:
            self._parts.append(repr(self._constant))
            self._constant = b""

    def _part(self, value: str) -> None:
        self._flush_struct()
        self._parts.append(value)

    def _add_parts(self) -> None:
        """Add a line that puts all parts into the list."""
        self._flush_struct()
        if self._parts:
            self.add(f"parts += ({', '.join(self._parts)},)")
        self._parts, self._has_list = [], True


def _wrong_length(kind: FieldType, values: str) -> str:
    compare = "!=" if kind.kind == "array" else ">"
    return f" or len({values}) {compare} {kind.size}" if kind.size else ""


def _checked(kind: FieldType, value: str) -> str:
    """Return the expression of a value that is checked and converted, if it can need this."""
    if kind.kind == "sequence" and kind.typecode:
        return f"numbers('', {value}, {kind.typecode!r}, {kind.size}, fixed=False)"
    check = {"bool": "boolean", "float32": "real", "float64": "real"}.get(kind.base)
    return f"{check}('', {value})" if check and kind.kind == "scalar" else value
