"""Parameters of other nodes, which a page reads, shows and sets."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.interfaces import FieldType, get_service
from zbot.parameters.errors import ParameterAnswerError
from zbot.parameters.parameter import Parameter, parameter_type, parameter_value_to_python
from zbot.web.form_value import Entry, EntryError, read, show
from zbot.web.service_call import call

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.web.system import System

_LIST = "rcl_interfaces/srv/ListParameters"
_GET = "rcl_interfaces/srv/GetParameters"
_DESCRIBE = "rcl_interfaces/srv/DescribeParameters"
_SET = "rcl_interfaces/srv/SetParameters"
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
class RemoteParameter:
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
            EntryError: The entry does not fit the parameter's type.
        """
        kind = _TYPES.get(self.type)
        if kind is None:
            raise EntryError(self.name, "it has no value: set one with `zbot param set`")
        return read(kind, entry, self.name, lambda: 0)


def show_value(type_: Parameter.Type, value: Any) -> str:
    """Return the text that an input shows for a value."""
    kind = _TYPES.get(type_)
    return "" if kind is None else show(kind, value)


def nodes_with_parameters(graph: Snapshot) -> list[str]:
    """Return the sorted full names of the nodes that have parameter services."""
    served = (name for name, types in graph.services() if _SET in types)
    return sorted(name.rpartition("/")[0] for name in served)


async def load(system: System, node: str) -> list[RemoteParameter]:
    """Return a node's parameters, sorted by name.

    Raises:
        ServiceError: The node has ended.
        NoAnswerError: The node does not answer.
        ParameterAnswerError: The node's answer does not fit the request.
    """
    listed = await _ask(system, node, "list_parameters", _LIST)
    names = sorted(listed.result.names)
    if not names:
        return []
    described = await _ask(system, node, "describe_parameters", _DESCRIBE, names=names)
    got = await _ask(system, node, "get_parameters", _GET, names=names)
    return remote_parameters(node, names, got.values, described.descriptors)


def remote_parameters(
    node: str, names: list[str], values: list[Any], descriptors: list[Any]
) -> list[RemoteParameter]:
    """Return the parameters in a node's answers.

    Raises:
        ParameterAnswerError: The answers do not have a value and a descriptor for each name.
        UnknownParameterTypeError: A value has an unknown type.
    """
    if not len(names) == len(values) == len(descriptors):
        reason = f"{len(values)} values and {len(descriptors)} descriptors for {len(names)} names"
        raise ParameterAnswerError(node, reason)
    found = zip(names, values, descriptors, strict=True)
    return [_remote(name, value, descriptor) for name, value, descriptor in found]


async def set_value(system: System, node: str, parameter: Parameter[Any]) -> str:
    """Set one parameter. Return the node's reason if it refuses, otherwise an empty string.

    Raises:
        ReadOnlyError: The page is read-only.
        ServiceError: The node has ended.
        NoAnswerError: The node does not answer.
        ParameterAnswerError: The node's answer does not fit the request.
    """
    request = get_service(_SET).Request(  # type: ignore[attr-defined] # each service has it
        parameters=[parameter.to_parameter_msg()]
    )
    response = await call(system, f"{node}/set_parameters", _SET, request)
    if len(response.results) != 1:
        raise ParameterAnswerError(node, f"it has {len(response.results)} results, not one")
    result = response.results[0]
    return "" if result.successful else result.reason or "the node refused the value"


async def _ask(system: System, node: str, name: str, type_name: str, **fields: Any) -> Any:
    request = get_service(type_name).Request(**fields)  # type: ignore[attr-defined] # each service has it
    return await call(system, f"{node}/{name}", type_name, request, changes=False)


def _remote(name: str, value: Any, descriptor: Any) -> RemoteParameter:
    type_ = parameter_type(value.type)
    return RemoteParameter(
        name,
        type_,
        parameter_value_to_python(value),
        descriptor.description,
        descriptor.additional_constraints,
        _range(descriptor),
        descriptor.read_only,
    )


def _range(descriptor: Any) -> Range | None:
    for one in (*descriptor.integer_range, *descriptor.floating_point_range):
        low, high, step = float(one.from_value), float(one.to_value), float(one.step)
        if math.isfinite(low) and math.isfinite(high) and low < high:
            return Range(low, high, step)
    return None
