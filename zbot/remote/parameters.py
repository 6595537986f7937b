"""Client of other nodes' parameters. It can ask several nodes at the same time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.graph.snapshot import full_names
from zbot.interfaces import get_service
from zbot.names import is_hidden
from zbot.parameters.errors import parameter_answer_error
from zbot.parameters.parameter import (
    Parameter,
    infer_parameter,
    parameter_type,
    parameter_value_to_python,
)
from zbot.remote.service_calls import Answers

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import TypeAlias

    from zbot.graph.snapshot import Snapshot
    from zbot.remote.service_calls import ServiceCalls

    from rcl_interfaces.msg import Parameter as ParameterMsg

    Parameters: TypeAlias = Sequence[Parameter[Any] | ParameterMsg]


class ParameterNotSetError(ZbotError):
    """The node has no parameter of this name. If `node` is `None`, no node of the domain has it."""

    def __init__(self, node: str | None, name: str, known: Sequence[str]) -> None:
        self.node, self.name = node, name
        advice = did_you_mean(name, known, before="; ")
        self.hint = f"{node or 'no node'} has {'no' if node else 'a'} parameter {name}{advice}"
        super().__init__("Parameter not set" if node else f"Parameter '{name}' not set on any node")


class RemoteParameters:
    """Client of the parameters of other nodes. Any thread may call the methods, which block.

    Each method can raise the errors of `ServiceCalls.call`. A node is given by its full name.

    Args:
        calls: The calls of the services, with their limits.
    """

    def __init__(self, calls: ServiceCalls) -> None:
        self._calls = calls

    def names(self, node: str) -> list[str]:
        """Return the names of a node's parameters, sorted."""
        return sorted(self.ask(node, "ListParameters").result.names)

    def all_names(self, nodes: Iterable[str], prefixes: Sequence[str] = ()) -> Answers:
        """Ask nodes at the same time for the names of their parameters.

        Args:
            nodes: The nodes.
            prefixes: Only parameters below these prefixes. Without a prefix, all parameters.

        Returns:
            A sorted list of names for each node, and the errors of the other nodes.
        """
        srv_type = _service("ListParameters")
        ending = "/list_parameters"
        request = srv_type.Request(prefixes=list(prefixes))
        answers = self._calls.call_all(srv_type, {f"{node}{ending}": request for node in nodes})
        return Answers(
            {
                name.removesuffix(ending): sorted(answer.result.names)
                for name, answer in answers.found.items()
            },
            {name.removesuffix(ending): error for name, error in answers.errors.items()},
        )

    def value(self, node: str, name: str) -> Parameter[Any]:
        """Return a parameter of a node. It has no value if it is unknown or not set."""
        answer = self.ask(node, "GetParameters", names=[name]).values
        return _parameter(name, answer[0]) if len(answer) else Parameter(name)

    def values(self, node: str, names: Sequence[str]) -> dict[str, Parameter[Any]]:
        """Return parameters of a node. A parameter that was declared only by type has no value.

        Raises:
            ParameterNotSetError: The node has no parameter of that name.
            UnknownParameterTypeError: A value has an unknown type.
        """
        answer = self.ask(node, "GetParameters", names=list(names)).values
        if len(answer) == len(names):
            return {
                name: _parameter(name, value) for name, value in zip(names, answer, strict=True)
            }
        return {name: self.value(node, name) for name in self._require(node, names)}

    def known_values(self, node: str, names: Sequence[str]) -> dict[str, Parameter[Any]]:
        """Return parameters of a node, without those that the node lacks."""
        known = set(self.names(node)) if names else set()
        return self.values(node, [name for name in names if name in known]) if known else {}

    def _require(self, node: str, names: Sequence[str]) -> Sequence[str]:
        known = self.names(node)
        for name in names:
            if name not in known:
                raise ParameterNotSetError(node, name, known)
        return names

    def descriptors(self, node: str, names: Sequence[str]) -> list[Any]:
        """Return the descriptors of parameters, as messages.

        Raises:
            ParameterNotSetError: The node has no parameter of that name.
            WrongValueError: The node's answer does not fit the request.
        """
        answer = list(self.ask(node, "DescribeParameters", names=list(names)).descriptors)
        if [descriptor.name for descriptor in answer] != list(names):
            self._require(node, names)
            reason = f"{len(answer)} descriptors for {len(names)} names"
            raise parameter_answer_error(node, reason)
        return answer

    def types(self, node: str, names: Sequence[str]) -> dict[str, Parameter.Type]:
        """Return the declared types of parameters of a node."""
        answer = self.ask(node, "DescribeParameters", names=list(names)).descriptors
        return {descriptor.name: parameter_type(descriptor.type) for descriptor in answer}

    def set(self, node: str, parameters: Parameters, *, atomic: bool = False) -> list[Any]:
        """Set parameters of a node. A parameter without a value is deleted.

        Args:
            node: The node.
            parameters: The parameters.
            atomic: Whether to set all of them or none of them.

        Returns:
            A `rcl_interfaces/msg/SetParametersResult` for each parameter.

        Raises:
            WrongValueError: The node's answer does not fit the request.
        """
        messages = parameter_messages(parameters)
        if atomic:
            answer = self.ask(node, "SetParametersAtomically", parameters=messages)
            return [answer.result] * len(messages)
        results = list(self.ask(node, "SetParameters", parameters=messages).results)
        if len(results) != len(messages):
            reason = f"it has {len(results)} results for {len(messages)} parameters"
            raise parameter_answer_error(node, reason)
        return results

    def from_file(self, node: str, values: dict[str, Any]) -> list[Parameter[Any]]:
        """Return values of a parameter file as parameters.

        In a file, a byte array is a list of integers. So the node is asked for the types of such
        lists.
        """
        lists = [name for name, value in values.items() if _is_octets(value)]
        known = set(self.names(node)) if lists else set()
        types = self.types(node, [name for name in lists if name in known]) if known else {}
        return [
            Parameter(name, Parameter.Type.BYTE_ARRAY, [bytes([octet]) for octet in value])
            if types.get(name) is Parameter.Type.BYTE_ARRAY
            else infer_parameter(name, value)
            for name, value in values.items()
        ]

    def from_json(self, node: str, name: str, value: Any) -> Parameter[Any]:
        """Return a value of a JSON text as a parameter.

        Many programs write 1.0 as 1, so the node is asked whether its number is a float.
        """
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        present = self.value(node, name).type_ if is_number else None
        if present is Parameter.Type.DOUBLE:
            value = float(value)
        elif present is Parameter.Type.INTEGER and float(value).is_integer():
            value = int(value)
        return Parameter(name, value=value)

    def ask(self, node: str, service: str, **fields: Any) -> Any:
        """Call a parameter service of a node, e.g. `GetParameters`, and return the response."""
        srv_type = _service(service)
        words = "".join(
            f"_{character.lower()}" if character.isupper() else character for character in service
        )
        return self._calls.call(f"{node}/{words.lstrip('_')}", srv_type, srv_type.Request(**fields))


