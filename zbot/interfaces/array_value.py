"""Values of numeric fields: `array.array` for sequences, numpy's ndarrays for fixed sizes."""

from __future__ import annotations

import functools
import importlib
import sys
from array import array
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

#: numpy's dtype for each typecode of `array`.
DTYPES = {
    "b": "int8",
    "B": "uint8",
    "h": "int16",
    "H": "uint16",
    "i": "int32",
    "I": "uint32",
    "q": "int64",
    "Q": "uint64",
    "f": "float32",
    "d": "float64",
}


@functools.cache
def numpy() -> Any | None:
    """Return numpy, which the first call imports. Return None if numpy is not installed."""
    try:
        return importlib.import_module("numpy")
    except ImportError:
        return None


def is_ndarray(value: object) -> bool:
    """Return whether a value is an ndarray, without importing numpy."""
    # While another thread imports numpy, the module is in `sys.modules` but is not yet complete.
    ndarray = getattr(sys.modules.get("numpy"), "ndarray", None)
    return ndarray is not None and isinstance(value, ndarray)


def fixed_array(typecode: str, values: Iterable[Any]) -> Any:
    """Return the value of a fixed-size numeric field: an ndarray, or `array.array` without numpy.

    Args:
        typecode: The field's `array` typecode, which also sets the ndarray's dtype.
        values: The checked elements. An `array.array` of the same typecode is not copied.
    """
    elements = values if isinstance(values, array) else array(typecode, values)
    module = numpy()
    return module.frombuffer(elements, DTYPES[typecode]) if module else elements


def fixed_default(
    typecode: str, size: int, default: tuple[Any, ...] | None = None
) -> Callable[[], Any]:
    """Return a function that makes a new default value of a fixed-size numeric field."""
    if default is not None:
        return functools.partial(fixed_array, typecode, default)

    def zeros() -> Any:
        module = numpy()
        return module.zeros(size, DTYPES[typecode]) if module else array(typecode, [0]) * size

    return zeros


def same_elements(left: Any, right: Any) -> bool:
    """Return whether two fixed-size numeric values (ndarray or `array.array`) are equal."""
    if is_ndarray(left) or is_ndarray(right):
        return len(left) == len(right) and bool((left == right).all())
    return bool(left == right)


def elements_text(value: Any) -> str:
    """Return the text of a numeric sequence in ROS 2's form, which has only the elements."""
    return repr(value.tolist() if hasattr(value, "tolist") else value)
