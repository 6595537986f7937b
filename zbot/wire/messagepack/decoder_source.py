"""Generator of the Python source that decodes MessagePack to messages of a type by runs.

The source reads only bytes that have the form of `encoder_source`: all fields in their order, and
integers and texts in their shortest or in a longer form. In the source, `data` contains all bytes
of a message. The source writes a position as the sum of a variable and a constant.
"""

from __future__ import annotations

from struct import Struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.spec import INTEGER_RANGES
from zbot.wire.cdr.source import element
from zbot.wire.function_source import FunctionSource
from zbot.wire.messagepack.encoder_source import FLOAT, fixed_numbers_header
from zbot.wire.messagepack.packing import map_header, pack
from zbot.wire.messagepack.value_reader import TIME_KEYS, UINT32, array_header

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType

_TIME = "builtin_interfaces/msg/Time"
_INT32_MAX = 2**31 - 1


class RunDecoderSource(FunctionSource):
    """Source of `decode(data)` for a type that `zbot.wire.run_codec.is_supported` accepts."""

    def __init__(self, message_class: type[Any]) -> None:
        super().__init__()
        self._base, self._offset = "", 0  # the position before the run is their sum
        self._format, self._size = "", 0
        self._targets: list[str] = []
        self._constants: list[bytes] = []  # the constants of the run
        self._constant = b""  # bytes at the end of the run that are the same in each message
        self._waiting: list[str] = []  # lines that follow the line of the run
        message = self._message(message_class)
        self._flush_run()
        # Slices of `data` may be too short. Then the position is now greater than the length.
        self.add(f"if {self._position} != len(data): raise UnusualError")
        self.add(f"return {message}")

    @property
    def text(self) -> str:
        """The source of `decode`. For bytes of another form, it returns `careful(data)`."""
        guarded = "\n".join(f"    {line}" for line in self.lines)
        return (
            "def decode(data):\n    if type(data) is not bytes:\n        return careful(data)\n"
            f"    try:\n{guarded}\n    except UNUSUAL:\n        return careful(data)\n"
        )

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
        message, name = self.fresh("m"), self.constant("CLASS", message_class)
        new = self.constant("new", message_class.__new__)
        self._then(f"{message} = {new}({name})")
        for field_name, value in values.items():
            self._then(f"{message}._{field_name} = {value}")
        return message

    def _field(self, kind: FieldType) -> str:
        """Add the lines that read a field. Return the expression of the field's value.

        The expression may be used after the line of the current run, i.e. in `_then`.
        """
        if kind.kind == "scalar":
            return self._value(kind)
        if not kind.typecode:
            return self._items(kind)
        return self._fixed_numbers(kind) if kind.kind == "array" else self._numbers(kind)

    def _value(self, kind: FieldType) -> str:
        if kind.is_message:
            return self._message(get_interface(kind.base))
        if kind.base in INTEGER_RANGES:
            return self._integer(*INTEGER_RANGES[kind.base])
        if kind.is_string:
            return self._text()
        if kind.base == "byte":
            return f"bytes(({self._integer(0, 255)},))"
        value = self.fresh("x")
        if kind.base == "bool":
            self._run(b"", "B", 1, value)
            self._then(f"if {value} & 0xFE != 0xC2: raise UnusualError")
            return f"({value} == 0xC3)"
        self._run(FLOAT, "d", 8, value)
        if kind.base == "float32":
            self._then(f"if abs({value}) > FLOAT32_MAX and abs({value}) != inf: raise UnusualError")
        return value

    def _integer(self, low: int, high: int) -> str:
        self._flush_run()
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
        self.add(f"if not {low} <= {value} <= {high}: raise UnusualError")
        self._move(end)
        return value

    def _time(self) -> tuple[str, str]:
        """Add the lines that read the integers of a time. Today, each of them has 5 bytes."""
        self._flush_run()
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

    def _text(self) -> str:
        self._flush_run()
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
        self._move(end)
        return value

    def _fixed_numbers(self, kind: FieldType) -> str:
        raw, values, code = self.fresh("r"), self.fresh("v"), kind.typecode
        header, size = fixed_numbers_header(kind)
        self._run(header, f"{size}s", size, raw)
        self._then(f"{values} = fixed_array({code!r}, array({code!r}, {raw}))")
        return values

    def _numbers(self, kind: FieldType) -> str:
        self._flush_run()
        values, end, typecode = self.fresh("v"), self.fresh("p"), kind.typecode
        code = 0 if typecode == "B" else ord(typecode)
        read = f"read_numbers(data, {self._position}, {typecode!r}, {code})"
        self.add(f"{values}, {end} = {read}")
        self._move(end)
        return values

    def _items(self, kind: FieldType) -> str:
        """Add the lines that read an array or a sequence of messages or texts."""
        values, count = self.fresh("v"), str(kind.size)
        if kind.kind == "array":
            self._constant += array_header(kind.size)
        self._flush_run()
        if kind.kind == "sequence":
            count, begin = self.fresh("n"), self.fresh("p")
            self.add(f"{count}, {begin} = read_count(data, {self._position})")
            self._move(begin)
        if kind.is_string:
            end = self.fresh("p")
            self.add(f"{values}, {end} = read_texts(data, {self._position}, {count})")
            self._move(end)
            return values
        self.add(f"{values} = []")
        self._set_p()
        with self.block(f"for _ in range({count}):"):
            value = self._value(element(kind))
            self._flush_run()
            self.add(f"{values}.append({value})")
            self._set_p()
        return values

    # -- runs and positions ----------------------------------------------------------------------

    @property
    def _position(self) -> str:
        """Expression of the position before the run."""
        if not self._base:
            return str(self._offset)
        return f"{self._base} + {self._offset}" if self._offset else self._base

    def _move(self, variable: str) -> None:
        self._base, self._offset = variable, 0

    def _set_p(self) -> None:
        """Put the position into the variable `p`. Each round of a loop begins at `p`.

        All loops share `p`, because an inner loop ends where its outer loop continues.
        """
        if self._position != "p":
            self.add(f"p = {self._position}")
        self._move("p")

    def _run(self, header: bytes, code: str, size: int, target: str) -> None:
        """Put a value and its constant header at the end of the run."""
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
        """Add a line that follows the line of the run, because it needs the values of the run.

        If there is no run, the line is added at once.
        """
        if self._targets or self._constant:
            self._waiting.append(line)
        else:
            self.add(line)

    def _flush_run(self) -> None:
        if not self._targets and self._constant:
            wrong = f"not data.startswith({self._constant!r}, {self._position})"
            self.add(f"if {wrong}: raise UnusualError")
            self._offset += len(self._constant)
            self._constant = b""
        elif self._targets:
            self._take_constant()
            unpack = self.constant("UNPACK", Struct(f">{self._format}").unpack_from)
            self.add(f"{', '.join(self._targets)}, = {unpack}(data, {self._position})")
            names = "".join(f"k{index}, " for index in range(len(self._constants)))
            if self._constants:
                self.add(f"if ({names}) != {tuple(self._constants)!r}: raise UnusualError")
            self._offset += self._size
            self._format, self._size, self._targets, self._constants = "", 0, [], []
        waiting, self._waiting = self._waiting, []
        for line in waiting:
            self.add(line)
