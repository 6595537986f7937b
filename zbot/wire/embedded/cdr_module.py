"""CDR for MicroPython. Each generated module begins with the text of this module.

MicroPython has no `typing` and no `struct.error`, and its `struct.pack` accepts any integer.
"""

import struct

_SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "q": 8, "Q": 8, "f": 4, "d": 8}
_HEADER = b"\x00\x01\x00\x00"  # little-endian


class CdrError(ValueError):
    """A message has a wrong value, or bytes are not a message."""


class CdrWriter:
    """Writer of values as CDR. Positions are counted from the end of the header."""

    def __init__(self) -> None:
        self.data = bytearray(_HEADER)

    def _pack(self, code: str, values: list[float]) -> None:
        size = _SIZES[code]
        if values:
            self.data.extend(bytes((4 - len(self.data)) % size))
        if code not in "fd":
            low = -(1 << (8 * size - 1)) if code in "bhiq" else 0
            for value in values:
                if not low <= value < low + (1 << (8 * size)):
                    raise CdrError(f"{value!r} does not fit into {size} bytes")
        self.data.extend(struct.pack(f"<{len(values)}{code}", *values))

    def number(self, code: str, value: float) -> None:
        """Write a number with a type code of `struct`."""
        self._pack(code, [value])

    def numbers(self, code: str, values: list[float], length: int, bound: int) -> None:
        """Write an array of `length` numbers, or a sequence if `length` is negative."""
        self.count(len(values), length, bound)
        self._pack(code, values)

    def octets(self, data: bytes, length: int, bound: int) -> None:
        """Write an array of bytes, or a sequence if `length` is negative."""
        self.count(len(data), length, bound)
        self.data.extend(data)

    def count(self, count: int, length: int, bound: int) -> None:
        """Write the count of a sequence. The count of an array is only checked."""
        if length >= 0:
            if count != length:
                raise CdrError(f"an array has {count} items, but needs {length}")
            return
        if bound and count > bound:
            raise CdrError(f"a sequence has {count} items, but at most {bound} are allowed")
        self._pack("I", [count])

    def text(self, text: str, bound: int) -> None:
        """Write a text of at most `bound` characters. 0 means any number."""
        _check_text(text, bound)
        data = text.encode()
        self._pack("I", [len(data) + 1])
        self.data.extend(data)
        self.data.append(0)

    def wide_text(self, text: str, bound: int) -> None:
        """Write a text as units of UTF-16, with four bytes for each."""
        _check_text(text, bound)
        units: list[float] = []
        for code in map(ord, text):
            if code > 0xFFFF:
                units += [0xD800 + ((code - 0x10000) >> 10), 0xDC00 + (code & 0x3FF)]
            else:
                units.append(code)
        self._pack("I", [len(units)] + units)  # noqa: RUF005 - MicroPython has no other form


class CdrReader:
    """Reader of values in CDR."""

    def __init__(self, data: bytes) -> None:
        if len(data) < len(_HEADER) or data[0] != 0 or data[1] > 1:
            raise CdrError("the bytes do not begin with a CDR header")
        self._data = data
        self._position = len(_HEADER)
        self._order = "<" if data[1] else ">"

    def _next(self, alignment: int, size: int) -> int:
        """Return the position of the next value, and go to its end."""
        begin = self._position + (4 - self._position) % alignment
        if begin + size > len(self._data):
            raise CdrError("the bytes end before the message does")
        self._position = begin + size
        return begin

    def _unpack(self, code: str, count: int) -> tuple[float, ...]:
        if not count:
            return ()
        size = _SIZES[code]
        begin = self._next(size, size * count)
        return struct.unpack_from(f"{self._order}{count}{code}", self._data, begin)

    def number(self, code: str) -> float:
        """Read a number."""
        return self._unpack(code, 1)[0]

    def numbers(self, code: str, length: int, bound: int) -> list[float]:
        """Read an array of `length` numbers, or a sequence if `length` is negative."""
        return list(self._unpack(code, self.count(length, bound)))

    def octets(self, length: int, bound: int) -> bytes:
        """Read an array of bytes, or a sequence if `length` is negative."""
        count = self.count(length, bound)
        begin = self._next(1, count)
        return bytes(self._data[begin : begin + count])

    def count(self, length: int, bound: int) -> int:
        """Read the count of a sequence. Return `length` for an array."""
        if length >= 0:
            return length
        count = int(self.number("I"))
        if bound and count > bound:
            raise CdrError(f"a sequence has {count} items, but at most {bound} are allowed")
        return count

    def text(self, bound: int) -> str:
        """Read a text."""
        size = int(self.number("I"))
        begin = self._next(1, size)
        data = bytes(self._data[begin : begin + size])
        if data and data[-1] == 0:
            data = data[:-1]
        try:
            text = data.decode()
        except UnicodeError:
            raise CdrError("a text is not valid UTF-8")  # noqa: B904 - MicroPython has no `from`
        _check_text(text, bound)
        return text

    def wide_text(self, bound: int) -> str:
        """Read a text of UTF-16 units."""
        characters: list[str] = []
        high = 0
        for unit in map(int, self._unpack("I", int(self.number("I")))):
            if 0xD800 <= unit < 0xDC00:
                high = unit
            elif 0xDC00 <= unit < 0xE000 and high:
                characters.append(chr(0x10000 + ((high - 0xD800) << 10) + unit - 0xDC00))
                high = 0
            elif unit > 0xFFFF or high:
                raise CdrError("a wide text is not valid UTF-16")
            else:
                characters.append(chr(unit))
        text = "".join(characters)
        _check_text(text, bound)
        return text


def _check_text(text: str, bound: int) -> None:
    if bound and len(text) > bound:
        raise CdrError(f"a text has {len(text)} characters, but at most {bound} are allowed")
