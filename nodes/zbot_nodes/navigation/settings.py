"""Parameters of a navigation node, and the line that names those without effect."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot_nodes.startup.program import ParameterError

from rcl_interfaces.msg import ParameterDescriptor

if TYPE_CHECKING:
    import zbot

_NOT_OURS = ("use_sim_time", "qos_overrides", "start_type_description_service")


class Settings:
    """Parameters of one node. Each is declared when it is read for the first time.

    Args:
        node: The node.
    """

    def __init__(self, node: zbot.Node) -> None:
        self._node = node
        self._given = node._parameter_overrides  # noqa: SLF001 - rclpy's name for what was set

    def value(self, name: str, default: Any) -> Any:
        """Return a parameter of any type."""
        if not self._node.has_parameter(name):
            any_type = ParameterDescriptor(dynamic_typing=True)
            self._node.declare_parameter(name, default, any_type)
        return self._node.get_parameter(name).value

    def number(self, name: str, default: float) -> float:
        """Return a number.

        Raises:
            ParameterError: It is something else.
        """
        value = self.value(name, default)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ParameterError(f"the parameter {name} must be a number, not {value!r}")
        return float(value)

    def numbers(self, name: str, default: list[float]) -> list[float]:
        """Return a list of numbers, with as many as the default has.

        Raises:
            ParameterError: It is something else.
        """
        value = self.value(name, default)
        if isinstance(value, (str, bool, int, float)) or len(value) != len(default):
            raise ParameterError(f"the parameter {name} must be a list of {len(default)} numbers")
        return [float(number) for number in value]

    def text(self, name: str, default: str) -> str:
        """Return a text."""
        return str(self.value(name, default))

    def flag(self, name: str, *, default: bool) -> bool:
        """Return a truth value."""
        value = self.value(name, default)
        return value.lower() == "true" if isinstance(value, str) else bool(value)

    def texts(self, name: str, default: list[str]) -> list[str]:
        """Return a list of texts. Names between spaces in one text are a list, too."""
        value = self.value(name, default)
        return value.split() if isinstance(value, str) else [str(item) for item in value]

    def first_text(self, names: tuple[str, ...], default: str) -> str:
        """Return the text of the first of these names that was set."""
        found = [self.text(name, default) for name in names if name in self._given]
        return found[0] if found else self.text(names[0], default)

    def first(self, names: tuple[str, ...], default: float) -> float:
        """Return the number of the first of these names that was set."""
        found = [self.number(name, default) for name in names if name in self._given]
        return found[0] if found else self.number(names[0], default)

    def name_unused(self) -> None:
        """Warn once of parameters that were set, but that the node does not have."""
        unused = sorted(
            name
            for name in self._given
            if not self._node.has_parameter(name) and not name.startswith(_NOT_OURS)
        )
        if unused:
            self._node.get_logger().warning(
                f"parameters without effect: {', '.join(unused)}", once=True
            )
