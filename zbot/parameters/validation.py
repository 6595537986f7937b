"""Validation of parameter values against a descriptor: type, range, step and read-only flag."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.parameters.errors import decimal_comma
from zbot.parameters.parameter import Parameter

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterDescriptor

REL_TOL = 1e-6
_STEP_TOL = 1e-6  #: fraction of a step, because a relative tolerance is too small near zero


class Range(NamedTuple):
    """Allowed range with both ends. A step allows only the ends and `low` + n * `step`."""

    from_value: float
    to_value: float
    step: float = 0

    @property
    def low(self) -> float:
        """The smaller end."""
        return min(self.from_value, self.to_value)

    @property
    def high(self) -> float:
        """The larger end."""
        return max(self.from_value, self.to_value)

    def has_integer_step(self, value: int) -> bool:
        """Return whether an integer in the range is on a step. Both ends are always allowed."""
        return value in {self.low, self.high} or not self.step or not (value - self.low) % self.step

    def has_float_step(self, value: float) -> bool:
        """Return whether a float in the range is close enough to a step."""
        if not self.step or self.is_end(value):
            return True
        near = self.low + round((value - self.low) / self.step) * self.step
        return math.isclose(near, value, rel_tol=REL_TOL, abs_tol=_STEP_TOL * abs(self.step))

    def is_end(self, value: float) -> bool:
        """Return whether a float is equal to one of the ends, within rounding errors."""
        return math.isclose(value, self.low, rel_tol=REL_TOL) or math.isclose(
            value, self.high, rel_tol=REL_TOL
        )

    def __str__(self) -> str:
        is_every_integer = isinstance(self.step, int) and self.step == 1
        steps = f" in steps of {self.step}" if self.step and not is_every_integer else ""
        return f"from {self.low} to {self.high}{steps}"


class Descriptor(NamedTuple):
    """Descriptor of a parameter, with the fields of rcl_interfaces/msg/ParameterDescriptor.

    A descriptor is immutable, unlike the message. So later changes of a message do not affect the
    parameters that were declared with the message. Most nodes use only this class, and never load
    the message's class.
    """

    type: Parameter.Type = Parameter.Type.NOT_SET
    description: str = ""
    additional_constraints: str = ""
    read_only: bool = False
    dynamic_typing: bool = False
    floating_point_range: Range | None = None
    integer_range: Range | None = None

    @classmethod
    def of(cls, message: ParameterDescriptor) -> Descriptor:
        """Return the descriptor in a message, without the message's `name`."""
        return cls(
            type=Parameter.Type(message.type),
            description=message.description,
            additional_constraints=message.additional_constraints,
            read_only=message.read_only,
            dynamic_typing=message.dynamic_typing,
            floating_point_range=_range_of(message.floating_point_range),
            integer_range=_range_of(message.integer_range),
        )

    def with_type(self, type_: Parameter.Type) -> Descriptor:
        """Return a copy of the descriptor with another type."""
        return self._replace(type=type_)

    @property
    def range(self) -> Range | None:
        """The range for the descriptor's type, or None if there is no range."""
        if self.type is Parameter.Type.INTEGER:
            return self.integer_range
        return self.floating_point_range if self.type is Parameter.Type.DOUBLE else None

    def to_message(self, name: str) -> ParameterDescriptor:
        """Return the descriptor as a message."""
        from rcl_interfaces.msg import (  # noqa: PLC0415 - the import makes the class
            FloatingPointRange,
            IntegerRange,
            ParameterDescriptor,
        )

        return ParameterDescriptor(
            name=name,
            type=int(self.type),
            description=self.description,
            additional_constraints=self.additional_constraints,
            read_only=self.read_only,
            dynamic_typing=self.dynamic_typing,
            floating_point_range=_range_messages(FloatingPointRange, self.floating_point_range),
            integer_range=_range_messages(IntegerRange, self.integer_range),
        )


