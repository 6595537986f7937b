"""Generator of the Python source that decodes MessagePack to messages of a type.

The source reads only bytes that have the form of `encoder_source`: all fields in their order, and
integers and texts in their shortest or in a longer form. In the source, `data` contains all bytes
of a message. The source writes a position as the sum of a variable and a constant. One
`struct.Struct` reads a struct (see `encoder_source`).
"""

from __future__ import annotations

from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.spec import INTEGER_RANGES
from zbot.wire.class_layout import layout_of
from zbot.wire.function_source import FunctionSource, element, is_inline
from zbot.wire.messagepack.encoder_source import FLOAT, fixed_numbers_header
from zbot.wire.messagepack.packing import map_header, pack
from zbot.wire.messagepack.value_reader import TIME_KEYS, UINT32, array_header

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType

_TIME = "builtin_interfaces/msg/Time"
_INT32_MAX = 2**31 - 1


class DecoderSource(FunctionSource):
    """Source of `decode(data)`, or of `read(data, p)` for messages inside others.

    `read` returns the inner message that begins at `p`, and the position after it.
    """

    def __init__(self, message_class: type[Any], *, nested: bool) -> None:
        super().__init__()
        self._base, self._offset = ("p" if nested else ""), 0  # their sum is before the struct
        self._format, self._size = "", 0
        self._targets: list[str] = []
        self._constants: list[bytes] = []  # the constants of the struct
        self._constant = b""  # bytes at the end of the struct that are the same in each message
        self._waiting: list[str] = []  # lines that follow the line of the struct
        self._inline = is_inline(message_spec_of(message_class))
        self.has_constructors = False  #: whether it calls the constructors of dataclasses
        message = self._message(message_class)
        self._flush_struct()
        if nested:
            self.add(f"return {message}, {self._position}")
            return
        # Slices of `data` may be too short. Then the position is now greater than the length.
        self._refuse(f"{self._position} != len(data)")
        self.add(f"return {message}")

    @property
    def text(self) -> str:
        """The source of `decode`. For bytes of another form, it returns `careful(data)`."""
        guarded = "\n".join(f"    {line}" for line in self.lines)
        return (
            "def decode(data):\n    try:\n"
            "        if type(data) is not bytes:\n            data = memoryview(data).tobytes()\n"
            f"{guarded}\n    except SHUTDOWN:\n        raise\n"
            "    except UNUSUAL:\n        return careful(data)\n"
        )

    @property
    def nested_text(self) -> str:
        """The source of `read`."""
        return "\n".join(["def read(data, p):", *self.lines]) + "\n"

    # -- messages and fields ---------------------------------------------------------------------

    def _message(self, message_class: type[Any]) -> str:
        """Add the lines that read a message. Return the name of the message's variable."""
        spec, values = message_spec_of(message_class), dict[str, str]()
        if spec.name == _TIME:
            values["sec"], values["nanosec"] = self._time()
        else:
            self._constant += map_header(len(spec.fields))
            for field in spec.fields:
                self._constant += pack(field.name)
                values[field.name] = self._field(field.type)
        return self._made(message_class, values)

    def _made(self, message_class: type[Any], values: dict[str, str]) -> str:
        """Add the lines that make a message from the expressions of its fields."""
        layout = layout_of(message_class)
        message, name = self.fresh("m"), self.constant("CLASS", message_class)
        if layout.keywords:
            self.has_constructors = True
            converted = _converted(message_class, values)
            arguments = ", ".join(f"{field}={value}" for field, value in converted.items())
            self._then(f"{message} = {name}({arguments})")
            return message
        new = self.constant("new", message_class.__new__)
        self._then(f"{message} = {new}({name})")
        for field_name, value in values.items():
            self._then(f"{message}.{layout.prefix}{field_name} = {value}")
        return message

    def _field(self, kind: FieldType) -> str:
        """Add the lines that read a field. Return the expression of the field's value.

        The expression may be used after the line of the current struct, i.e. in `_then`.
        """
        if kind.kind == "scalar":
            return self._value(kind)
        if kind.typecode and kind.kind == "array":
            return self._fixed_numbers(kind)
        if kind.typecode or kind.base == "byte":
            return self._binary(kind)
        count = self._count(kind)
        return self._loop(kind, count) if kind.is_message else self._items(kind, count)

    def _value(self, kind: FieldType) -> str:
        if kind.is_message:
            return self._nested(kind)
        if kind.base in INTEGER_RANGES:
            return self._integer(*INTEGER_RANGES[kind.base])
        if kind.is_string:
            return self._text(kind)
        if kind.base == "byte":
            return f"bytes(({self._integer(0, 255)},))"
        value = self.fresh("x")
        if kind.base == "bool":
            self._put(b"", "B", 1, value)
            self._then(_refusal(f"{value} & 0xFE != 0xC2"))
            return f"({value} == 0xC3)"
        self._put(FLOAT, "d", 8, value)
        if kind.base == "float32":
            self._then(_refusal(f"abs({value}) > FLOAT32_MAX and abs({value}) != inf"))
        return value

    def _nested(self, kind: FieldType) -> str:
        if self._inline:
            return self._message(get_interface(kind.base))
        self._flush_struct()
        message, end = self.fresh("m"), self.fresh("p")
        read = self.function_for("read", kind)
        self.add(f"{message}, {end} = {read}(data, {self._position})")
        self._move(end)
        return message

    def _integer(self, low: int, high: int) -> str:
        self._flush_struct()
        value, end, begin = self.fresh("x"), self.fresh("p"), self._position
        self.add(f"{value} = data[{begin}]")
        with self.block(f"if {value} < 0x80:"):
            self.add(f"{end} = {begin} + 1")
        if high >= _INT32_MAX:  # a smaller type cannot have this form; a call would take longer
            with self.block(f"elif {value} == 0xCE:"):
                self.add(f"{value}, = uint32(data, {begin} + 1)")
                self.add(f"{end} = {begin} + 5")
        with self.block("else:"):
            self.add(f"{value}, {end} = read_integer(data, {begin})")
        self._refuse(f"not {low} <= {value} <= {high}")
        self._move(end)
        return value

    def _time(self) -> tuple[str, str]:
        """Add the lines that read the integers of a time. Today, each of them has 5 bytes."""
        self._flush_struct()
        seconds, nanoseconds, end = self.fresh("x"), self.fresh("x"), self.fresh("p")
        keys, begin = (TIME_KEYS[0] + UINT32, TIME_KEYS[1] + UINT32), self._position
        unpack = Struct(f">{len(keys[0])}sI{len(keys[1])}sI")
        name = self.constant("UNPACK", unpack.unpack_from)
        self.add(f"{seconds} = 0x80000000")
        # The tag of the seconds is tested first. With a shorter time, the bytes may end too early.
        with self.block(f"if data[{begin} + {len(keys[0]) - 1}] == 0xCE:"):
            self.add(f"k0, {seconds}, k1, {nanoseconds} = {name}(data, {begin})")
            self.add(f"{end} = {begin} + {unpack.size}")
        with self.block(f"if {seconds} >= 0x80000000 or (k0, k1) != {keys!r}:"):
            self.add(f"{seconds}, {nanoseconds}, {end} = read_time(data, {begin})")
        self._move(end)
        return seconds, nanoseconds

    def _text(self, kind: FieldType) -> str:
        self._flush_struct()
        value, end, begin = self.fresh("s"), self.fresh("p"), self._position
        self.add(f"n = data[{begin}]")
        with self.block("if 0xA0 <= n < 0xC0:"):
            self.add(f"{end} = {begin} + n - {0xA0 - 1}")
            self.add(f"{value} = data[{begin} + 1:{end}].decode()")
        with self.block("elif n == 0xD9:"):
            self.add(f"{end} = {begin} + 2 + data[{begin} + 1]")
            self.add(f"{value} = data[{begin} + 2:{end}].decode()")
        with self.block("else:"):
            self.add(f"{value}, {end} = read_text(data, {begin})")
        if kind.string_bound:
            self._refuse(f"len({value}) > {kind.string_bound}")
        self._move(end)
        return value

    # -- arrays and sequences --------------------------------------------------------------------

    def _fixed_numbers(self, kind: FieldType) -> str:
        raw, values, code = self.fresh("r"), self.fresh("v"), kind.typecode
        header, size = fixed_numbers_header(kind)
        self._put(header, f"{size}s", size, raw)
        self._then(f"{values} = fixed_array({code!r}, array({code!r}, {raw}))")
        return values

    def _binary(self, kind: FieldType) -> str:
        """Add the lines that read a sequence of numbers, or an array or a sequence of `byte`."""
        self._flush_struct()
        values, end, typecode = self.fresh("v"), self.fresh("p"), kind.typecode
        code = 0 if typecode in {"", "B"} else ord(typecode)
        read = f"read_numbers(data, {self._position}, {typecode!r}, {code})"
        if kind.base == "byte":
            read = f"read_octets(data, {self._position})"
        self.add(f"{values}, {end} = {read}")
        if kind.size:
            compare = "!=" if kind.kind == "array" else ">"
            self._refuse(f"len({values}) {compare} {kind.size}")
        self._move(end)
        return values

    def _count(self, kind: FieldType) -> str:
        """Add the lines that read the header of an array or a sequence.

        Return the expression of the number of its items.
        """
        if kind.kind == "array":
            self._constant += array_header(kind.size)
            self._flush_struct()
            return str(kind.size)
        self._flush_struct()
        count, begin = self.fresh("n"), self.fresh("p")
        self.add(f"{count}, {begin} = read_count(data, {self._position})")
        if kind.size:
            self._refuse(f"{count} > {kind.size}")
        self._move(begin)
        return count

    def _items(self, kind: FieldType, count: str) -> str:
        """Add the lines that read the texts or bools of an array or a sequence."""
        values, end = self.fresh("v"), self.fresh("p")
        read = "read_texts" if kind.is_string else "read_bools"
        self.add(f"{values}, {end} = {read}(data, {self._position}, {count})")
        if kind.string_bound:
            self._refuse(f"max(map(len, {values}), default=0) > {kind.string_bound}")
        self._move(end)
        return values

    def _loop(self, kind: FieldType, count: str) -> str:
        """Add the lines that read the messages of an array or a sequence."""
        values = self.variable("v", "[]")
        self._set_p()
        with self.block(f"for _ in range({count}):"):
            value = self._value(element(kind))
            self._flush_struct()
            self.add(f"{values}.append({value})")
            self._set_p()
        return values

    # -- structs and positions -------------------------------------------------------------------

    @property
    def _position(self) -> str:
        """Expression of the position before the struct."""
        if not self._base:
            return str(self._offset)
        return f"{self._base} + {self._offset}" if self._offset else self._base

    def _move(self, variable: str) -> None:
        self._base, self._offset = variable, 0

    def _refuse(self, condition: str) -> None:
        self.add(_refusal(condition))

    def _set_p(self) -> None:
        """Put the position into the variable `p`. Each round of a loop begins at `p`.

        All loops share `p`, because an inner loop ends where its outer loop continues.
        """
        if self._position != "p":
            self.add(f"p = {self._position}")
        self._move("p")

    def _put(self, header: bytes, code: str, size: int, target: str) -> None:
        """Put a value and its constant header at the end of the struct."""
        self._constant += header
        self._take_constant()
        self._format += code
        self._size += size
        self._targets.append(target)

    def _take_constant(self) -> None:
        if self._constant:
            self._format += f"{len(self._constant)}s"
            self._size += len(self._constant)
            self._targets.append(f"k{len(self._constants)}")
            self._constants.append(self._constant)
            self._constant = b""

    def _then(self, line: str) -> None:
        """Add a line that follows the line of the struct, because it needs the struct's values.

        If there is no struct, the line is added at once.
        """
        if self._targets or self._constant:
            self._waiting.append(line)
        else:
            self.add(line)

    def _flush_struct(self) -> None:
        if not self._targets and self._constant:
            self._refuse(f"not data.startswith({self._constant!r}, {self._position})")
            self._offset += len(self._constant)
            self._constant = b""
        elif self._targets:
            self._take_constant()
            unpack = self.constant("UNPACK", Struct(f">{self._format}").unpack_from)
            self.add(f"{', '.join(self._targets)}, = {unpack}(data, {self._position})")
            names = "".join(f"k{index}, " for index in range(len(self._constants)))
            if self._constants:
                self._refuse(f"({names}) != {tuple(self._constants)!r}")
            self._offset += self._size
            self._format, self._size, self._targets, self._constants = "", 0, [], []
        waiting, self._waiting = self._waiting, []
        for line in waiting:
            self.add(line)


def _refusal(condition: str) -> str:
    return f"if {condition}: raise UnusualError"


def _converted(message_class: type[Any], values: dict[str, str]) -> dict[str, str]:
    """Return the expressions of a dataclass's fields, with lists and bytes in place of arrays."""
    conversions = layout_of(message_class).conversions
    numeric = {f.name for f in message_spec_of(message_class).fields if f.type.typecode}
    return {
        name: f"{value}.{conversions[name]}()" if name in conversions and name in numeric else value
        for name, value in values.items()
    }
