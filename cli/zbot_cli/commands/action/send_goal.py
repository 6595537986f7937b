"""`zbot action send_goal`: sends one goal, and prints its feedback and result."""

from __future__ import annotations

import sys
from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.threads.deadline import Deadline
from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.kinds import ACTION
from zbot_cli.domain.waiting import (
    HINT_DELAY_S,
    print_hint_if_not_listed,
    print_no_server,
    wait_for_server,
)
from zbot_cli.errors import CommandError
from zbot_cli.input.message_values import PopulateError, Template
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import print_json

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.action import ActionClient, ClientGoalHandle
    from zbot.executor.task import Future
    from zbot.node.node import Node


def no_action_server_error(name: str, timeout_s: float, hint: str | None) -> CommandError:
    """Return the error that no server appeared in time."""
    return CommandError(
        f"The action server {name} is not available after waiting {timeout_s:g} seconds", hint=hint
    )


def goal_values_error(error: PopulateError) -> CommandError:
    """Return the error that the values on the command line do not fit the goal."""
    hint = error.hint
    reason = str(error).removeprefix("Failed to populate field: ")
    return CommandError(f"Failed to populate message fields: {reason}", hint=hint)


class SendGoal:
    """Client that waits for a server, sends a goal, and waits for its result.

    Args:
        name: The action's full name.
        words: A type and values. The type may be left out if the action has a server.
        with_feedback: Print feedback.
        timeout_s: Seconds to wait for a server, or `None` for no limit.
        stdin: Read the values from standard input.
        goal_file: Read the values from a file.
        as_json: Print one JSON document for each event.
    """

    def __init__(
        self,
        name: str,
        words: Sequence[str],
        *,
        with_feedback: bool,
        timeout_s: float | None,
        stdin: bool,
        goal_file: str | None,
        as_json: bool,
    ) -> None:
        self._name = name
        self._type, self._values = ACTION.split(words)
        self._with_feedback = with_feedback
        self._timeout_s = timeout_s
        self._as_json = as_json
        self._is_accepted = False
        self._early: list[Any] = []  # feedback that arrived before the response to the goal
        if stdin:
            self._values = [sys.stdin.read()]
        elif goal_file is not None:
            from zbot_cli.commands.topic.pub import read_values  # noqa: PLC0415 - seldom used

            self._values = [read_values(goal_file)]

    def run(self) -> Status:
        """Send the goal. Return the exit code of the command.

        Raises:
            CommandError: No server appeared in time, or the values do not fit the goal, or the
                server did not accept the request to cancel the goal.
            ServiceError: The server ended before the goal ended.
        """
        import zbot  # noqa: F401, PLC0415 - makes the message packages importable

        template = None if self._type is None else self._template(self._type)
        deadline = Deadline(self._timeout_s)
        with hidden_node("send_goal", survives_ctrl_c=True) as node:
            self._node = node
            self._print_text("Waiting for an action server to become available...")
            if self._timeout_s is None:
                print_hint_if_not_listed(ACTION, node.context.graph.snapshot(), self._name)
            if template is None:
                self._type = self._wait_for_type(deadline)
                template = self._template(self._type)
            client = self._client(node)
            if not self._wait_for_server(client, deadline):
                if deadline.is_over:
                    raise self._no_server()
                return Status.ERROR  # a signal ended the wait
            return self._run_goal(client, template.make(lambda: node.get_clock().now().nanoseconds))

    def _template(self, type_name: str) -> Template:
        try:
            return Template(ACTION.values_class(type_name), self._values)
        except PopulateError as error:
            raise goal_values_error(error) from None

    def _client(self, node: Node) -> ActionClient[Any, Any, Any]:
        from zbot.action import ActionClient  # noqa: PLC0415 - not needed by `list`

        return ActionClient(node, ACTION.class_of(self._type or ""), self._name)

    def _wait_for_type(self, deadline: Deadline) -> str:
        find = partial(ACTION.only_type, name=self._name)
        found = wait_for_server(self._node, ACTION, self._name, find, deadline)
        if found is None:
            raise self._no_server()
        return found

    def _wait_for_server(self, client: ActionClient[Any, Any, Any], deadline: Deadline) -> bool:
        if client.wait_for_server(min(deadline.left_s, HINT_DELAY_S)):
            return True
        if not deadline.is_over and self._node.context.ok():
            print_no_server(ACTION, self._node.context.graph.snapshot(), self._name)
        return client.wait_for_server(deadline.left_s)

    def _no_server(self) -> CommandError:
        hint = ACTION.suggestion(self._node.context.graph.snapshot(), self._name)
        return no_action_server_error(self._name, self._timeout_s or 0, hint)

    # -- the goal ------------------------------------------------------------------------------

    def _run_goal(self, client: ActionClient[Any, Any, Any], goal: Any) -> Status:
        self._print_text(f"Sending goal:\n     {_text(goal)}")
        callback = self._show_feedback if self._with_feedback else None
        handle = self._wait(client.send_goal_async(goal, callback))
        if not handle.accepted:
            self._show("Goal was rejected.", {"accepted": False})
            return Status.ERROR
        try:
            self._show_acceptance(handle.key.hex())
            return self._end(self._wait(handle.get_result_async()))
        except KeyboardInterrupt:
            self._cancel(handle)
            self._end(self._wait(handle.get_result_async()))
            return Status.INTERRUPTED

    def _show_acceptance(self, goal_id: str) -> None:
        self._show(f"Goal accepted with ID: {goal_id}\n", {"accepted": True, "goal_id": goal_id})
        self._is_accepted = True
        for message in self._early:
            self._show_feedback(message)

    def _cancel(self, handle: ClientGoalHandle[Any, Any, Any]) -> None:
        self._print_text("Canceling goal...")
        response = self._wait(handle.cancel_goal_async())
        if not response.goals_canceling:
            raise CommandError(
                "Failed to cancel goal",
                hint="its server has no cancel_callback that accepts, or the goal has just ended",
            )
        self._print_text("Goal canceled.")

    def _end(self, response: Any) -> Status:
        from zbot.action import GoalState  # noqa: PLC0415 - not needed by `list`

        state = GoalState(response.status)
        self._show(
            f"Result:\n    {_text(response.result)}\nGoal finished with status: {state.name}",
            {"result": response.result, "status": state.name},
        )
        return Status.OK if state is GoalState.SUCCEEDED else Status.ERROR

    def _wait(self, future: Future[Any]) -> Any:
        from zbot.runtime import spin_until_future_complete  # noqa: PLC0415 - not needed by `list`

        spin_until_future_complete(self._node, future)
        return future.result()

    # -- output --------------------------------------------------------------------------------

    def _show_feedback(self, message: Any) -> None:
        if not self._is_accepted:
            self._early.append(message)
            return
        self._show(f"Feedback:\n    {_text(message.feedback)}", {"feedback": message.feedback})

    def _print_text(self, text: str) -> None:
        if not self._as_json:
            print(text, flush=True)

    def _show(self, text: str, facts: dict[str, Any]) -> None:
        if self._as_json:
            from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - seldom used

            print_json({name: json_value(value) for name, value in facts.items()})
            sys.stdout.flush()
        else:
            print(text, flush=True)


def _text(message: Any) -> str:
    from zbot.interfaces.plain_value import plain  # noqa: PLC0415 - needed only to send a goal
    from zbot.interfaces.yaml_text import dump  # noqa: PLC0415 - as above

    return dump(_as_block_lists(plain(message)))


def _as_block_lists(value: Any) -> Any:
    """Return values whose lists are printed with one item per line, as ros2 prints lists."""
    if isinstance(value, dict):
        return {name: _as_block_lists(item) for name, item in value.items()}
    return [_as_block_lists(item) for item in value] if isinstance(value, list) else value
