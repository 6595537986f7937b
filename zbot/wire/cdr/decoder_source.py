"""Generator of the Python source that decodes CDR to messages of a type.

In the source, `data` contains all bytes of the message, with the header. The source writes a
position as the sum of a variable and a constant. A struct is a group of values that one
`struct.Struct` reads (see `source`).
"""

from __future__ import annotations

import sys
from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.wire.cdr.alignment import COUNT_SIZE, START, UNIT_SIZE, Alignment
from zbot.wire.cdr.source import Source
from zbot.wire.class_layout import layout_of
from zbot.wire.function_source import element, is_inline
from zbot.wire.messagepack.packing import ITEM_SIZE

if TYPE_CHECKING:
    from zbot.interfaces.spec import Field, FieldType

HEADER_SIZE = 4
#: size in bytes from which an array is read by `large`, which copies the numbers only once
LARGE = 1 << 12


class DecoderSource(Source):
    """Source of `decode(data)`, or of `read(data, p, end)` for messages inside others.

    `p` is the position at which the inner message begins, and `end` is the length of `data`.

    Args:
        message_class: The class of the messages.
        order: Order of the bytes in numbers, `<` or `>`.
        nested: Whether the source is that of `read`, which returns the message and the position
            after it.
        tolerant: Whether to read values that are not valid, as rclpy does: bytes of a text that
            are not UTF-8 become U+FFFD, and each bool that is not 0 is true.
    """

    def __init__(
        self, message_class: type[Any], order: str, *, nested: bool, tolerant: bool = False
    ) -> None:
        super().__init__(Alignment() if nested else START)
        self._tolerant = tolerant
        self._order = order
        self._swapped = (order == "<") != (sys.byteorder == "little")
        self._variable, self._offset = ("p", 0) if nested else ("", HEADER_SIZE)
        self._targets: list[str] = []
        self._waiting: list[str] = []  # lines that use the values of the struct
        self._inline = is_inline(message_spec_of(message_class))
        message = self._message(message_class, "")
        self._flush_struct()
        self.add(f"return {message}, {self._position}" if nested else f"return {message}")

    @property
    def text(self) -> str:
        """The source of `decode`."""
        guarded = "\n".join(f"    {line}" for line in self.lines)
        return (
            "def decode(data):\n    try:\n        end = len(data)\n"
            f"{guarded}\n    except ERRORS as error:\n        explain(error)\n"
        )

    @property
    def nested_text(self) -> str:
        """The source of `read`."""
        return "\n".join(["def read(data, p, end):", *self.lines]) + "\n"

    # -- messages and fields ---------------------------------------------------------------------

    def _message(self, message_class: type[Any], path: str) -> str:
        """Add the lines that read a message. Return the name of the message's variable."""
        layout, spec = layout_of(message_class), message_spec_of(message_class)
        if not spec.fields:
            self._put("c", 1, self.fresh("x"))  # a structure without members is one byte in CDR
        values = {f.name: self._field(f, f"{path}{f.name}") for f in spec.fields}
        for field in spec.fields:
            method = layout.conversions.get(field.name)
            if method and field.type.typecode:
                values[field.name] += f".{method}()"
        message, name = self.fresh("m"), self.constant("CLASS", message_class)
        if layout.keywords:
            fields = ", ".join(f"{field}={value}" for field, value in values.items())
            self._then(f"{message} = {name}({fields})")
            return message
        self._then(f"{message} = {self.constant('new', message_class.__new__)}({name})")
        for field_name, value in values.items():
            self._then(f"{message}.{layout.prefix}{field_name} = {value}")
        return message

    def _field(self, field: Field, path: str) -> str:
        """Add the lines that read a field. Return the expression of the field's value."""
        kind = field.type
        if kind.kind == "scalar":
            return self._value(kind, path)
        if kind.kind == "array":
            if kind.typecode or kind.base in {"bool", "byte"}:
                return self._fixed(kind, path)
            return self._loop(kind, str(kind.size), path)
        count = self.fresh("n")
        self._put("I", COUNT_SIZE, count)
        self._flush_struct()
        if kind.size:
            with self.block(f"if {count} > {kind.size}:"):
                self.add(f"length({path!r}, {count}, {kind.size}, fixed=False)")
        if kind.typecode or kind.base in {"bool", "byte"}:
            return self._packed(kind, count, path)
        least = self.layout.least_size(kind)
        with self.block(f"if {count} * {least} > end - {self._grouped}:"):
            self.add(f"raise Fault({path!r}, TOO_LONG)")
        return self._loop(kind, count, path)

    def _value(self, kind: FieldType, path: str) -> str:
        if kind.is_message:
            return self._nested(kind, path)
        if kind.is_string:
            return self._text(kind, path)
        value = self.fresh("x")
        if kind.base == "bool":
            self._put("B", 1, value)
            if not self._tolerant:
                self._then(f"if {value} > 1: raise Fault({path!r}, f'{{{value}}} is not a bool')")
            return f"({value} != 0)"
        self._put(kind.typecode or "c", ITEM_SIZE.get(kind.typecode, 1), value)
        return value

    def _nested(self, kind: FieldType, path: str) -> str:
        if self._inline:
            return self._message(get_interface(kind.base), f"{path}.")
        self._flush_struct()
        message, position = self.fresh("m"), self.fresh("p")
        read = self.function_for("read", kind)
        self.add(f"{message}, {position} = {read}(data, {self._position}, end)")
        self._move(position, Alignment())
        return message

    def _text(self, kind: FieldType, path: str) -> str:
        count, end, text = self.fresh("n"), self.fresh("e"), self.fresh("t")
        self._put("I", COUNT_SIZE, count)
        self._flush_struct()
        begin = self._position
        if kind.base == "wstring":
            self.add(f"{end} = {begin} + {UNIT_SIZE} * {count}")
            self._check_end(end, path)
            self.add(f"{text} = wide_text({path!r}, data[{begin}:{end}], {self._order!r})")
            self._move(end, Alignment(UNIT_SIZE, 0))
        else:
            self.add(f"{end} = {begin} + {count}")
            # As in Fast CDR, the last byte belongs to the text if it is not NUL.
            without_nul, whole = f"data[{begin}:{end} - 1]", f"data[{begin}:{end}]"
            decode = "decode('utf-8', 'replace')" if self._tolerant else "decode()"
            self.add(f"{text} = ({whole} if data[{end} - 1] else {without_nul}).{decode}")
            self._move(end, Alignment())
        if kind.string_bound:
            with self.block(f"if len({text}) > {kind.string_bound}:"):
                self.add(f"text({path!r}, {text}, {kind.string_bound})")
        return text

    # -- arrays and sequences --------------------------------------------------------------------

    def _fixed(self, kind: FieldType, path: str) -> str:
        """Add a fixed-size array of numbers, bools or bytes to the struct."""
        raw, values = self.fresh("r"), self.fresh("v")
        size = ITEM_SIZE.get(kind.typecode, 1)
        self._put(f"{kind.size * size}s", kind.size * size, raw, size)
        if not kind.typecode:
            self._then(f"{values} = {kind.base}_items({path!r}, {raw})")
            return values
        self._then(f"{values} = array({kind.typecode!r}, {raw})")
        if self._swapped:
            self._then(f"{values}.byteswap()")
        self._then(f"{values} = fixed_array({kind.typecode!r}, {values})")
        return values

    def _packed(self, kind: FieldType, count: str, path: str) -> str:
        """Add the lines that read a sequence of numbers, bools or bytes."""
        size, begin = ITEM_SIZE.get(kind.typecode, 1), self._position
        # Only items of 8 bytes can need padding, because the count ends at a multiple of 4.
        if self.known.padding(size) != 0:
            start = self.fresh("p")
            aligned = _aligned(begin, size)
            self.add(f"{start} = {aligned} if {count} else {begin}")
            self._move(start, Alignment(COUNT_SIZE, 0))
            begin = start
        values, end = self.fresh("v"), self.fresh("e")
        self.add(f"{end} = {begin} + {f'{size} * ' if size > 1 else ''}{count}")
        self._check_end(end, path)
        self.add(f"{values} = {self._packed_items(kind, begin, end, path)}")
        if kind.typecode and self._swapped:
            self.add(f"{values}.byteswap()")
        self._move(end, self.known.after_items(size))
        return values

    def _packed_items(self, kind: FieldType, begin: str, end: str, path: str) -> str:
        """Return the expression of the numbers, bools or bytes between two positions."""
        if not kind.typecode:
            return f"{kind.base}_items({path!r}, data[{begin}:{end}])"
        code = repr(kind.typecode)
        small, large = f"array({code}, data[{begin}:{end}])", f"large({code}, data, {begin}, {end})"
        return f"{small} if {end} - ({begin}) < {LARGE} else {large}"

    def _loop(self, kind: FieldType, count: str, path: str) -> str:
        """Add the lines that read an array or a sequence of messages or texts."""
        self._flush_struct()
        values, append = self.fresh("v"), self.fresh("append")
        self._set_p()
        self.known = start = self.layout.loop_start(element(kind), self.known)
        self.add(f"{values} = []")
        self.add(f"{append} = {values}.append")
        with self.block(f"for _ in range({count}):"):
            value = self._value(element(kind), f"{path}[]")
            self._flush_struct()
            self.add(f"{append}({value})")
            self._set_p()
        self.known = start
        return values

    # -- structs and positions -------------------------------------------------------------------

    @property
    def _position(self) -> str:
        """Expression of the position before the struct."""
        if not self._variable:
            return str(self._offset)
        return f"{self._variable} + {self._offset}" if self._offset else self._variable

    @property
    def _grouped(self) -> str:
        return f"({self._position})" if self._variable and self._offset else self._position

    def _move(self, variable: str, known: Alignment) -> None:
        self._variable, self._offset, self.known = variable, 0, known

    def _set_p(self) -> None:
        """Put the position into the variable `p`. Each round of a loop begins at `p`."""
        if self._position != "p":
            self.add(f"p = {self._position}")
        self._variable, self._offset = "p", 0

    def _put(self, code: str, size: int, target: str, alignment: int = 0) -> None:
        """Put a value at the end of the struct.

        If the value's padding is not known, the value begins a new struct.
        """
        alignment = alignment or size
        padding = self.known.padding(alignment)
        if padding is None:
            self._flush_struct()
            start = self.fresh("p")
            self.add(f"{start} = {_aligned(self._position, alignment)}")
            self._move(start, Alignment(alignment, 0))
            padding = 0
        self.pad_struct(padding, code, size)
        self._targets.append(target)

    def _then(self, line: str) -> None:
        """Add a line after the struct. The line can use the values of the struct."""
        if self._targets:
            self._waiting.append(line)
        else:
            self.add(line)

    def _flush_struct(self) -> None:
        code, size = self.take_struct()
        if not self._targets:
            return
        unpack = self.constant("UNPACK", Struct(f"{self._order}{code}").unpack_from)
        self.add(f"{', '.join(self._targets)}, = {unpack}(data, {self._position})")
        self._offset += size
        waiting, self._targets, self._waiting = self._waiting, [], []
        for line in waiting:
            self.add(line)

    def _check_end(self, end: str, path: str) -> None:
        with self.block(f"if {end} > end:"):
            self.add(f"raise Fault({path!r}, TOO_LONG)")


def _aligned(position: str, size: int) -> str:
    """Return the expression of the next aligned position, counted from the end of the header."""
    if size == 8:
        return f"({position} + 3 & -8) + 4"
    return f"{position} + {size - 1} & -{size}"
