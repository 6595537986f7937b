"""Publish messages, call services and send goals with the buttons and axes of a gamepad.

Run:        zbot run joy_teleop joy_teleop --ros-args --params-file joy_teleop.yaml
Subscribes: joy (sensor_msgs/Joy)
Parameters: for each command NAME: NAME.type (topic, service or action), NAME.interface_type, and
            topic:   topic_name, deadman_buttons, deadman_axes, deadman_axes_negative, and either
                     message_value.FIELD.value or axis_mappings.FIELD with axis, scale and offset,
                     or button, or value; index for a field that is an array
            service: service_name, service_request.FIELD, buttons, axes, axes_negative
            action:  action_name, action_goal.FIELD, buttons, axes, axes_negative
"""

from __future__ import annotations

from typing import Any

import zbot
from zbot.action import ActionClient
from zbot.interfaces import get_interface
from zbot.interfaces.set_fields import set_message_fields
from zbot_nodes.startup.program import run_node

from sensor_msgs.msg import Joy

_DEPTH = 10
_ON = 1.0  # value of a pressed button, and of an axis at its end


class JoyTeleopError(zbot.ZbotError, ValueError):
    """A command in the parameters cannot be used."""


class JoyTeleopFieldError(JoyTeleopError):
    """A message has no such field, or the value does not fit. The other commands can be used."""


class Command:
    """Something to do while all of its buttons and axes are pressed.

    Args:
        node: The node.
        name: The name of the command in the parameters.
        config: The parameters of the command.
        prefix: Text before the names of the parameters with buttons and axes.
    """

    kind = "msg"
    options: tuple[str, ...] = ()  #: parameters that the command must have

    def __init__(self, node: zbot.Node, name: str, config: dict[str, Any], prefix: str) -> None:
        self.node, self.name, self.config = node, name, config
        self.conditions = [
            (part, index, wanted)
            for key, part, wanted in (
                ("buttons", "buttons", _ON),
                ("axes", "axes", _ON),
                ("axes_negative", "axes", -_ON),
            )
            for index in self.indices(f"{prefix}{key}")
        ]
        if not self.conditions:
            raise JoyTeleopError(
                f"No buttons, axes or negative_axes configured for command '{name}'"
            )
        for option in ("interface_type", *self.options):
            if option not in config:
                raise JoyTeleopError(f"the command '{name}' needs the parameter {name}.{option}")
        parts = str(config["interface_type"]).split("/")
        if len(parts) != 3 or parts[1] != self.kind:
            raise JoyTeleopError(
                f"{name}.interface_type must look like PACKAGE/{self.kind}/NAME, not "
                f"'{config['interface_type']}'"
            )
        self.type: Any = get_interface(config["interface_type"])
        self.is_active = False

    def indices(self, key: str) -> list[int]:
        """Return a parameter with numbers of buttons or axes."""
        value = self.config.get(key, [])
        if isinstance(value, (int, float, str)):
            raise JoyTeleopError(f"{self.name}.{key} must be a list, such as [{value}]")
        return [int(index) for index in value]

    def fill(self, message: Any, values: dict[str, Any]) -> None:
        """Set fields of a message.

        Raises:
            JoyTeleopFieldError: The message has no such field, or the value does not fit.
        """
        try:
            set_message_fields(message, values)
        except (AttributeError, TypeError, ValueError) as error:
            raise JoyTeleopFieldError(f"the command '{self.name}': {error}") from error

    def is_pressed(self, joy: Joy) -> bool:
        """Return whether all buttons and axes that the gamepad has are pressed."""
        values = [
            getattr(joy, part)[index] == wanted
            for part, index, wanted in self.conditions
            if index < len(getattr(joy, part))
        ]
        return bool(values) and all(values)

    def accept(self, joy: Joy) -> None:
        """React to a message of the gamepad."""
        was_active, self.is_active = self.is_active, self.is_pressed(joy)
        if self.is_active:
            self.act(joy, is_new=not was_active)

    def act(self, joy: Joy, *, is_new: bool) -> None:
        """Do what the command is for. `is_new` is true only at the begin of a press."""
        raise NotImplementedError


