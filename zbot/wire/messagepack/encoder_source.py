"""Generator of the Python source that encodes messages of a type as MessagePack by runs.

A run is a group of neighbouring bytes whose number is known: names of fields, floats, bools and
arrays of fixed size. One `struct.Struct` packs a run. The bytes are the same as those of
`zbot.wire.messagepack.generator`, but most messages need less time.
"""

from __future__ import annotations

from struct import Struct
from typing import TYPE_CHECKING

from zbot.interfaces.spec import INTEGER_RANGES
from zbot.wire.cdr.alignment import spec_named
from zbot.wire.cdr.source import element
from zbot.wire.function_source import FunctionSource
from zbot.wire.messagepack.packing import ITEM_SIZE, bin_header, ext_header, map_header, pack
from zbot.wire.messagepack.value_reader import array_header

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType, MessageSpec

#: MessagePack's tag of a float of 64 bits
FLOAT = b"\xcb"


def fixed_numbers_header(kind: FieldType) -> tuple[bytes, int]:
    """Return the header of a numeric array of fixed size, and the size of its data in bytes."""
    code = kind.typecode
    size = ITEM_SIZE[code] * kind.size
    return bin_header(size) if code == "B" else ext_header(ord(code), size), size


class RunEncoderSource(FunctionSource):
    """Source of `encode(message)` for a type that `zbot.wire.run_codec.is_supported` accepts."""

    def __init__(self, spec: MessageSpec) -> None:
        super().__init__()
        self._format = ""
        self._values: list[str] = []
        self._constant = b""  # bytes at the end of the run that are the same in each message
        self._parts: list[str] = []  # expressions of the parts that are not yet in the list
        self._has_list = False
        self._message(spec, "message")
        self._flush_run()
        if self._has_list:
            self._add_parts()
            self.add("return b''.join(parts)")
        else:
            self.add(f"return b''.join(({', '.join(self._parts)},))")

    @property
    def text(self) -> str:
        """The source of `encode`. For an unusual message, it returns `careful(message)`."""
        body = ["    parts = []", *self.lines] if self._has_list else self.lines
        guarded = "\n".join(f"    {line}" for line in body)
        return (
            f"def encode(message):\n    try:\n{guarded}\n"
            "    except UNUSUAL:\n        return careful(message)\n"
        )

    def _message(self, spec: MessageSpec, variable: str) -> None:
        self._constant += map_header(len(spec.fields))
        for field in spec.fields:
            self._constant += pack(field.name)
            self._field(field.type, f"{variable}._{field.name}")

    def _field(self, kind: FieldType, value: str) -> None:
        if kind.kind == "scalar":
            self._value(kind, value)
        elif not kind.typecode:
            self._loop(kind, value)
        elif kind.kind == "array":
            self._fixed_numbers(kind, value)
        else:
            self._numbers(kind, value)

    def _value(self, kind: FieldType, value: str) -> None:
        if kind.is_message:
            variable = self._variable("m", value)
            self._message(spec_named(kind.base), variable)
        elif kind.base == "float64":
            self._run(FLOAT, "d", value)
        elif kind.base == "float32":
            number = self._variable("x", value)
            self.add(f"if abs({number}) > FLOAT32_MAX and abs({number}) != inf: raise UnusualError")
            self._run(FLOAT, "d", number)
        elif kind.base == "bool":
            self._run(b"", "B", f"BOOLS[{value}]")
        else:
            self._packed(kind, self._variable("x", value))

    def _packed(self, kind: FieldType, variable: str) -> None:
        """Write an integer, a `byte` or a text, whose size differs between messages."""
        if kind.base == "byte":
            self._part(f"pack(octet('', {variable}))")
            return
        usual = f"type({variable}) is str"
        if kind.base in INTEGER_RANGES:
            low, high = INTEGER_RANGES[kind.base]
            usual = f"type({variable}) is int and {low} <= {variable} <= {high}"
        self.add(f"if not ({usual}): raise UnusualError")
        self._part(f"pack({variable})")

    def _fixed_numbers(self, kind: FieldType, value: str) -> None:
        header, size = fixed_numbers_header(kind)
        convert = f"fixed_bytes('', {value}, {kind.typecode!r}, {kind.size})"
        self._run(header, f"{size}s", convert)

    def _numbers(self, kind: FieldType, value: str) -> None:
        values, code = self._variable("v", value), kind.typecode
        wrong = f"type({values}) is not array or {values}.typecode != {code!r}"
        self.add(f"if {wrong}: raise UnusualError")
        size = f"{ITEM_SIZE[code]} * len({values})"
        header = f"bin_header({size})" if code == "B" else f"ext_header({ord(code)}, {size})"
        self._part(header)
        self._part(values)

    def _loop(self, kind: FieldType, value: str) -> None:
        """Write an array or a sequence of messages or texts."""
        values, item = self._variable("v", value), self.fresh("i")
        wrong_length = f" or len({values}) != {kind.size}" if kind.kind == "array" else ""
        wrong_types = "" if kind.is_message else f" or set(map(type, {values})) - {{str}}"
        wrong = f"type({values}) is not list{wrong_length}{wrong_types}"
        self.add(f"if {wrong}: raise UnusualError")
        if kind.is_string:
            self._part(f"pack({values})")
            return
        self.add(f"{values} = {values}.copy()")  # another thread may change the list
        if kind.kind == "array":
            self._constant += array_header(kind.size)
        else:
            self._part(f"array_header(len({values}))")
        self._add_parts()
        with self.block(f"for {item} in {values}:"):
            self._value(element(kind), item)
            self._add_parts()

    # -- runs and parts --------------------------------------------------------------------------

    def _variable(self, prefix: str, value: str) -> str:
        variable = self.fresh(prefix)
        self.add(f"{variable} = {value}")
        return variable

    def _run(self, header: bytes, code: str, value: str) -> None:
        """Put a value and its constant header at the end of the run."""
        self._constant += header
        self._take_constant()
        self._format += code
        self._values.append(value)

    def _take_constant(self) -> None:
        if self._constant:
            self._format += f"{len(self._constant)}s"
            self._values.append(repr(self._constant))
            self._constant = b""

    def _flush_run(self) -> None:
        """Make the run a part."""
        if self._values:
            self._take_constant()
            run, pack_run = self.fresh("r"), self.constant("PACK", Struct(f">{self._format}").pack)
            self.add(f"{run} = {pack_run}({', '.join(self._values)})")
            self._parts.append(run)
            self._format, self._values = "", []
        elif self._constant:
            self._parts.append(repr(self._constant))
            self._constant = b""

    def _part(self, value: str) -> None:
        self._flush_run()
        self._parts.append(value)

    def _add_parts(self) -> None:
        """Add a line that puts all parts into the list."""
        self._flush_run()
        if self._parts:
            self.add(f"parts += ({', '.join(self._parts)},)")
        self._parts, self._has_list = [], True
