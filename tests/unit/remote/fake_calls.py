"""Calls of parameter services that functions answer, without other nodes."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from zbot.parameters.parameter import Parameter
from zbot.remote.service_calls import Answers, NoServiceError, ServiceCalls

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult


class FakeNode:
    """A node as in ROS 2: it gives no values and no descriptors if it lacks one of the names."""

    def __init__(self, **values: Any) -> None:
        self.values = values
        self.is_read_only = False

    def list_parameters(self, _request: Any) -> Any:
        return SimpleNamespace(result=SimpleNamespace(names=list(self.values)))

    def get_parameters(self, request: Any) -> Any:
        found = [Parameter(name, value=self.values[name]) for name in self._known(request.names)]
        return SimpleNamespace(values=[parameter.to_parameter_msg().value for parameter in found])

    def describe_parameters(self, request: Any) -> Any:
        types = {name: Parameter(name, value=self.values[name]).type_ for name in self.values}
        described = [
            ParameterDescriptor(name=name, type=types[name]) for name in self._known(request.names)
        ]
        return SimpleNamespace(descriptors=described)

    def set_parameters(self, request: Any) -> Any:
        for message in request.parameters:
            parameter = Parameter.from_parameter_msg(message)
            self.values[parameter.name] = parameter.value
        result = SetParametersResult(successful=not self.is_read_only)
        return SimpleNamespace(results=[result] * len(request.parameters))

    def _known(self, names: list[str]) -> list[str]:
        return names if all(name in self.values for name in names) else []


class FakeCalls(ServiceCalls):
    """Calls that reach only the given nodes, by their full names."""

    def __init__(self, **nodes: Any) -> None:
        self.nodes = {f"/{name}": node for name, node in nodes.items()}

    def call(self, name: str, srv_type: type[Any], request: Any) -> Any:
        del srv_type
        node, _, service = name.rpartition("/")
        if node not in self.nodes:
            raise NoServiceError(name)
        return getattr(self.nodes[node], service)(request)

    def call_all(self, srv_type: type[Any], requests: Any) -> Answers:
        answers = Answers()
        for name, request in requests.items():
            try:
                answers.found[name] = self.call(name, srv_type, request)
            except NoServiceError as error:
                answers.errors[name] = error
        return answers
