"""Python source of a message type's pack and unpack functions.

A type gets `encode(message)` and `decode(data)`. One that stands in another type gets
`to_map(message)` and `from_map(values)`, which the other calls `pack_<type>` and `unpack_<type>`. A
value that is plainly right is tested inline; any other goes to `zbot.wire.check`. Print
`codec_for(T).source` to read what a type gets.
"""

from __future__ import annotations

from itertools import groupby
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from zbot.interfaces.spec import INTEGER_RANGES, Field, FieldType, MessageSpec
from zbot.wire.messagepack import BIG_ENDIAN, ITEM_SIZE, map_header

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

#: a generated function's lines, without indentation
Lines = list[str]

_ZERO: dict[str, object] = {"bool": False, "byte": b"\0", "float32": 0.0, "float64": 0.0}
_ZERO |= dict.fromkeys(INTEGER_RANGES, 0) | dict.fromkeys(("string", "wstring"), "")


class Layout(NamedTuple):
    """How a class holds its fields."""

    prefix: str = "_"  #: what stands before a field's name in the attribute that holds it
    keywords: bool = False  #: whether instances are made by the constructor, as dataclasses are
    #: by field, the method that turns an array into what the class holds instead
    conversions: Mapping[str, str] = MappingProxyType({})


def encode_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `encode(message)`: a message's bytes."""
    has_arrays = any(map(is_numeric_array, spec.fields))
    packed = _joined(spec.fields) if has_arrays else [f"return pack({_map(spec.fields)})"]
    body = _guarded([*_reads(spec, layout), *packed], "explain(message, error)")
    return _function("encode(message)", body)


def decode_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `decode(data)`: the message that bytes stand for."""
    unpacked = "values = unpack(data)"
    if any(map(is_numeric_array, spec.fields)):
        unpacked += " if len(data) < LARGE else unpack_large(data, ARRAYS)"
    body = _guarded([unpacked, *_writes(spec, layout)], "explain(error)")
    return _function("decode(data)", body)


def to_map_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `to_map(message)`: the map that MessagePack is to write."""
    return _function("to_map(message)", [*_reads(spec, layout), f"return {_map(spec.fields)}"])


def from_map_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `from_map(values)`: a message of what arrived."""
    return _function("from_map(values)", _writes(spec, layout))


def is_numeric_array(field: Field) -> bool:
    """Tell whether the field is an array of numbers, which is one binary or extension."""
    return field.type.kind != "scalar" and bool(field.type.typecode)


def function_name(verb: str, type_name: str) -> str:
    """Return the name under which generated code calls a nested type's function."""
    return f"{verb}_{type_name.replace('/', '_')}"


def _function(signature: str, body: Iterable[str]) -> str:
    return "\n".join([f"def {signature}:", *_indent(body)]) + "\n"


def _indent(lines: Iterable[str]) -> Lines:
    return [f"    {line}" for line in lines]


def _guarded(body: Iterable[str], explain: str) -> Lines:
    return ["try:", *_indent(body), "except ERRORS as error:", f"    {explain}"]


def _reads(spec: MessageSpec, layout: Layout) -> Lines:
    lines: Lines = []
    for field in spec.fields:
        lines.append(f"{field.name}_ = message.{layout.prefix}{field.name}")
        lines += _read(field)
    return lines


def _writes(spec: MessageSpec, layout: Layout) -> Lines:
    lines = ["if type(values) is not dict:", "    raise wrong('', 'a map', values)"]
    for field in spec.fields:
        lines += _write(field)
        if is_numeric_array(field) and field.name in layout.conversions:
            lines.append(f"{field.name}_ = {field.name}_.{layout.conversions[field.name]}()")
    names = [field.name for field in spec.fields]
    if layout.keywords:
        return [*lines, f"return CLASS({', '.join(f'{name}={name}_' for name in names)})"]
    lines.append("message = new(CLASS)")
    lines += [f"message.{layout.prefix}{name} = {name}_" for name in names]
    return [*lines, "return message"]


def _read(field: Field) -> Lines:
    """Lines that turn the field's variable from its Python value to what goes into the map."""
    kind, variable = field.type, f"{field.name}_"
    if kind.base == "byte":
        call = "octet" if kind.kind == "scalar" else "octets"
        return [f"{variable} = {call}({_arguments(field)})"]
    lines = _checked(field)
    if is_numeric_array(field) and BIG_ENDIAN:
        return [lines[1].strip()]  # the check also swaps the bytes
    if kind.is_message:
        pack, error = function_name("pack", kind.base), "(Fault, AttributeError) as error"
        lines += _nested(field, pack, error, f"message_fault({_quoted(field)}, {variable}, error)")
    return lines


def _write(field: Field) -> Lines:
    """Lines that turn what arrived into the field's Python value."""
    kind, variable = field.type, f"{field.name}_"
    get = f"{variable} = values.get({field.name!r}"
    if is_numeric_array(field):
        lines = [
            f"{get}, MISSING)",
            f"if {variable} is MISSING:",
            f"    {variable} = {_default(field)}",
        ]
        bad, call = _checked(field)
        lines += [f"el{bad}", call.replace("numbers(", "numbers_from(")]
        if kind.kind == "array":
            lines.append(f"{variable} = fixed_array({kind.typecode!r}, {variable})")
        return lines
    lines = [f"{get}, {_default(field)})"]
    if kind.base == "byte":
        call = "octet_from" if kind.kind == "scalar" else "octets_from"
        return [*lines, f"{variable} = {call}({_arguments(field)})"]
    if kind.is_message:
        unpack = function_name("unpack", kind.base)
        lines += [] if kind.kind == "scalar" else _checked(field)
        return lines + _nested(field, unpack, "Fault as fault", f"fault.inside({field.name!r})")
    return lines + _checked(field)