def parameter_messages(parameters: Parameters) -> list[ParameterMsg]:
    """Return parameters as messages."""
    return [
        parameter.to_parameter_msg() if isinstance(parameter, Parameter) else parameter
        for parameter in parameters
    ]


def nodes_with_parameters(graph: Snapshot, *, include_hidden: bool) -> list[str]:
    """Return the full names of the nodes that have parameter services, sorted."""
    services = {name for name, _ in graph.services()}
    found = full_names(graph.nodes) if include_hidden else visible_nodes(graph)
    return sorted({name for name in found if f"{name}/list_parameters" in services})


def visible_nodes(graph: Snapshot) -> list[str]:
    """Return the full names of the nodes that are not hidden."""
    return full_names(node for node in graph.nodes if not is_hidden(node.node))


def _service(name: str) -> Any:
    return get_service(f"rcl_interfaces/srv/{name}")


def _parameter(name: str, value: Any) -> Parameter[Any]:
    return Parameter(name, parameter_type(value.type), parameter_value_to_python(value))


def _is_octets(value: Any) -> bool:
    """Return whether a value is a list of integers from 0 to 255. Such a list can be bytes."""
    return isinstance(value, list) and all(
        isinstance(item, int) and not isinstance(item, bool) and 0 <= item < 256 for item in value
    )
