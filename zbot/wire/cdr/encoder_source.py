"""Generator of the Python source that encodes the messages of a type as CDR.

The generated function joins parts: packed structs (see `source`), texts and arrays. Its
variable `p` is the number of bytes of all earlier parts, without the header. The source computes
`p` only where a padding depends on `p`.
"""

from __future__ import annotations

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
    from zbot.wire.class_layout import ClassLayout


class EncoderSource(Source):
    """Source of `encode(message)`, or of `write(parts, p, message)` for messages inside others.

    `write` appends the parts of the inner message to `parts`, and returns the new value of `p`.
    """

    def __init__(self, message_class: type[Any], *, nested: bool) -> None:
        super().__init__(Alignment() if nested else START)
        self._parts: list[str] = []  # expressions of the parts that are not yet in the list
        self._values: list[str] = []
        self._lead = 0  # alignment of a struct whose padding depends on `p`
        self._base, self._constant = ("p", 0) if nested else ("", 0)
        self._lengths: list[str] = []  # `p` is the base plus the constant plus these lengths
        self._has_list = nested
        if not nested:
            self.format, self._values = "4s", ["HEADER"]
        self._inline = is_inline(message_spec_of(message_class))
        self._message(message_class, "message", "")
        if nested:
            self._sync()
            self.add("return p")
        else:
            self._return()

    @property
    def text(self) -> str:
        """The source of `encode`."""
        body = ["    parts = []", *self.lines] if self._has_list else self.lines
        guarded = "\n".join(f"    {line}" for line in body)
        return (
            f"def encode(message):\n    try:\n{guarded}\n"
            "    except ERRORS as error:\n        explain(message, error)\n"
        )

    @property
    def nested_text(self) -> str:
        """The source of `write`."""
        return "\n".join(["def write(parts, p, message):", *self.lines]) + "\n"

    # -- messages and fields ---------------------------------------------------------------------

    def _message(self, message_class: type[Any], variable: str, path: str) -> None:
        layout, spec = layout_of(message_class), message_spec_of(message_class)
        if not spec.fields:
            self.pad_struct(0, "x", 1)  # a structure without members is one byte in CDR
        for field in spec.fields:
            here = f"{path}{field.name}"
            self._field(field, self._member(layout, variable, field, here), here)

    def _member(self, layout: ClassLayout, variable: str, field: Field, path: str) -> str:
        """Return the expression of a message's field."""
        value = f"{variable}.{layout.prefix}{field.name}"
        if layout.keywords and field.type.kind == "scalar" and field.type.base == "bool":
            return f"boolean({path!r}, {value})"  # a dataclass does not check its fields
        return value

    def _field(self, field: Field, value: str, path: str) -> None:
        kind = field.type
        if kind.kind == "scalar":
            self._value(kind, value, path)
        elif kind.typecode or kind.base in {"bool", "byte"}:
            self._packed(kind, value, path)
        elif kind.base == "string" and kind.kind == "sequence":
            self._texts(kind, value, path)
        else:
            self._loop(kind, value, path)

    def _value(self, kind: FieldType, value: str, path: str) -> None:
        if kind.is_message:
            self._nested(kind, value, path)
        elif kind.is_string:
            self._text(kind, value, path)
        else:
            code = kind.typecode or {"bool": "?", "byte": "c"}[kind.base]
            self._put(code, ITEM_SIZE.get(kind.typecode, 1), value)

    def _nested(self, kind: FieldType, value: str, path: str) -> None:
        if self._inline:
            variable = self.fresh("m")
            self.add(f"{variable} = {value}")
            self._message(get_interface(kind.base), variable, f"{path}.")
            return
        self._sync()
        self.add(f"p = {self.function_for('write', kind)}(parts, p, {value})")
        self.known = Alignment()

    def _text(self, kind: FieldType, value: str, path: str) -> None:
        data, length = self.fresh("s"), self.fresh("n")
        if kind.string_bound:
            value = f"text({path!r}, {value}, {kind.string_bound})"
        if kind.base == "wstring":
            self.add(f"{data} = wide_units({value})")
            self.add(f"{length} = len({data})")
            self._put("I", COUNT_SIZE, f"{length} // {UNIT_SIZE}")
            self._part(data, length, Alignment(UNIT_SIZE, 0))
            return
        self.add(f"{data} = {value}.encode() + b'\\0'")
        self.add(f"{length} = len({data})")
        self._put("I", COUNT_SIZE, length)
        self._part(data, length, Alignment())

    # -- arrays and sequences --------------------------------------------------------------------

    def _packed(self, kind: FieldType, value: str, path: str) -> None:
        """Write an array or a sequence of numbers, bools or bytes.

        An array is added to the struct. The items of a sequence are one part.
        """
        size = ITEM_SIZE.get(kind.typecode, 1)
        if kind.kind == "array":
            convert = f"fixed_bytes({path!r}, {value}, {kind.typecode!r}, {kind.size})"
            if not kind.typecode:
                convert = _converted(kind, value, path)
            self._put(f"{kind.size * size}s", kind.size * size, convert, size)
            return
        data, length = self.fresh("v"), self.fresh("n")
        if kind.typecode:
            too_long = f" or len({data}) > {kind.size}" if kind.size else ""
            self.add(f"{data} = {value}")
            typecode = repr(kind.typecode)
            wrong = f"BIG_ENDIAN or type({data}) is not array or {data}.typecode != {typecode}"
            with self.block(f"if {wrong}{too_long}:"):
                self.add(
                    f"{data} = numbers({path!r}, {data}, {typecode}, {kind.size}, fixed=False)"
                )
        else:
            self.add(f"{data} = {_converted(kind, value, path)}")
        self.add(f"{length} = len({data})")
        self._put("I", COUNT_SIZE, length)
        if self.known.padding(size) != 0:
            self._pad_items(length)
        total = length if size == 1 else f"{size} * {length}"
        self._part(data, total, self.known.after_items(size))

    def _pad_items(self, length: str) -> None:
        """Write the padding between a sequence's count and its items of 8 bytes.

        An empty sequence has no padding.
        """
        padding = self.fresh("z")
        self._flush_struct()
        self._set_position()
        self.add(f"{padding} = FOUR_ZEROS if {length} and p & 4 else b''")
        self._part(padding, f"len({padding})", Alignment(COUNT_SIZE, 0))

    def _texts(self, kind: FieldType, value: str, path: str) -> None:
        """Write a sequence of texts. All its texts together are one part."""
        values, data = self.fresh("v"), self.fresh("s")
        bounds = f"{kind.size}, fixed=False, bound={kind.string_bound}"
        self.add(f"{values} = {value}")
        if kind.string_bound:
            self.add(f"{values} = texts({path!r}, {values}, {bounds})")
        else:
            self._check_list(kind, values, path)
        self.add(f"{data} = text_items({values})")
        self._put("I", COUNT_SIZE, f"len({values})")
        self._part(data, f"len({data})", Alignment())

    def _loop(self, kind: FieldType, value: str, path: str) -> None:
        """Write an array or a sequence of messages or texts."""
        values, item = self.fresh("v"), self.fresh("i")
        self.add(f"{values} = {value}")
        self._check_list(kind, values, path)
        if kind.kind == "sequence":
            self._put("I", COUNT_SIZE, f"len({values})")
        self._sync()
        self.known = start = self.layout.loop_start(element(kind), self.known)
        with self.block(f"for {item} in {values}:"):
            self._value(element(kind), item, f"{path}[]")
            self._sync()
        self.known = start

    def _check_list(self, kind: FieldType, values: str, path: str) -> None:
        fixed = kind.kind == "array"
        wrong_length = (
            f" or len({values}) {'!=' if fixed else '>'} {kind.size}" if kind.size else ""
        )
        with self.block(f"if type({values}) is not list{wrong_length}:"):
            self.add(f"{values} = items({path!r}, {values}, {kind.size}, fixed={fixed})")

    # -- structs, parts and positions ------------------------------------------------------------

    def _put(self, code: str, size: int, value: str, alignment: int = 0) -> None:
        """Put a value at the end of the struct.

        If the value's padding is not known, the value begins a new struct.
        """
        padding = self.known.padding(alignment or size)
        if padding is None:
            self._flush_struct()
            self._lead, padding = alignment or size, 0
            self.known = Alignment(self._lead, 0)
        self.pad_struct(padding, code, size)
        self._values.append(value)

    def _flush_struct(self) -> None:
        code, size = self.take_struct()
        if not code:
            return
        values, lead = ", ".join(self._values), self._lead
        self._values, self._lead = [], 0
        packed = self.fresh("b")
        if lead:
            packs = tuple(Struct(f"<{-rest % lead}x{code}").pack for rest in range(lead))
            self._set_position()
            self.add(f"{packed} = {self.constant('PACK', packs)}[p & {lead - 1}]({values})")
            self._base = f"(p + {lead - 1} & -{lead})"
        else:
            self.add(f"{packed} = {self.constant('PACK', Struct(f'<{code}').pack)}({values})")
        self._constant += size
        self._parts.append(packed)

    def _part(self, value: str, length: str, known: Alignment) -> None:
        self._flush_struct()
        self._parts.append(value)
        self._lengths.append(length)
        self.known = known

    def _set_position(self) -> None:
        """Add a line that sets `p` to the position after the parts."""
        terms = [self._base] if self._base else []
        terms += [str(self._constant)] if self._constant or not terms else []
        terms += self._lengths
        if terms != ["p"]:
            self.add(f"p = {' + '.join(terms)}")
        self._base, self._constant, self._lengths = "p", 0, []

    def _sync(self) -> None:
        """Add lines that put all parts into the list and set `p` to the position after them."""
        self._flush_struct()
        self._set_position()
        if self._parts:
            self.add(f"parts += ({', '.join(self._parts)},)")
        self._parts, self._has_list = [], True

    def _return(self) -> None:
        if self._has_list:
            self._flush_struct()
            if self._parts:
                self.add(f"parts += ({', '.join(self._parts)},)")
            self.add("return b''.join(parts)")
            return
        self._flush_struct()
        if len(self._parts) == 1:
            self.lines[-1] = self.lines[-1].replace(f"{self._parts[0]} =", "return", 1)
        else:
            self.add(f"return b''.join(({', '.join(self._parts)}))")


def _converted(kind: FieldType, value: str, path: str) -> str:
    fixed = kind.kind == "array"
    if kind.base == "byte":
        return f"octets({path!r}, {value}, {kind.size}, fixed={fixed})"
    return f"bytes(booleans({path!r}, {value}, {kind.size}, fixed={fixed}))"
