"""Functions of ros2cli's `ros2param`, which get and set parameters of other nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import WrongStateError
from zbot.parameters import parameter
from zbot.remote.parameters import RemoteParameters
from zbot.remote.service_calls import ANSWER_TIMEOUT_S, NoServiceError, ServiceCalls

from rcl_interfaces.msg import ParameterType

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.node.node import Node

    from rcl_interfaces.msg import Parameter, ParameterValue
    from rcl_interfaces.srv import DescribeParameters, GetParameters, SetParameters

_TYPE_NAMES = {
    ParameterType.PARAMETER_NOT_SET: "not set",
    ParameterType.PARAMETER_BOOL: "boolean",
    ParameterType.PARAMETER_INTEGER: "integer",
    ParameterType.PARAMETER_DOUBLE: "double",
    ParameterType.PARAMETER_STRING: "string",
    ParameterType.PARAMETER_BYTE_ARRAY: "byte array",
    ParameterType.PARAMETER_BOOL_ARRAY: "boolean array",
    ParameterType.PARAMETER_INTEGER_ARRAY: "integer array",
    ParameterType.PARAMETER_DOUBLE_ARRAY: "double array",
    ParameterType.PARAMETER_STRING_ARRAY: "string array",
}


def no_parameter_service_error(node_name: str) -> WrongStateError:
    """Return the error that a node has no parameter services, or they did not appear in time."""
    timeout = f"{ANSWER_TIMEOUT_S:.0f} s"
    return WrongStateError(f"{node_name} offered no parameter services within {timeout}")


def get_value(*, parameter_value: ParameterValue) -> Any:
    """Return the value in a message, or None if no value is set."""
    return parameter.parameter_value_to_python(parameter_value)


def get_parameter_value(*, string_value: str) -> ParameterValue:
    """Return the value of a string on the command line, as a message."""
    return parameter.get_parameter_value(string_value)


def get_parameter_type_string(parameter_type: int) -> str:
    """Return the name of a parameter type, as `ros2 param describe` prints it."""
    return _TYPE_NAMES[parameter_type]


def call_get_parameters(
    *, node: Node, node_name: str, parameter_names: Sequence[str]
) -> GetParameters.Response:
    """Ask a node for parameters. The response has one value, maybe "not set", for each name.

    This function may be called anywhere, also in a callback.

    Args:
        node: The node that asks.
        node_name: Full name of the node that is asked.
        parameter_names: Names of the parameters.

    Raises:
        WrongStateError: The node offers no parameter services within 5 s.
        ServiceError: The node ended before it answered.
    """
    response: GetParameters.Response = _answer(
        node, "GetParameters", node_name, names=list(parameter_names)
    )
    return response


def call_set_parameters(
    *, node: Node, node_name: str, parameters: Sequence[Parameter]
) -> SetParameters.Response:
    """Set a node's parameters. The response has one result for each parameter.

    See `call_get_parameters`.
    """
    response: SetParameters.Response = _answer(
        node, "SetParameters", node_name, parameters=list(parameters)
    )
    return response


def call_describe_parameters(
    *, node: Node, node_name: str, parameter_names: Sequence[str] | None = None
) -> DescribeParameters.Response:
    """Ask a node for descriptions of parameters. See `call_get_parameters`."""
    response: DescribeParameters.Response = _answer(
        node, "DescribeParameters", node_name, names=list(parameter_names or [])
    )
    return response


def call_list_parameters(
    *, node: Node, node_name: str, prefixes: Sequence[str] | None = None
) -> list[str]:
    """Return the names of a node's parameters. See `call_get_parameters`."""
    answer = _answer(node, "ListParameters", node_name, prefixes=list(prefixes or []))
    return list(answer.result.names)


def _answer(node: Node, service: str, node_name: str, **fields: Any) -> Any:
    calls = ServiceCalls(node, answer_timeout_s=None, server_timeout_s=ANSWER_TIMEOUT_S)
    try:
        return RemoteParameters(calls).ask(node_name, service, **fields)
    except NoServiceError:
        raise no_parameter_service_error(node_name) from None