def _nested(field: Field, convert: str, error: str, fault: str) -> Lines:
    variable = f"{field.name}_"
    if field.type.kind == "scalar":
        value = f"{convert}({variable})"
    else:
        value = f"[{convert}(item) for item in {variable}]"
        fault = f"items_fault({_quoted(field)}, {variable}, {convert})"
    return [
        "try:",
        f"    {variable} = {value}",
        f"except {error}:",
        f"    raise {fault} from None",
    ]


def _quoted(field: Field) -> str:
    return f"{field.name!r}, {field.type.base!r}"


def _checked(field: Field) -> Lines:
    """Lines that test the field's variable, and convert or refuse it where the test fails."""
    kind, variable = field.type, f"{field.name}_"
    if kind.is_message and kind.kind == "scalar":
        return []
    bad, call = _test(kind, variable)
    convert = f"{variable} = {call}({_arguments(field)})"
    return [f"if {bad}:", f"    {convert}"] if bad else [convert]


def _test(kind: FieldType, variable: str) -> tuple[str, str]:
    """The condition under which a value needs a closer look, and the function that takes it."""
    if kind.kind != "scalar":
        return _array_test(kind, variable)
    if kind.base in INTEGER_RANGES:
        low, high = INTEGER_RANGES[kind.base]
        return f"type({variable}) is not int or not {low} <= {variable} <= {high}", "integer"
    if kind.base == "float32":
        in_range = f"-FLOAT32_MAX <= {variable} <= FLOAT32_MAX"
        return f"type({variable}) is not float or not {in_range}", "real32"
    if kind.base == "float64":
        return f"type({variable}) is not float", "real"
    if kind.base == "bool":
        return f"{variable} is not True and {variable} is not False", "boolean"
    too_long = f" or len({variable}) > {kind.string_bound}" if kind.string_bound else ""
    return f"type({variable}) is not str{too_long}", "text"


def _array_test(kind: FieldType, variable: str) -> tuple[str, str]:
    compare = "!=" if kind.kind == "array" else ">"
    length = f" or len({variable}) {compare} {kind.size}" if kind.size else ""
    if kind.typecode:
        wrong = f"type({variable}) is not array or {variable}.typecode != {kind.typecode!r}"
        return wrong + length, "numbers"
    if kind.is_message:
        return f"type({variable}) is not list{length}", "items"
    return "", "booleans" if kind.base == "bool" else "texts"


def _arguments(field: Field) -> str:
    kind = field.type
    arguments = [repr(field.name), f"{field.name}_"]
    if kind.kind != "scalar":
        arguments += [repr(kind.typecode)] if kind.typecode else []
        arguments += [str(kind.size), f"fixed={kind.kind == 'array'}"]
        arguments += [f"bound={kind.string_bound}"] if kind.is_string else []
    elif kind.base in INTEGER_RANGES:
        arguments += map(str, INTEGER_RANGES[kind.base])
    elif kind.is_string:
        arguments.append(str(kind.string_bound))
    return ", ".join(arguments)


def _default(field: Field) -> str:
    """The expression of what a field holds that the sender left out."""
    kind = field.type
    if kind.is_message:
        return {"scalar": "EMPTY", "sequence": "[]", "array": f"[EMPTY] * {kind.size}"}[kind.kind]
    if kind.kind == "scalar":
        return repr(_ZERO[kind.base] if field.default is None else field.default)
    values = list(field.default) if isinstance(field.default, tuple) else []
    if values or kind.kind == "sequence":
        return f"array({kind.typecode!r}, {values})" if kind.typecode else repr(values)
    if kind.typecode:
        return f"array({kind.typecode!r}, bytes({kind.size * ITEM_SIZE[kind.typecode]}))"
    return f"[{_ZERO[kind.base]!r}] * {kind.size}"


def _map(fields: Sequence[Field]) -> str:
    entries = (f"{field.name!r}: {_wire_value(field)}" for field in fields)
    return f"{{{', '.join(entries)}}}"


def _wire_value(field: Field) -> str:
    variable = f"{field.name}_"
    if not is_numeric_array(field):
        return variable
    if field.type.typecode == "B":
        return f"memoryview({variable})"
    return f"extension({ord(field.type.typecode)}, {variable})"


def _joined(fields: Sequence[Field]) -> Lines:
    """The bytes in pieces, numeric arrays as they are.

    So a large array is copied once, into the joined bytes, and not first into a map's value.
    """
    parts = [repr(map_header(len(fields)))]
    for numeric, group in groupby(fields, key=is_numeric_array):
        members = list(group)
        parts += _array_parts(members) if numeric else [_headless(members)]
    return ["return b''.join((", *_indent(f"{part}," for part in parts), "))"]


def _headless(fields: Sequence[Field]) -> str:
    """The entries of a map without its header, which the parts before them have."""
    return f"pack({_map(fields)})[{len(map_header(len(fields)))}:]"


def _array_parts(fields: Sequence[Field]) -> Lines:
    parts: Lines = []
    for field in fields:
        typecode, variable = field.type.typecode, f"{field.name}_"
        parts.append(f"KEY_{field.name}")
        if typecode == "B":
            parts.append(f"bin_header(len({variable}))")
        else:
            size = f"{ITEM_SIZE[typecode]} * len({variable})"
            parts.append(f"ext_header({ord(typecode)}, {size})")
        parts.append(variable)
    return parts
