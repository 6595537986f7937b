"""Encoder of CDR that follows the rules field by field, to compare the generated code with."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any

from zbot.interfaces import MessageSpec, spec_of

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType


def reference_cdr(message: Any, order: str = "<") -> bytes:
    """Return a message as CDR. `order` is `<` or `>`, as in `struct`."""
    body = bytearray()
    _write_message(body, message, order)
    return (b"\0\1\0\0" if order == "<" else bytes(4)) + bytes(body)


def _write_message(body: bytearray, message: Any, order: str) -> None:
    spec = spec_of(type(message))
    assert isinstance(spec, MessageSpec)
    if not spec.fields:
        body.append(0)
    for field in spec.fields:
        kind, value = field.type, getattr(message, field.name)
        if kind.kind == "scalar":
            _write_value(body, kind, value, order)
            continue
        if kind.kind == "sequence":
            _write_number(body, "I", len(value), order)
        for item in value:
            _write_value(body, kind, item, order)


def _write_value(body: bytearray, kind: FieldType, value: Any, order: str) -> None:
    if kind.is_message:
        _write_message(body, value, order)
    elif kind.base == "string":
        data = value.encode() + b"\0"
        _write_number(body, "I", len(data), order)
        body += data
    elif kind.base == "wstring":
        units = struct.unpack(f"<{len(value.encode('utf-16-le')) // 2}H", value.encode("utf-16-le"))
        _write_number(body, "I", len(units), order)
        for unit in units:
            _write_number(body, "I", unit, order)
    else:
        code = kind.typecode or {"bool": "?", "byte": "c"}[kind.base]
        _write_number(body, code, value, order)


def _write_number(body: bytearray, code: str, value: Any, order: str) -> None:
    data = struct.pack(order + code, value)
    body += bytes(-len(body) % len(data)) + data
