"""Fast encoders and decoders for most message types.

They work for usual messages, and for bytes as zbot sends them. For all others, they call the
careful functions of `codec`, which convert or reject them. Both send the same bytes.
"""

from __future__ import annotations

import math
import struct
from array import array
from dataclasses import is_dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import get_interface, message_spec_of
from zbot.interfaces.array_value import fixed_array
from zbot.interfaces.spec import FLOAT32_MAX
from zbot.wire.cdr.alignment import TypeLayout
from zbot.wire.cdr.values import fixed_bytes
from zbot.wire.messagepack.decoder_source import RunDecoderSource
from zbot.wire.messagepack.encoder_source import RunEncoderSource
from zbot.wire.messagepack.packing import BIG_ENDIAN, bin_header, ext_header, pack
from zbot.wire.messagepack.value_reader import (
    UnusualError,
    array_header,
    read_count,
    read_integer,
    read_numbers,
    read_text,
    read_texts,
    read_time,
)
from zbot.wire.validation import UNUSUAL_ERRORS, octet

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType

_NAMES: dict[str, Any] = {
    "BOOLS": {False: 0xC2, True: 0xC3},
    "FLOAT32_MAX": FLOAT32_MAX,
    "UNUSUAL": (UnusualError, *UNUSUAL_ERRORS),
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


def is_supported(message_class: type[Any]) -> bool:
    """Return whether a class can have a fast encoder and decoder on this machine.

    Dataclasses and types with bounds, with arrays of `bool` or `byte`, or with very many fields
    have none. The same is true for messages with such messages inside.
    """
    is_short = TypeLayout().is_inline(message_spec_of(message_class))
    return not BIG_ENDIAN and is_short and _has_support(message_class)


def encoder(message_class: type[Any], careful: Callable[[Any], bytes]) -> Callable[[Any], bytes]:
    """Return a function that encodes messages of a class that `is_supported` accepts."""
    written = RunEncoderSource(message_spec_of(message_class))
    return _compiled(message_class, written, "encode", careful)


def decoder(message_class: type[Any], careful: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a function that decodes messages of a class that `is_supported` accepts."""
    return _compiled(message_class, RunDecoderSource(message_class), "decode", careful)


def source(message_class: type[Any]) -> str:
    """Return the source of the encoder and the decoder of a class that `is_supported` accepts."""
    encode = RunEncoderSource(message_spec_of(message_class)).text
    return f"{encode}\n\n{RunDecoderSource(message_class).text}"


def _compiled(
    message_class: type[Any],
    written: RunEncoderSource | RunDecoderSource,
    name: str,
    careful: Callable[[Any], Any],
) -> Callable[[Any], Any]:
    names = _NAMES | written.names | {"careful": careful}
    filename = f"<runs of {message_spec_of(message_class).name}>"
    exec(compile(written.text, filename, "exec"), names)  # noqa: S102 - our own text
    function: Callable[[Any], Any] = names[name]
    return function


def _has_support(message_class: type[Any]) -> bool:
    kinds = [field.type for field in message_spec_of(message_class).fields]
    inner = [get_interface(kind.base) for kind in kinds if kind.is_message]
    return (
        not is_dataclass(message_class)
        and all(map(_is_simple, kinds))
        and all(map(_has_support, inner))
    )


def _is_simple(kind: FieldType) -> bool:
    is_bounded = kind.string_bound > 0 or (kind.kind == "sequence" and kind.size > 0)
    return not is_bounded and (kind.kind == "scalar" or kind.base not in {"bool", "byte"})
