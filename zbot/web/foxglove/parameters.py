"""Parameters of all nodes, with names such as `/turtlesim.background_r`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.remote.parameters import RemoteParameters, nodes_with_parameters
from zbot.remote.service_calls import ServiceCalls

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.observer.system import System
    from zbot.parameters.parameter import Parameter

_PATIENCE_S = 3.0


class Parameters:
    """Reader and writer of the parameters of all nodes. The methods block.

    Args:
        system: The running system.
    """

    def __init__(self, system: System) -> None:
        self._system = system
        self._remote = RemoteParameters(ServiceCalls(system.node, answer_timeout_s=_PATIENCE_S))

    def read(self, names: Iterable[str]) -> list[Any]:
        """Return the parameters with these names, as the SDK's objects. No names mean all."""
        wanted: dict[str, list[str]] = {}
        for name in names:
            node, _, parameter = name.partition(".")
            wanted.setdefault(node, []).append(parameter)
        found: list[Any] = []
        for node, own in (wanted or self._all_names()).items():
            try:
                values = self._remote.values(node, own)
            except ZbotError as error:
                _warn(node, error)
                continue
            found += [
                _sdk_parameter(node, value) for value in values.values() if value.value is not None
            ]
        return found

    def _all_names(self) -> dict[str, list[str]]:
        nodes = nodes_with_parameters(self._system.snapshot(), include_hidden=False)
        answers = self._remote.all_names(nodes)
        for node, error in answers.errors.items():
            _warn(node, error)
        return answers.found

    def write(self, parameters: Iterable[Any]) -> list[Any]:
        """Set parameters, and return them with the values that the nodes have afterwards."""
        names = []
        for change in parameters:
            names.append(change.name)
            node, _, name = change.name.partition(".")
            parameter = self._remote.from_json(node, name, change.get_value())
            (result,) = self._remote.set(node, [parameter])
            if not result.successful:
                get_logger("zbot.foxglove").warning(f"{change.name}: {result.reason}")
        return self.read(names) if names else []


def _warn(node: str, error: ZbotError) -> None:
    get_logger("zbot.foxglove").warning(f"{node} gives no parameters: {error}")


def _sdk_parameter(node: str, parameter: Parameter[Any]) -> Any:
    from foxglove import Parameter as SdkParameter  # noqa: PLC0415 - an extra

    return SdkParameter(f"{node}.{parameter.name}", value=_plain(parameter.value))


def _plain(value: Any) -> Any:
    """Convert a value to a type that the SDK accepts."""
    if isinstance(value, (bool, int, float, str, bytes)):
        return value
    items = list(value)
    return b"".join(items) if items and isinstance(items[0], bytes) else items
