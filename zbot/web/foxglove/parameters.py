"""Parameters of all nodes, with names such as `/turtlesim.background_r`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.names import is_hidden
from zbot.parameters.parameter import Parameter, parameter_value_to_python

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.web.system import System

_LIST = "rcl_interfaces/srv/ListParameters"
_GET = "rcl_interfaces/srv/GetParameters"
_SET = "rcl_interfaces/srv/SetParameters"
_PATIENCE_S = 3.0


class Parameters:
    """Reader and writer of the parameters of all nodes. The methods block.

    Args:
        system: The running system.
    """

    def __init__(self, system: System) -> None:
        self._system = system

    def read(self, names: Iterable[str]) -> list[Any]:
        """Return the parameters with these names, as the SDK's objects. No names mean all."""
        wanted: dict[str, list[str] | None] = {}
        for name in names:
            node, _, parameter = name.partition(".")
            known = wanted.setdefault(node, [])
            if known is not None:
                known.append(parameter)
        if not wanted:
            wanted = dict.fromkeys(self._nodes())
        found: list[Any] = []
        for node, own in wanted.items():
            try:
                found += self._read_node(node, own)
            except (ZbotError, TimeoutError) as error:
                get_logger("zbot.foxglove").warning(f"{node} gives no parameters: {error}")
        return found

    def write(self, parameters: Iterable[Any]) -> list[Any]:
        """Set parameters, and return them with the values that the nodes have afterwards."""
        names = []
        for one in parameters:
            names.append(one.name)
            node, _, name = one.name.partition(".")
            value = Parameter(name, value=self._fitting(node, name, one.get_value()))
            request = self._request(_SET, parameters=[value.to_parameter_msg()])
            for result in self._call(node, "set_parameters", _SET, request).results:
                if not result.successful:
                    get_logger("zbot.foxglove").warning(f"{one.name}: {result.reason}")
        return self.read(names) if names else []

    def _fitting(self, node: str, name: str, value: Any) -> Any:
        """Convert a number to the type of the parameter, because JSON writes 1.0 as 1."""
        request = self._request(_GET, names=[name])
        values = self._call(node, "get_parameters", _GET, request).values
        # The response of a node of ROS 2 has no value if the parameter does not exist.
        present = parameter_value_to_python(values[0]) if len(values) else None
        if isinstance(present, float) and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        if isinstance(present, int) and isinstance(value, float) and value.is_integer():
            return int(value)
        return value

    def _nodes(self) -> list[str]:
        """Return the nodes that have services for parameters."""
        names = dict(self._system.snapshot().services())
        nodes = (
            one.removesuffix("/list_parameters")
            for one in names
            if one.endswith("/list_parameters")
        )
        return [one for one in nodes if not is_hidden(one)]

    def _read_node(self, node: str, names: list[str] | None) -> list[Any]:
        from foxglove import Parameter as SdkParameter  # noqa: PLC0415 - an extra

        if names is None:
            request = self._request(_LIST)
            names = list(self._call(node, "list_parameters", _LIST, request).result.names)
        request = self._request(_GET, names=names)
        values = self._call(node, "get_parameters", _GET, request).values
        if len(values) != len(names):
            return []  # a node of ROS 2 returns no values if one of the names is unknown
        found = (
            (name, parameter_value_to_python(one)) for name, one in zip(names, values, strict=True)
        )
        return [
            SdkParameter(f"{node}.{name}", value=_plain(value))
            for name, value in found
            if value is not None
        ]

    def _request(self, kind: str, **fields: Any) -> Any:
        return self._system.interface(kind).Request(**fields)

    def _call(self, node: str, service: str, kind: str, request: Any) -> Any:
        with self._system.reader(f"{node}/{service}", kind) as reference:
            return reference.entity.call(request, timeout_sec=_PATIENCE_S)


def _plain(value: Any) -> Any:
    """Convert a value to a type that the SDK accepts."""
    if isinstance(value, (bool, int, float, str, bytes)):
        return value
    items = list(value)
    return b"".join(items) if items and isinstance(items[0], bytes) else items
