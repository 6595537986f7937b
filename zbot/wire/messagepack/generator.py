"""Generator of Python source for the codec functions of a message type.

A type has `encode(message)` and `decode(data)`. A type inside another type also has
`to_map(message)` and `from_map(values)`. In the source of the outer type, these two functions have
the names `pack_<type>` and `unpack_<type>`. The source tests each value inline. If a test fails,
`zbot.wire.validation` converts or rejects the value. `codec_for(T).source` is the source for T.
"""

from __future__ import annotations

from itertools import groupby
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from zbot.interfaces.spec import INTEGER_RANGES, Field, FieldType, MessageSpec
from zbot.wire.messagepack.default_memory import has_large_elements, large_element
from zbot.wire.messagepack.packing import BIG_ENDIAN, ITEM_SIZE, map_header

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

#: lines of a generated function, without indentation
Lines = list[str]

_ZERO: dict[str, object] = {"bool": False, "byte": b"\0", "float32": 0.0, "float64": 0.0}
_ZERO |= dict.fromkeys(INTEGER_RANGES, 0) | dict.fromkeys(("string", "wstring"), "")


class Layout(NamedTuple):
    """How a class stores its fields."""

    prefix: str = "_"  #: prefix of a field's name in the attribute that stores it
    keywords: bool = False  #: whether decoding calls the constructor, as for dataclasses
    #: for a field, the name of the array method that makes the stored value, e.g. `tolist`
    conversions: Mapping[str, str] = MappingProxyType({})


def encode_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `encode(message)`, which returns a message's bytes."""
    has_arrays = any(map(is_numeric_array, spec.fields))
    packed = _joined_parts(spec.fields) if has_arrays else [f"return pack({_map(spec.fields)})"]
    body = _guarded([*_pack_lines(spec, layout), *packed], "explain(message, error)")
    return _function("encode(message)", body)


def decode_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `decode(data)`, which decodes bytes and returns the message."""
    unpacked = "values = unpack(data)"
    if any(map(is_numeric_array, spec.fields)):
        unpacked += " if len(data) < LARGE else unpack_large(data, ARRAYS)"
    begin = ["begin_message(len(data))"] if has_large_elements(spec) else []
    body = _guarded([*begin, unpacked, *_unpack_lines(spec, layout)], "explain(error)")
    return _function("decode(data)", body)


def to_map_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `to_map(message)`, which returns the map for MessagePack."""
    return _function("to_map(message)", [*_pack_lines(spec, layout), f"return {_map(spec.fields)}"])


def from_map_source(spec: MessageSpec, layout: Layout) -> str:
    """Return the source of `from_map(values)`, which returns a message made from a map."""
    return _function("from_map(values)", _unpack_lines(spec, layout))


def is_numeric_array(field: Field) -> bool:
    """Return whether a field is an array of numbers, which is sent as a binary or an extension."""
    return field.type.kind != "scalar" and bool(field.type.typecode)


def function_name(verb: str, type_name: str) -> str:
    """Return the name of a nested type's function in generated code."""
    return f"{verb}_{type_name.replace('/', '_')}"


def _function(signature: str, body: Iterable[str]) -> str:
    return "\n".join([f"def {signature}:", *_indent(body)]) + "\n"


def _indent(lines: Iterable[str]) -> Lines:
    return [f"    {line}" for line in lines]


def _guarded(body: Iterable[str], explain: str) -> Lines:
    return ["try:", *_indent(body), "except ERRORS as error:", f"    {explain}"]


def _pack_lines(spec: MessageSpec, layout: Layout) -> Lines:
    lines: Lines = []
    for field in spec.fields:
        lines.append(f"{field.name}_ = message.{layout.prefix}{field.name}")
        lines += _to_map_field(field)
    return lines


def _unpack_lines(spec: MessageSpec, layout: Layout) -> Lines:
    lines = ["if type(values) is not dict:", "    raise wrong('', 'a map', values)"]
    for field in spec.fields:
        lines += _from_map_field(field)
        if is_numeric_array(field) and field.name in layout.conversions:
            lines.append(f"{field.name}_ = {field.name}_.{layout.conversions[field.name]}()")
    names = [field.name for field in spec.fields]
    if layout.keywords:
        return [*lines, f"return CLASS({', '.join(f'{name}={name}_' for name in names)})"]
    lines.append("message = new(CLASS)")
    lines += [f"message.{layout.prefix}{name} = {name}_" for name in names]
    return [*lines, "return message"]


def _to_map_field(field: Field) -> Lines:
    """Return lines that convert the field's variable from its Python value to its map value."""
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


def _from_map_field(field: Field) -> Lines:
    """Return lines that convert the field's received value to its Python value."""
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
        octets = large_element(field)
        if octets:
            lines.append(f"count_elements({field.name!r}, {variable}, {octets})")
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
    """Return lines that test the field's variable, and convert or reject a value that fails."""
    kind, variable = field.type, f"{field.name}_"
    if kind.is_message and kind.kind == "scalar":
        return []
    bad, call = _test(kind, variable)
    convert = f"{variable} = {call}({_arguments(field)})"
    return [f"if {bad}:", f"    {convert}"] if bad else [convert]


def _test(kind: FieldType, variable: str) -> tuple[str, str]:
    """Return the condition under which a value needs a check function, and that function's name."""
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
    """Return the expression for the value of a field that the sender left out."""
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


def _joined_parts(fields: Sequence[Field]) -> Lines:
    """Return lines that join the parts of the message's bytes. Each numeric array is one part.

    So a large array is copied only once, into the joined bytes.
    """
    parts = [repr(map_header(len(fields)))]
    for numeric, group in groupby(fields, key=is_numeric_array):
        members = list(group)
        parts += _array_parts(members) if numeric else [_entries_without_header(members)]
    return ["return b''.join((", *_indent(f"{part}," for part in parts), "))"]


def _entries_without_header(fields: Sequence[Field]) -> str:
    """Return the expression for the entries of a map without the map's header."""
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
