"""`zbot action echo`: prints the messages between the server and the clients of an action."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.interfaces.plain_value import json_value
from zbot.qos import QoSProfile, qos_profile_action_status_default
from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.kinds import ACTION
from zbot_cli.domain.waiting import wait_for_type
from zbot_cli.errors import CommandError
from zbot_cli.output.listing import print_json
from zbot_cli.output.message_text import event_json, event_text

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot_cli.output.message_text import Form, Formatter

_DEPTH = QoSProfile(depth=100)

#: Topic, type and quality of service of each part of an action, by ros2's name of the part.
#: `{}` is the type of the action.
_PARTS: dict[str, tuple[str, str, QoSProfile]] = {
    "GOAL_SERVICE": ("send_goal/_service_event", "{}_SendGoal_Event", _DEPTH),
    "CANCEL_SERVICE": ("cancel_goal/_service_event", "action_msgs/srv/CancelGoal_Event", _DEPTH),
    "RESULT_SERVICE": ("get_result/_service_event", "{}_GetResult_Event", _DEPTH),
    "FEEDBACK_TOPIC": ("feedback", "{}_FeedbackMessage", _DEPTH),
    "STATUS_TOPIC": (
        "status",
        "action_msgs/msg/GoalStatusArray",
        qos_profile_action_status_default,
    ),
}


class ActionEcho:
    """Printer of an action's feedback and status, and of service events if introspection is on.

    Args:
        name: The action's full name.
        type_word: The action's type, or `None` to take it from the graph.
        interfaces: Names of parts, separated by `|`, or `None` for all parts.
        form: How to show messages.

    Raises:
        CommandError: `interfaces` contains an unknown name, or `type_word` is not the name of an
            action type.
    """

    def __init__(
        self, name: str, type_word: str | None, interfaces: str | None, form: Form
    ) -> None:
        from zbot_cli.output.message_text import Formatter  # noqa: PLC0415 - only echo formats messages

        self._name = name
        self._type = None if type_word is None else ACTION.resolve_type(type_word)
        self._parts = list(_PARTS) if interfaces is None else interfaces.split("|")
        for part in self._parts:
            if part not in _PARTS:
                raise CommandError(
                    f'"{part}" is incorrect interface name.',
                    hint=f"choose from {', '.join(_PARTS)}",
                )
        self._form = form
        self._format: Formatter = Formatter(form)

    def run(self) -> None:
        """Print messages until Ctrl-C."""
        from zbot.runtime import spin  # noqa: PLC0415 - not needed by `list`

        with hidden_node("action_echo") as node:
            type_name = self._type or wait_for_type(node, ACTION, self._name)
            for part in self._parts:
                self._subscribe(node, part, type_name)
            spin(node)

    def _subscribe(self, node: Node, part: str, type_name: str) -> None:
        from zbot.interfaces import get_message  # noqa: PLC0415 - not needed by `list`

        topic, message_type, qos = _PARTS[part]
        subscription = node.create_subscription(
            get_message(message_type.format(type_name)),
            f"{self._name}/_action/{topic}",
            lambda message, info: self._show(part, message, info),
            qos,
        )
        subscription.report_losses_to(_ignore_lost_messages)

    def _show(self, part: str, message: Any, info: Any) -> None:
        is_event = part.endswith("_SERVICE")
        if self._form.json:
            shown = event_json(message) if is_event else json_value(message)
            print_json({"interface": part, "message": shown})
        else:
            text = (
                event_text(message, self._form)
                if is_event and not self._form.csv
                else self._format.text(self._name, message, info)
            )
            sys.stdout.write(f"interface: {part}\n{text}")
        sys.stdout.flush()


def _ignore_lost_messages(missing: int) -> None:
    return