class TopicCommand(Command):
    """Publishes a fixed message once, or a message with values of the gamepad each time."""

    options = ("topic_name",)

    def __init__(self, node: zbot.Node, name: str, config: dict[str, Any]) -> None:
        super().__init__(node, name, config, "deadman_")
        self.mappings = config.get("axis_mappings", {})
        has_value = "message_value" in config
        if has_value == bool(self.mappings):
            start = "Only one of" if has_value else "No"
            end = "can be configured" if has_value else "configured"
            raise JoyTeleopError(
                f"{start} 'message_value' or 'axis_mappings' {end} for command '{name}'"
            )
        for field, mapping in self.mappings.items():
            self.check(field, mapping)
        self.fixed = self.type()
        for field, setting in config.get("message_value", {}).items():
            self.set_field(self.fixed, field, setting.get("value"))
        self.publisher: Any = node.create_publisher(self.type, config["topic_name"], _DEPTH)

    def check(self, field: str, mapping: dict[str, Any]) -> None:
        """Raise an error if a mapping is not complete, or if there is no such field."""
        start = f"Axis mapping for '{self.name}' must have"
        if not {"axis", "button", "value"} & set(mapping):
            raise JoyTeleopError(f"{start} an axis, button, or value")
        for option in ("offset", "scale") if "axis" in mapping else ():
            if option not in mapping:
                raise JoyTeleopError(f"{start} {'an' if option == 'offset' else 'a'} {option}")
        value = 0.0 if {"axis", "button"} & set(mapping) else mapping["value"]
        self.set_field(self.type(), field, value, mapping.get("index", 0))

    def act(self, joy: Joy, *, is_new: bool) -> None:
        """Publish."""
        if not self.mappings and not is_new:
            return
        message = self.type() if self.mappings else self.fixed
        for field, mapping in self.mappings.items():
            self.set_field(message, field, self.value(joy, mapping), mapping.get("index", 0))
        if hasattr(message, "header"):
            message.header.stamp = self.node.get_clock().now().to_msg()
        self.publisher.publish(message)

    def set_field(self, message: Any, path: str, value: Any, index: int = 0) -> None:
        """Set the field of a path such as `twist-linear-x`. In an array, a number is an item.

        Dashes at the end have no meaning: with them, a file can have several items of an array.

        Raises:
            JoyTeleopFieldError: The message has no such field, or the value does not fit.
        """
        *parents, last = path.strip("-").split("-")
        for name in parents:
            message = getattr(message, name, None)
        types: dict[str, str] = getattr(message, "get_fields_and_field_types", dict)()
        if last not in types:
            kind = self.config["interface_type"]
            raise JoyTeleopFieldError(f"the command '{self.name}': {kind} has no field '{path}'")
        is_item = isinstance(value, (int, float)) and types[last].endswith(("]", ">"))
        if is_item:
            items = list(getattr(message, last))
            items += [0] * (index + 1 - len(items))
            is_whole = "int" in types[last]
            items[index] = int(value) if is_whole else float(value)
            value = items
        self.fill(message, {last: value})

    def value(self, joy: Joy, mapping: dict[str, Any]) -> Any:
        """Return the value of a mapping, which is 0 if the gamepad has too few axes or buttons."""
        for key, values in (("axis", joy.axes), ("button", joy.buttons)):
            if key not in mapping:
                continue
            if mapping[key] < len(values):
                found = values[mapping[key]] * mapping.get("scale", 1.0)
                return float(found + mapping.get("offset", 0.0))
            kind = {"axis": "axes", "button": "buttons"}[key]
            self.node.get_logger().error(
                f"Joystick has only {len(values)} {kind} (indexed from 0), but #{mapping[key]} was "
                "referenced in config.",
                throttle_duration_sec=1.0,
            )
            return 0.0
        return mapping["value"]


