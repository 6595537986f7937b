"""Client of the nodes' parameter services. It asks several nodes at the same time."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.graph.snapshot import full_names
from zbot.interfaces import get_service
from zbot.names import fully_qualified, is_hidden
from zbot.parameters.parameter import (
    Parameter,
    infer_parameter,
    parameter_type,
    parameter_value_to_python,
)
from zbot_cli.domain.client import full_name, nobody_runs

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node

ANSWER_TIMEOUT_S = 5.0  #: for each answer, as in ros2


class NodeNotFoundError(ZbotError):
    """No node of that name appeared in time. The hint has a similar name or the running nodes."""

    def __init__(self, name: str, known: Sequence[str]) -> None:
        self.name = name
        self.hint = f"no node {name} is running; {did_you_mean(name, known) or _others(known)}"
        super().__init__("Node not found")


class NoParameterServicesError(ZbotError):
    """A node has no parameter services, or they do not answer."""

    def __init__(self, node: str, hint: str) -> None:
        self.node, self.hint = node, hint
        super().__init__(
            f"Wait for service timed out waiting for parameter services for node {node}"
        )


class ParameterNotSetError(ZbotError):
    """The node has no parameter of this name. If `node` is `None`, no node of the domain has it."""

    def __init__(self, node: str | None, name: str, known: Sequence[str]) -> None:
        self.node, self.name = node, name
        advice = did_you_mean(name, known, before="; ")
        self.hint = f"{node or 'no node'} has {'no' if node else 'a'} parameter {name}{advice}"
        super().__init__("Parameter not set" if node else f"Parameter '{name}' not set on any node")


def _others(known: Sequence[str]) -> str:
    return f"running nodes are {', '.join(known)}" if known else nobody_runs()


@dataclass(slots=True)
class Answers:
    """Answers of nodes, and the errors of nodes without an answer."""

    found: dict[str, Any] = field(default_factory=dict)
    errors: dict[str, ZbotError] = field(default_factory=dict)


class RemoteParameters:
    """Client of the parameters of other nodes.

    Args:
        node: The node that sends the requests.
        timeout_s: Seconds to wait for a node that is not running yet.
        answer_timeout_s: Seconds to wait for each answer.
    """

    def __init__(
        self, node: Node, timeout_s: float, answer_timeout_s: float = ANSWER_TIMEOUT_S
    ) -> None:
        self._node = node
        self._timeout_s = timeout_s
        self._answer_timeout_s = answer_timeout_s

    def find(self, name: str) -> str:
        """Return a node's full name as soon as it is running.

        Raises:
            NodeNotFoundError: The node does not appear in time.
        """
        full = full_name(name)
        if not self._node.wait_for_node(full, self._timeout_s):
            raise NodeNotFoundError(full, visible_nodes(self.graph()))
        return full

    def nodes(self, *, include_hidden: bool) -> list[str]:
        """Return the nodes that have parameter services."""
        graph = self.graph()
        services = {name for name, _ in graph.services()}
        found = full_names(graph.nodes) if include_hidden else visible_nodes(graph)
        return sorted({name for name in found if f"{name}/list_parameters" in services})

    def graph(self) -> Snapshot:
        """Return the graph of the domain at this moment."""
        return self._node.context.graph.snapshot()

    def ask_all(
        self, nodes: Iterable[str], service: str, make: Callable[[type[Any], str], Any]
    ) -> Answers:
        """Ask nodes at the same time, and return their answers.

        Args:
            nodes: Full names of the nodes.
            service: The type of the service, e.g. `GetParameters`.
            make: Function that makes a request from its class and a node's name.
        """
        answers = Answers()
        pending = {}
        srv_type: Any = get_service(f"rcl_interfaces/srv/{service}")
        for node in nodes:
            try:
                pending[node] = self._send(node, srv_type, make(srv_type.Request, node))
            except ZbotError as error:
                answers.errors[node] = error
        for node, future in pending.items():
            over = threading.Event()
            future.add_waker(over.set)
            try:
                if not over.wait(self._answer_timeout_s):
                    raise NoParameterServicesError(node, f"{node} does not answer: does it spin?")
                answers.found[node] = future.result()
            except ZbotError as error:
                answers.errors[node] = error
        return answers

    def _send(self, node: str, srv_type: Any, request: Any) -> Any:
        name = f"{node}/{_snake(srv_type.__name__)}"
        client = self._node.create_client(srv_type, name)
        is_offered = any(name == one for one, _ in self.graph().services())
        if not is_offered or not client.wait_for_service(self._answer_timeout_s):
            raise NoParameterServicesError(node, f"{node} has no {name}")
        return client.call_server_async(request)

    def ask(self, node: str, service: str, **fields: Any) -> Any:
        """Return the response of one node.

        Raises:
            NoParameterServicesError: The node has no such service, or does not answer in time.
            ServiceError: The node ended before it answered, or one of its callbacks failed.
        """
        answers = self.ask_all([node], service, lambda request, _: request(**fields))
        for error in answers.errors.values():
            raise error
        return answers.found[node]

    def names(self, node: str) -> list[str]:
        """Return the names of a node's parameters, sorted."""
        return sorted(self.ask(node, "ListParameters").result.names)

    def values(self, node: str, names: Sequence[str]) -> dict[str, Parameter[Any]]:
        """Return parameters of a node. A parameter that was declared only by type has no value.

        Raises:
            ParameterNotSetError: The node has no parameter of that name.
        """
        answer = self.ask(node, "GetParameters", names=list(names)).values
        if len(answer) == len(names):
            return {name: _parameter(name, one) for name, one in zip(names, answer, strict=True)}
        return {name: self._value(node, name) for name in self.require(node, names)}

    def _value(self, node: str, name: str) -> Parameter[Any]:
        answer = self.ask(node, "GetParameters", names=[name]).values
        return _parameter(name, answer[0]) if answer else Parameter(name)

    def require(self, node: str, names: Sequence[str]) -> Sequence[str]:
        """Return `names` if the node has all these parameters.

        Raises:
            ParameterNotSetError: The node lacks one of the parameters.
        """
        known = self.names(node)
        for name in names:
            if name not in known:
                raise ParameterNotSetError(node, name, known)
        return names

    def values_or_none(self, node: str, names: Sequence[str]) -> dict[str, Any]:
        """Return the values of parameters, without the parameters that the node lacks."""
        known = set(self.names(node)) if names else set()
        found = self.values(node, [name for name in names if name in known]) if known else {}
        return {name: parameter.value for name, parameter in found.items()}

    def descriptors(self, node: str, names: Sequence[str]) -> list[Any]:
        """Return the descriptors of parameters, as messages.

        Raises:
            ParameterNotSetError: The node has no parameter of that name.
        """
        answer: list[Any] = self.ask(node, "DescribeParameters", names=list(names)).descriptors
        if len(answer) < len(names) or not all(one.name for one in answer):
            self.require(node, names)
        return answer

    def types(self, node: str, names: Sequence[str]) -> dict[str, Parameter.Type]:
        """Return the declared types of parameters of the node."""
        answer = self.ask(node, "DescribeParameters", names=list(names)).descriptors
        return {one.name: parameter_type(one.type) for one in answer}

    def typed(self, node: str, values: dict[str, Any]) -> list[Parameter[Any]]:
        """Return values of a parameter file as parameters.

        In a file, a byte array is a list of integers. So the node is asked for the types of such
        lists.
        """
        lists = [name for name, one in values.items() if is_octets(one)]
        known = set(self.names(node)) if lists else set()
        types = self.types(node, [name for name in lists if name in known]) if known else {}
        return [
            Parameter(name, Parameter.Type.BYTE_ARRAY, [bytes([one]) for one in value])
            if types.get(name) is Parameter.Type.BYTE_ARRAY
            else infer_parameter(name, value)
            for name, value in values.items()
        ]


def visible_nodes(graph: Snapshot) -> list[str]:
    """Return the full names of the nodes that are not hidden."""
    nodes = [node for node in graph.nodes if not is_hidden(fully_qualified("/", node.node))]
    return full_names(nodes)


def is_octets(value: Any) -> bool:
    """Return whether a value is a list of integers from 0 to 255. Such a list can be bytes."""
    return isinstance(value, list) and all(
        isinstance(one, int) and not isinstance(one, bool) and 0 <= one < 256 for one in value
    )


def _parameter(name: str, value: Any) -> Parameter[Any]:
    return Parameter(name, parameter_type(value.type), parameter_value_to_python(value))


def _snake(name: str) -> str:
    return "".join(f"_{one.lower()}" if one.isupper() else one for one in name).lstrip("_")
