"""Memory that a message needs in C: capacities of its texts and sequences, and its largest size."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.wire.cdr.alignment import COUNT_SIZE, START, UNIT_SIZE, Alignment
from zbot.wire.embedded.c_literal import type_name
from zbot.wire.messagepack.packing import ITEM_SIZE

if TYPE_CHECKING:
    from zbot.interfaces.spec import Field, FieldType, MessageSpec

_HEADER_SIZE = 4


def items_capacity(owner: str, field: Field) -> str:
    """Return the macro with the number of items for which a sequence has memory."""
    return f"{owner}__{field.name}__CAPACITY"


def text_capacity(owner: str, field: Field) -> str:
    """Return the macro with the number of bytes (units of a wide text) for which there is memory.

    The NUL at the end of a text is not counted.
    """
    return f"{owner}__{field.name}__TEXT_CAPACITY"


def number_size(kind: FieldType) -> int:
    """Return the bytes of one number, bool or byte in CDR."""
    return ITEM_SIZE.get(kind.typecode, 1)


class LargestSize:
    """Expression of C for the largest size of a message in bytes, with the header."""

    def __init__(self, spec: MessageSpec) -> None:
        self._fixed = _HEADER_SIZE
        self._terms: list[str] = []
        self._known = START
        self._owner = type_name(spec.name)
        for field in spec.fields:
            self._field(field)
        if not spec.fields:
            self._fixed += 1
        self.expression = " + ".join([str(self._fixed), *self._terms])

    def _field(self, field: Field) -> None:
        kind = field.type
        count = "1" if kind.kind == "scalar" else str(kind.size)
        if kind.kind == "sequence":
            count = items_capacity(self._owner, field)
            self._number(COUNT_SIZE)
        if kind.typecode or kind.base in {"bool", "byte"}:
            self._numbers(number_size(kind), count)
        else:
            self._terms.append(_product(count, self._item(field)))
            self._known = Alignment()

    def _item(self, field: Field) -> str:
        kind = field.type
        if kind.is_message:
            return f"({type_name(kind.base)}__MAX_SIZE + 3)"
        size = "1" if kind.base == "string" else str(UNIT_SIZE)
        return f"({2 * COUNT_SIZE} + {_product(size, text_capacity(self._owner, field))})"

    def _number(self, size: int) -> None:
        padding = self._known.padding(size)
        self._fixed += size - 1 if padding is None else padding
        self._known = self._known.aligned(size)
        self._fixed += size
        self._known = self._known.after(size)

    def _numbers(self, size: int, count: str) -> None:
        padding = self._known.padding(size)
        self._fixed += size - 1 if padding is None else padding
        if count.isdigit():
            self._fixed += size * int(count)
            self._known = self._known.aligned(size).after(size * int(count))
        else:
            self._terms.append(_product(str(size), count))
            self._known = Alignment(min(size, COUNT_SIZE), 0)


def _product(count: str, size: str) -> str:
    """Return the product of two expressions."""
    return size if count == "1" else f"{count} * {size}"
