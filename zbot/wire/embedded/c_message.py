"""C source of one message type: its struct, and the functions that write and read it."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

from zbot.interfaces import type_hash
from zbot.wire.embedded.c_capacity import LargestSize, items_capacity, number_size, text_capacity
from zbot.wire.embedded.c_literal import NUMBER_TYPES, literal, member_name, type_name, wide_units
from zbot.wire.messagepack.packing import ITEM_SIZE
from zbot.wire.rmw_zenoh import dds_type

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.interfaces.spec import Field, FieldType, MessageSpec, Scalar

#: Ends of the names that this module defines for each type. A constant with such a name gets a `_`.
_OWN_ENDS = frozenset(
    {"TYPE_NAME", "DDS_NAME", "TYPE_HASH", "PICO_ROS_TYPE", "PICO_ROS_HASH", "MAX_SIZE"}
)
_EMPTY = "structure_needs_at_least_one_member"  # as in ROS 2's own C headers
_SIGNATURES = {
    "init": "{name} *message",
    "put": "zbot_cdr_writer *cdr, const {name} *message",
    "get": "zbot_cdr_reader *cdr, {name} *message",
}


def type_macros(name: str) -> list[str]:
    """Return the lines that define the names and the hash of an interface."""
    own = type_name(name)
    dds_name, text_of_hash = dds_type(name), type_hash(name)
    texts = {
        "TYPE_NAME": name,
        "DDS_NAME": dds_name,
        "TYPE_HASH": text_of_hash,
        # The library Pico-ROS adds the `_` at the end and `RIHS01_` itself.
        "PICO_ROS_TYPE": dds_name.removesuffix("_"),
        "PICO_ROS_HASH": text_of_hash.removeprefix("RIHS01_"),
    }
    return [f'#define {own}__{end} "{text}"' for end, text in texts.items()]


class CMessage:
    """Lines of C for a message. The types inside it must come before it.

    Args:
        spec: The definition of the message.
        with_defaults: Names of the types inside it that have default values at any depth.
    """

    def __init__(self, spec: MessageSpec, with_defaults: frozenset[str]) -> None:
        self.lines: list[str] = []
        self.has_defaults = False
        self._spec = spec
        self._name = type_name(spec.name)
        self._with_defaults = with_defaults
        self._indentation = 0
        self._add(f"#ifndef {self._name}__TYPE_NAME", *type_macros(spec.name))
        self._constants()
        self._capacities()
        self._add(f"#define {self._name}__MAX_SIZE ({LargestSize(spec).expression})", "")
        self._struct()
        self._init()
        self._put()
        self._get()
        self._write_and_read()
        self._add(f"#endif /* {self._name} */", "")

    def _add(self, *lines: str) -> None:
        self.lines += [("    " * self._indentation + line).rstrip() for line in lines]

    @contextmanager
    def _block(self, header: str) -> Iterator[None]:
        self._add(f"{header} {{" if header else "{")
        self._indentation += 1
        yield
        self._indentation -= 1
        self._add("}")

    @contextmanager
    def _function(self, verb: str) -> Iterator[None]:
        signature = _SIGNATURES[verb].format(name=self._name)
        self._add(f"static inline void {self._name}__{verb}({signature})")
        with self._block(""):
            yield
        self._add("")

    # -- macros and struct -----------------------------------------------------------------------

    def _constants(self) -> None:
        for constant in self._spec.constants:
            value = literal(constant.type, constant.value)
            if constant.type.base in NUMBER_TYPES:
                value = f"(({NUMBER_TYPES[constant.type.base]}){value})"
            end = f"{constant.name}_" if constant.name in _OWN_ENDS else constant.name
            self._add(f"#define {self._name}__{end} {value}")

    def _capacities(self) -> None:
        for field in self._spec.fields:
            kind = field.type
            if kind.kind == "sequence":
                self._capacity(items_capacity(self._name, field), kind.size, "ZBOT_CDR_CAPACITY")
            if kind.is_string:
                macro, default = text_capacity(self._name, field), "ZBOT_CDR_TEXT_CAPACITY"
                self._capacity(macro, kind.string_bound, default)

    def _capacity(self, macro: str, bound: int, default: str) -> None:
        self._add(f"#ifndef {macro}", f"#define {macro} {bound or default}", "#endif")
        if bound:
            self._add(f"#if {macro} > {bound}")
            self._add(f"#error {macro} is greater than the bound of the type", "#endif")

    def _struct(self) -> None:
        with self._block("typedef struct"):
            for field in self._spec.fields:
                self._member(field)
            if not self._spec.fields:
                self._add(f"uint8_t {_EMPTY};")
        self.lines[-1] = f"}} {self._name};"
        self._add("")

    def _member(self, field: Field) -> None:
        name, kind = member_name(field.name), field.type
        if kind.kind == "sequence":
            with self._block("struct"):
                self._add("uint32_t size;")
                self._declare(field, f"data[{items_capacity(self._name, field)}]")
            self.lines[-1] += f" {name};"
        else:
            self._declare(field, f"{name}[{kind.size}]" if kind.kind == "array" else name)

    def _declare(self, field: Field, variable: str) -> None:
        base, capacity = field.type.base, text_capacity(self._name, field)
        if base == "string":
            self._add(f"char {variable}[{capacity} + 1];")
        elif base == "wstring":
            self._add(f"struct {{ uint32_t size; uint16_t data[{capacity}]; }} {variable};")
        else:
            self._add(f"{NUMBER_TYPES.get(base) or type_name(base)} {variable};")

    # -- default values --------------------------------------------------------------------------

    def _init(self) -> None:
        self._add("/* Sets all fields to their default values. */")
        with self._function("init"):
            self._add("memset(message, 0, sizeof *message);")
            for field in self._spec.fields:
                if field.default is not None:
                    self._default(field)
                elif field.type.base in self._with_defaults and field.type.kind != "sequence":
                    self._each(field, self._init_one)
                    self.has_defaults = True

    @staticmethod
    def _init_one(field: Field, item: str) -> str:
        return f"{type_name(field.type.base)}__init(&{item});"

    def _default(self, field: Field) -> None:
        value, variable = field.default, f"message->{member_name(field.name)}"
        self.has_defaults = True
        if not isinstance(value, tuple):
            self._set(field, variable, value)
            return
        if field.type.kind == "sequence":
            capacity = items_capacity(self._name, field)
            self._add(f"#if {capacity} >= {len(value)}", f"{variable}.size = {len(value)};")
            variable = f"{variable}.data"
        for number, item in enumerate(value):
            self._set(field, f"{variable}[{number}]", item)
        if field.type.kind == "sequence":
            self._add("#endif")

    def _set(self, field: Field, variable: str, value: Scalar | None) -> None:
        capacity = text_capacity(self._name, field)
        if not isinstance(value, str):
            if value is not None:
                self._add(f"{variable} = {literal(field.type, value)};")
        elif field.type.base == "string":
            length = len(value.encode())
            self._add(f"#if {capacity} >= {length}")
            self._add(f"memcpy({variable}, {literal(field.type, value)}, {length + 1});", "#endif")
        else:
            units = wide_units(value)
            self._add(f"#if {capacity} >= {len(units)}", f"{variable}.size = {len(units)};")
            self._add(*(f"{variable}.data[{at}] = {unit};" for at, unit in enumerate(units)))
            self._add("#endif")

    # -- functions -------------------------------------------------------------------------------

    def _put(self) -> None:
        with self._function("put"):
            for field in self._spec.fields:
                if field.type.kind == "sequence":
                    self._put_sequence(field)
                else:
                    self._each(field, self._put_one)
            if not self._spec.fields:
                self._add(f"zbot_cdr_put(cdr, message->{_EMPTY}, 1);")

    def _put_sequence(self, field: Field) -> None:
        variable = f"message->{member_name(field.name)}"
        limits = f"{variable}.size, {items_capacity(self._name, field)}"
        count = f"zbot_cdr_put_count(cdr, {limits})"
        if _is_octets(field.type):
            self._add(f"zbot_cdr_put_bytes(cdr, {variable}.data, {count});")
            return
        with self._block(f"for (uint32_t i = 0, count = {count}; i < count; i++)"):
            self._add(self._put_one(field, f"{variable}.data[i]"))

    def _put_one(self, field: Field, item: str) -> str:
        base, capacity = field.type.base, text_capacity(self._name, field)
        if field.type.is_message:
            return f"{type_name(base)}__put(cdr, &{item});"
        if base == "string":
            return f"zbot_cdr_put_text(cdr, {item}, {capacity});"
        if base == "wstring":
            return f"zbot_cdr_put_wide_text(cdr, {item}.data, {item}.size, {capacity});"
        if base in {"float32", "float64"}:
            return f"zbot_cdr_put_{NUMBER_TYPES[base]}(cdr, {item});"
        return f"zbot_cdr_put(cdr, (uint64_t){item}, {number_size(field.type)});"

    def _get(self) -> None:
        with self._function("get"):
            for field in self._spec.fields:
                if field.type.kind == "sequence":
                    self._get_sequence(field)
                else:
                    self._each(field, self._get_one)
            if not self._spec.fields:
                self._add(f"message->{_EMPTY} = (uint8_t)zbot_cdr_get(cdr, 1);")

    def _get_sequence(self, field: Field) -> None:
        variable, capacity = (
            f"message->{member_name(field.name)}",
            items_capacity(self._name, field),
        )
        self._add(f"{variable}.size = zbot_cdr_get_count(cdr, {capacity});")
        if _is_octets(field.type):
            self._add(f"zbot_cdr_get_bytes(cdr, {variable}.data, {variable}.size);")
            return
        with self._block(f"for (uint32_t i = 0; i < {variable}.size; i++)"):
            self._add(self._get_one(field, f"{variable}.data[i]"))

    def _get_one(self, field: Field, item: str) -> str:
        base, capacity = field.type.base, text_capacity(self._name, field)
        if field.type.is_message:
            return f"{type_name(base)}__get(cdr, &{item});"
        if base == "string":
            return f"zbot_cdr_get_text(cdr, {item}, {capacity});"
        if base == "wstring":
            return f"{item}.size = zbot_cdr_get_wide_text(cdr, {item}.data, {capacity});"
        if base in {"float32", "float64"}:
            return f"{item} = zbot_cdr_get_{NUMBER_TYPES[base]}(cdr);"
        if base == "bool":
            return f"{item} = zbot_cdr_get(cdr, 1) != 0;"
        return f"{item} = ({NUMBER_TYPES[base]})zbot_cdr_get(cdr, {number_size(field.type)});"

    def _each(self, field: Field, statement: Callable[[Field, str], str]) -> None:
        """Add a statement for a field, or a loop of it for each item of an array."""
        variable = f"message->{member_name(field.name)}"
        if field.type.kind == "scalar":
            self._add(statement(field, variable))
            return
        with self._block(f"for (uint32_t i = 0; i < {field.type.size}; i++)"):
            self._add(statement(field, f"{variable}[i]"))

    def _write_and_read(self) -> None:
        name = self._name
        self._add(
            "/* Writes a message into size bytes at data. Sets *length to the bytes used. */",
            f"static inline zbot_cdr_status {name}__write(",
            f"    const {name} *message, uint8_t *data, size_t size, size_t *length)",
            "{",
            "    zbot_cdr_writer cdr = zbot_cdr_begin_write(data, size);",
            f"    {name}__put(&cdr, message);",
            "    return zbot_cdr_end_write(&cdr, length);",
            "}",
            "",
            "/* Reads a message. After an error, some of its fields are not valid. */",
            f"static inline zbot_cdr_status {name}__read(",
            f"    {name} *message, const uint8_t *data, size_t length)",
            "{",
            "    zbot_cdr_reader cdr = zbot_cdr_begin_read(data, length);",
            f"    {name}__get(&cdr, message);",
            "    return cdr.status;",
            "}",
            "",
        )


def _is_octets(kind: FieldType) -> bool:
    """Return whether the items of a sequence are bytes, which are copied together."""
    return ITEM_SIZE.get(kind.typecode) == 1 or kind.base == "byte"
