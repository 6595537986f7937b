"""Fast encoders and decoders for most message types.

They work for usual messages, and for bytes as zbot sends them. For all others, they call the
careful functions of `zbot.wire.codec`, which convert or reject them. Both send the same bytes.
"""

from __future__ import annotations

import math
import struct
from array import array
from typing import TYPE_CHECKING, Any

from zbot.interfaces.array_value import fixed_array
from zbot.interfaces.spec import FLOAT32_MAX
from zbot.wire.cdr_layout import TypeLayout, spec_named
from zbot.wire.cdr_values import fixed_bytes
from zbot.wire.messagepack import BIG_ENDIAN, bin_header, ext_header, pack
from zbot.wire.run_decoder import RunDecoderSource
from zbot.wire.run_encoder import RunEncoderSource
from zbot.wire.run_values import (
    UnusualError,
    array_header,
    read_count,
    read_integer,
    read_numbers,
    read_text,
    read_texts,
    read_time,
)
from zbot.wire.value_check import Fault, octet

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType, MessageSpec

_NAMES: dict[str, Any] = {
    "BOOLS": {False: 0xC2, True: 0xC3},
    "FLOAT32_MAX": FLOAT32_MAX,
    "UNUSUAL": (
        UnusualError,
        Fault,
        struct.error,
        AttributeError,
        LookupError,
        TypeError,
        ValueError,
        OverflowError,
        MemoryError,
        BufferError,
    ),
    "UnusualError": UnusualError,
    "array": array,
    "array_header": array_header,
    "bin_header": bin_header,
    "ext_header": ext_header,
    "fixed_array": fixed_array,
    "fixed_bytes": fixed_bytes,
    "inf": math.inf,
    "octet": octet,
    "pack": pack,
    "read_count": read_count,
    "read_integer": read_integer,
    "read_numbers": read_numbers,
    "read_text": read_text,
    "read_texts": read_texts,
    "read_time": read_time,
    "uint32": struct.Struct(">I").unpack_from,
}


def is_supported(spec: MessageSpec) -> bool:
    """Return whether a type can have a fast encoder and decoder on this machine.

    Types with bounds, with arrays of `bool` or `byte`, or with very many fields have none.
    """
    return not BIG_ENDIAN and TypeLayout().is_inline(spec) and _has_support(spec)


def encoder(spec: MessageSpec, careful: Callable[[Any], bytes]) -> Callable[[Any], bytes]:
    """Return a function that encodes messages of a type that `is_supported` accepts."""
    return _compiled(spec, RunEncoderSource(spec), "encode", careful)


def decoder(spec: MessageSpec, careful: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a function that decodes messages of a type that `is_supported` accepts."""
    return _compiled(spec, RunDecoderSource(spec), "decode", careful)


def source(spec: MessageSpec) -> str:
    """Return the source of the encoder and the decoder of a type that `is_supported` accepts."""
    return f"{RunEncoderSource(spec).text}\n\n{RunDecoderSource(spec).text}"


def _compiled(
    spec: MessageSpec,
    written: RunEncoderSource | RunDecoderSource,
    name: str,
    careful: Callable[[Any], Any],
) -> Callable[[Any], Any]:
    names = _NAMES | written.names | {"careful": careful}
    exec(compile(written.text, f"<runs of {spec.name}>", "exec"), names)  # noqa: S102 - our own text
    function: Callable[[Any], Any] = names[name]
    return function


def _has_support(spec: MessageSpec) -> bool:
    return all(
        _is_simple(field.type)
        and (not field.type.is_message or _has_support(spec_named(field.type.base)))
        for field in spec.fields
    )


def _is_simple(kind: FieldType) -> bool:
    is_bounded = kind.string_bound > 0 or (kind.kind == "sequence" and kind.size > 0)
    return not is_bounded and (kind.kind == "scalar" or kind.base not in {"bool", "byte"})