def _range_of(messages: Any) -> Range | None:
    return (
        Range(messages[0].from_value, messages[0].to_value, messages[0].step) if messages else None
    )


def _range_messages(kind: Any, values: Range | None) -> list[Any]:
    if values is None:
        return []
    return [kind(from_value=values.from_value, to_value=values.to_value, step=values.step)]


def widened(parameter: Parameter[Any], descriptor: Descriptor) -> Parameter[Any]:
    """Return the parameter in its declared type, e.g. an integer as a double, `[]` as an array."""
    declared, given = descriptor.type, parameter.type_
    if descriptor.dynamic_typing or declared is given:
        return parameter
    is_empty = given.is_array and declared.is_array and not parameter.value
    pair = (given, declared)
    if is_empty or pair in _WIDENINGS:
        try:
            return Parameter(parameter.name, declared, parameter.value)
        except ValueError:
            return parameter  # too large for a double: a later check rejects the integer
    return parameter


_WIDENINGS = {
    (Parameter.Type.INTEGER, Parameter.Type.DOUBLE),
    (Parameter.Type.INTEGER_ARRAY, Parameter.Type.DOUBLE_ARRAY),
}


def is_wrong_type(parameter: Parameter[Any], descriptor: Descriptor) -> bool:
    """Return whether a parameter with static typing has another type than its descriptor."""
    is_static = not descriptor.dynamic_typing and parameter.type_ is not Parameter.Type.NOT_SET
    return is_static and parameter.type_ is not descriptor.type


def rejection_reason(
    parameter: Parameter[Any],
    descriptor: Descriptor,
    present: Parameter[Any] | None = None,
    *,
    check_read_only: bool = True,
) -> str:
    """Return why a descriptor rejects a value. Return an empty string if the value is allowed.

    The texts begin with rclpy's texts.

    Args:
        parameter: The new value, after `widened`.
        descriptor: The parameter's descriptor.
        present: The current value, if the parameter is declared already.
        check_read_only: Whether to reject a read-only parameter.
    """
    name = parameter.name
    if check_read_only and descriptor.read_only:
        return f"Trying to set a read-only parameter: {name}."
    if not descriptor.dynamic_typing:
        if present is not None and parameter.type_ is Parameter.Type.NOT_SET:
            return "Static parameter cannot be undeclared"
        if is_wrong_type(parameter, descriptor):
            wrong = f"expected '{descriptor.type.text}' got '{parameter.type_.text}'"
            point = decimal_comma(parameter.value, descriptor.type.text)
            return f"Wrong parameter type, {wrong}: {_facts(name, descriptor, present)}{point}"
    reason = _range_rejection(parameter, descriptor.with_type(parameter.type_))
    now = "" if present is None or present.value is None else f", now {present.value}"
    return f"{reason} ({parameter.type_.text}{now})" if reason else ""


def _range_rejection(parameter: Parameter[Any], descriptor: Descriptor) -> str:
    limits, name, value = descriptor.range, parameter.name, parameter.value
    if limits is None:
        return ""
    is_float = parameter.type_ is Parameter.Type.DOUBLE
    if not limits.low <= value <= limits.high and not (is_float and limits.is_end(value)):
        return (
            f"Parameter {name} out of range. Min: {limits.low}, Max: {limits.high}, value: {value}"
        )
    if is_float and not limits.has_float_step(value):
        fault = "close enough to a valid step"
    elif not is_float and not limits.has_integer_step(value):
        fault = "a valid step"
    else:
        return ""
    numbers = f"Min: {limits.low}, max: {limits.high}, value: {value}, step: {limits.step}"
    return f"The parameter value for {name} is not {fault}. {numbers}"


def _facts(name: str, descriptor: Descriptor, present: Parameter[Any] | None) -> str:
    limits = "" if descriptor.range is None else f" {descriptor.range}"
    now = "" if present is None or present.value is None else f", and is {present.value!r}"
    return f"{name} takes a value of type {descriptor.type.text}{limits}{now}"
