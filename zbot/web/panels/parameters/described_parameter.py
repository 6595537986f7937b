"""Parameters of other nodes, which a page reads, shows and sets."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import FieldType
from zbot.interfaces.message_reader import FieldMisfitError
from zbot.parameters.parameter import Parameter
from zbot.web.forms.form_value import Entry, is_too_long, read, show

if TYPE_CHECKING:
    from zbot.observer.system import System
    from zbot.remote.parameters import RemoteParameters

_TYPES = {
    Parameter.Type.BOOL: FieldType("bool"),
    Parameter.Type.INTEGER: FieldType("int64"),
    Parameter.Type.DOUBLE: FieldType("float64"),
    Parameter.Type.STRING: FieldType("string"),
    Parameter.Type.BYTE_ARRAY: FieldType("byte", "sequence"),
    Parameter.Type.BOOL_ARRAY: FieldType("bool", "sequence"),
    Parameter.Type.INTEGER_ARRAY: FieldType("int64", "sequence"),
    Parameter.Type.DOUBLE_ARRAY: FieldType("float64", "sequence"),
    Parameter.Type.STRING_ARRAY: FieldType("string", "sequence"),
}


@dataclass(frozen=True, slots=True)
class Range:
    """Range of allowed numbers."""

    low: float
    high: float
    step: float  #: 0 if all values between the limits are allowed

    @property
    def text(self) -> str:
        """The range in words."""
        step = f" in steps of {self.step:g}" if self.step not in {0, 1} else ""
        return f"{self.low:g} to {self.high:g}{step}"


@dataclass(frozen=True, slots=True)
class DescribedParameter:
    """Parameter of another node and its descriptor."""

    name: str
    type: Parameter.Type
    value: Any
    description: str
    constraints: str  #: the descriptor's `additional_constraints`
    range: Range | None
    is_read_only: bool

    @property
    def text(self) -> str:
        """The text that an input shows for the value."""
        return show_value(self.type, self.value)

    def read(self, entry: Entry) -> Any:
        """Return the value for an entry.

        Raises:
            FieldMisfitError: The entry does not fit the parameter's type.
        """
        kind = _TYPES.get(self.type)
        if kind is None:
            raise FieldMisfitError(self.name, "it has no value: set one with `zbot param set`")
        return read(kind, entry, self.name, lambda: 0)


def show_value(type_: Parameter.Type, value: Any) -> str:
    """Return the text that an input shows for a value."""
    kind = _TYPES.get(type_)
    return "" if kind is None else show(kind, value)


def has_long_value(type_: Parameter.Type, value: Any) -> bool:
    """Return whether a value is a list that is too long for an input."""
    kind = _TYPES.get(type_)
    return kind is not None and is_too_long(kind, value)


def load(parameters: RemoteParameters, node: str, prefix: str = "") -> list[DescribedParameter]:
    """Return a node's parameters whose names begin with a prefix. This may take seconds.

    Raises:
        NoServiceError: The node has ended.
        NoAnswerError: The node does not answer.
        WrongValueError: The node's answer does not fit the request.
        UnknownParameterTypeError: A value has an unknown type.
    """
    names = [name for name in parameters.names(node) if name.startswith(prefix)]
    if not names:
        return []
    values = parameters.values(node, names)
    return [
        _shown(values[descriptor.name], descriptor)
        for descriptor in parameters.descriptors(node, names)
    ]


def set_value(system: System, node: str, parameter: Parameter[Any]) -> str:
    """Set one parameter. Return the node's reason if it refuses, otherwise an empty string.

    Raises:
        ViewerError: The page is read-only.
        NoAnswerError: The node does not answer.
        NoServiceError: The node has ended.
        WrongValueError: The node's answer does not fit the request.
    """
    (result,) = system.set_parameters(node, [parameter])
    return "" if result.successful else result.reason or "the node refused the value"


def _shown(parameter: Parameter[Any], descriptor: Any) -> DescribedParameter:
    return DescribedParameter(
        parameter.name,
        parameter.type_,
        parameter.value,
        descriptor.description,
        descriptor.additional_constraints,
        _range(descriptor),
        descriptor.read_only,
    )


def _range(descriptor: Any) -> Range | None:
    for limits in (*descriptor.integer_range, *descriptor.floating_point_range):
        low, high, step = float(limits.from_value), float(limits.to_value), float(limits.step)
        if math.isfinite(low) and math.isfinite(high) and low < high:
            return Range(low, high, step)
    return None
