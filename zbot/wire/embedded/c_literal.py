"""Names and literals of C."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.interfaces.spec import INTEGER_RANGES

if TYPE_CHECKING:
    from zbot.interfaces.spec import FieldType, Scalar

#: C's name for each type of a number
NUMBER_TYPES: dict[str, str] = {
    "bool": "bool",
    "byte": "uint8_t",
    "char": "uint8_t",
    **{name: f"{name}_t" for name in INTEGER_RANGES if name != "char"},
    "float32": "float",
    "float64": "double",
}
# Words of C and C++ that are also possible names of fields.
_WORDS = frozenset(
    """
    alignas alignof and asm auto bitand bitor bool break case catch char class compl concept
    const constexpr continue default delete do double else enum explicit export extern false
    float for friend goto if inline int long mutable namespace new noexcept not nullptr
    operator or private protected public register requires restrict return short signed sizeof
    static struct switch template this throw true try typedef typeid typename union unsigned
    using virtual void volatile while xor
    """.split()  # noqa: SIM905 - a list of a hundred words is easier to read in lines
)


def type_name(name: str) -> str:
    """Return the name of a type in C: `std_msgs__msg__String`, as in ROS 2's own C headers."""
    return name.replace("/", "__")


def member_name(name: str) -> str:
    """Return the name of a field in C. A word of C or C++ gets a `_` at its end."""
    return f"{name}_" if name in _WORDS else name


def literal(kind: FieldType, value: Scalar) -> str:
    """Return the value of a constant or of a default in C.

    Args:
        kind: The field's type. Only its base is used.
        value: The value of one element.
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, str):
        return _text(value)
    if kind.base in {"float32", "float64"}:
        return _number(float(value), "f" if kind.base == "float32" else "")
    return _integer(kind.base, int(value))


def _integer(base: str, value: int) -> str:
    size = base.removeprefix("u").removeprefix("int")
    if size not in {"32", "64"}:
        return str(value)
    wrap = f"{'UINT' if base.startswith('u') else 'INT'}{size}_C"
    # The smallest number has no literal of its own, because its absolute value is too large.
    return f"(-{wrap}({-value - 1}) - 1)" if value < 0 else f"{wrap}({value})"


def _number(value: float, suffix: str) -> str:
    if math.isnan(value):
        return "(float)NAN" if suffix else "NAN"
    if math.isinf(value):
        infinity = "HUGE_VALF" if suffix else "HUGE_VAL"
        return infinity if value > 0 else f"-{infinity}"
    return f"{value!r}{suffix}"


def _text(value: str) -> str:
    """Return a text as octal bytes where they are not printable ASCII.

    A hexadecimal escape would also take the digits after it.
    """
    plain = {ord(char): char for char in map(chr, range(32, 127)) if char not in '"\\?'}
    return '"' + "".join(plain.get(byte, f"\\{byte:03o}") for byte in value.encode()) + '"'


def wide_units(value: str) -> list[str]:
    """Return the UTF-16 units of a wide text as literals of C."""
    data = value.encode("utf-16-le", "surrogatepass")
    return [str(low | high << 8) for low, high in zip(data[::2], data[1::2], strict=True)]
