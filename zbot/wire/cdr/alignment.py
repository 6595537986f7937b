"""Alignment and sizes of values in CDR, as far as the message type determines them.

The position of a number is a multiple of the number's size. Positions are counted from the end of
the header. After a text, the position differs between messages.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from zbot.wire.function_source import spec_named
from zbot.wire.messagepack.packing import ITEM_SIZE

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType, MessageSpec

#: bytes that Fast CDR writes for one wide character
UNIT_SIZE = 4
COUNT_SIZE = 4


class Alignment(NamedTuple):
    """What is known about a position: `position % modulus == rest`. `modulus` is 1, 2, 4 or 8."""

    modulus: int = 1
    rest: int = 0

    def padding(self, size: int) -> int | None:
        """Return the padding before a number of `size` bytes. Return None if it is not known."""
        return -self.rest % size if self.modulus >= size else None

    def after(self, size: int) -> Alignment:
        """Return what is known `size` bytes later."""
        return Alignment(self.modulus, (self.rest + size) % self.modulus)

    def after_items(self, size: int) -> Alignment:
        """Return what is known after any number of items of `size` bytes."""
        modulus = min(self.modulus, size)
        return Alignment(modulus, self.rest % modulus)

    def aligned(self, size: int) -> Alignment:
        """Return what is known after the padding for a number of `size` bytes."""
        padding = self.padding(size)
        return Alignment(size, 0) if padding is None else self.after(padding)

    def common(self, other: Alignment) -> Alignment:
        """Return what is known about a position that has one of two alignments."""
        modulus = min(self.modulus, other.modulus)
        while (self.rest - other.rest) % modulus:
            modulus //= 2
        return Alignment(modulus, self.rest % modulus)


#: Alignment at the beginning of a message
START = Alignment(8, 0)


class TypeLayout:
    """Alignment and sizes of the types inside one message type."""

    def __init__(self) -> None:
        self._ends: dict[tuple[str, Alignment], Alignment] = {}
        self._sizes: dict[str, int] = {}

    def least_size(self, kind: FieldType) -> int:
        """Return the smallest number of bytes of one value of a field's base type."""
        if kind.is_message:
            return self._least_size(spec_named(kind.base))
        return ITEM_SIZE.get(kind.typecode, COUNT_SIZE if kind.is_string else 1)

    def loop_start(self, kind: FieldType, known: Alignment) -> Alignment:
        """Return the alignment that is true before each item of a field and after the last item.

        `known` is the alignment before the first item.
        """
        while True:
            common = known.common(self._after_value(kind, known))
            if common == known:
                return known
            known = common

    def _after_message(self, spec: MessageSpec, known: Alignment) -> Alignment:
        key = spec.name, known
        if key not in self._ends:
            end = known
            for field in spec.fields:
                end = self._after_field(field.type, end)
            self._ends[key] = end if spec.fields else known.after(1)
        return self._ends[key]

    def _after_field(self, kind: FieldType, known: Alignment) -> Alignment:
        if kind.kind == "scalar":
            return self._after_value(kind, known)
        if kind.kind == "sequence":
            known = known.aligned(COUNT_SIZE).after(COUNT_SIZE)
        if not kind.typecode:
            return self.loop_start(kind, known)
        size = ITEM_SIZE[kind.typecode]
        if kind.kind == "array":
            return known.aligned(size).after(size * kind.size)
        return known.common(known.aligned(size)).after_items(size)

    def _after_value(self, kind: FieldType, known: Alignment) -> Alignment:
        if kind.is_message:
            return self._after_message(spec_named(kind.base), known)
        if kind.base == "string":
            return Alignment()
        if kind.base == "wstring":
            return Alignment(UNIT_SIZE, 0)
        size = ITEM_SIZE.get(kind.typecode, 1)
        return known.aligned(size).after(size)

    def _least_size(self, spec: MessageSpec) -> int:
        """Return the smallest number of bytes of a message."""
        if spec.name not in self._sizes:
            size = 0
            for kind in (field.type for field in spec.fields):
                count = {"scalar": 1, "array": kind.size, "sequence": 0}[kind.kind]
                size += count * self.least_size(kind)
                size += COUNT_SIZE if kind.kind == "sequence" else 0
            self._sizes[spec.name] = max(size, 1)
        return self._sizes[spec.name]