class ServerCommand(Command):
    """Base class of commands for a server. They act once, or when the server has come."""

    def __init__(self, node: zbot.Node, name: str, config: dict[str, Any]) -> None:
        super().__init__(node, name, config, "")
        self.was_ready = False

    def act(self, joy: Joy, *, is_new: bool) -> None:
        """Send the request if the server is there."""
        del joy
        is_ready = self.is_ready()
        if is_ready and (is_new or not self.was_ready):
            self.send()
        self.was_ready = is_ready

    def is_ready(self) -> bool:
        """Return whether the server is there."""
        raise NotImplementedError

    def send(self) -> None:
        """Send the request."""
        raise NotImplementedError


class ServiceCommand(ServerCommand):
    """Calls a service."""

    kind, options = "srv", ("service_name",)

    def __init__(self, node: zbot.Node, name: str, config: dict[str, Any]) -> None:
        super().__init__(node, name, config)
        self.request = self.type.Request()
        self.fill(self.request, config.get("service_request", {}))
        self.client: Any = node.create_client(self.type, config["service_name"])

    def is_ready(self) -> bool:
        """Return whether the service is there."""
        return bool(self.client.service_is_ready())

    def send(self) -> None:
        """Call the service."""
        self.client.call_async(self.request)


class ActionCommand(ServerCommand):
    """Sends a goal."""

    kind, options = "action", ("action_name",)

    def __init__(self, node: zbot.Node, name: str, config: dict[str, Any]) -> None:
        super().__init__(node, name, config)
        self.goal = self.type.Goal()
        self.fill(self.goal, config.get("action_goal", {}))
        self.client: Any = ActionClient(node, self.type, config["action_name"])

    def is_ready(self) -> bool:
        """Return whether the action server is there."""
        return bool(self.client.server_is_ready())

    def send(self) -> None:
        """Send the goal."""
        self.client.send_goal_async(self.goal)


_KINDS: dict[str, Any] = {
    "topic": TopicCommand,
    "service": ServiceCommand,
    "action": ActionCommand,
}


class JoyTeleop(zbot.Node):
    """Gives each message of the gamepad to the commands in the parameters.

    Args:
        options: The options of `zbot.Node`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__(
            "joy_teleop",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        groups = _nested(
            {name: parameter.value for name, parameter in self.get_parameters_by_prefix("").items()}
        )
        self.commands: list[Command] = []
        for name, config in sorted(groups.items()):
            if not isinstance(config, dict) or name == "qos_overrides":
                continue
            try:
                self.commands.append(self.command(name, config))
            except JoyTeleopFieldError as error:
                self.get_logger().error(f"{error}. The command is left out")
        if not self.commands:
            self.get_logger().warn("There are no commands: give a file by --params-file")
        self.create_subscription(Joy, "joy", self.accept, _DEPTH)

    def command(self, name: str, config: dict[str, Any]) -> Command:
        """Return a command.

        Raises:
            JoyTeleopError: A parameter of the command is missing or cannot be used.
        """
        kind = config.get("type", "")
        if kind not in _KINDS:
            raise JoyTeleopError(
                f"unknown type '{kind}' for command '{name}': use topic, service or action"
            )
        made: Command = _KINDS[kind](self, name, config)
        return made

    def accept(self, joy: Joy) -> None:
        """Give a message of the gamepad to all commands."""
        for command in self.commands:
            command.accept(joy)


def _nested(values: dict[str, Any]) -> dict[str, Any]:
    """Return a nested dictionary for names with dots."""
    nested: dict[str, Any] = {}
    for name, value in values.items():
        *groups, last = name.split(".")
        inner = nested
        for group in groups:
            inner = inner.setdefault(group, {})
        inner[last] = value
    return nested


def main() -> None:
    """Run the node until Ctrl-C."""
    run_node(JoyTeleop)


if __name__ == "__main__":
    main()
