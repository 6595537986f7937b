"""Panel of actions, with a form that sends a goal, and with feedback and result of the goal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.action.goal_state import GoalState
from zbot.errors import ZbotError
from zbot.web.forms.form_view import FormView
from zbot.web.page.command_line import command_line
from zbot.web.page.list_panel import ListPanel
from zbot.web.page.message_view import MessageView
from zbot.web.page.panel import Page, Panel
from zbot.web.page.served_details import ServedDetails, served_columns, served_row
from zbot.web.page.service_call import answer, show_error, with_errors_shown
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.action import ActionClient
    from zbot.graph.snapshot import Snapshot
    from zbot.observer.shared_entities import EntityReference
    from zbot.web.page.panel import Section
    from zbot.web.page.table import Cell

_FEEDBACK_HZ = 15.0
_COLOURS = {
    GoalState.SUCCEEDED: "zb-good",
    GoalState.ABORTED: "zb-bad",
    GoalState.CANCELED: "zb-warn",
}


def _build(page: Page) -> None:
    ListPanel(
        page,
        columns=served_columns("Action"),
        rows=_rows,
        details=_ActionDetails,
        key="action",
        command="zbot action list -t",
        empty="No action yet: start a node, e.g. zbot run fibonacci_action_server",
        hidden="Without a server",
    )


def _rows(graph: Snapshot, hidden: bool) -> dict[str, list[str | Cell]]:
    kinds = () if hidden else (EntityKind.SERVICE,)
    return {
        name: served_row(name, types, graph.on(f"{name}/_action/send_goal", EntityKind.SERVICE))
        for name, types in graph.actions(*kinds)
    }


class _ActionDetails(ServedDetails):
    noun = "action"

    def __init__(self, section: Section, name: str) -> None:
        super().__init__(section, name)
        self.client: EntityReference[ActionClient[Any, Any, Any]] | None = None
        self.goal: Any = None
        self.is_sending = False  #: whether a goal is sent that has no result yet
        self.feedback: Any = None
        self.count = 0

    def served(self, graph: Snapshot) -> list[tuple[str, list[str]]]:
        return graph.actions()

    def fill(self, interface: Any) -> None:
        """Show the inputs, the buttons, and the views for feedback and result."""
        system = self.section.system
        if not system.read_only:
            self.client = self.section.keep(system.action_client(self.name, self.type_name))
        ui.label("Goal").classes("zb-heading")
        self.form = FormView(interface.Goal, self.changed)
        if self.client is None:
            ui.label("This page is read-only.").classes("zb-muted")
            return
        with ui.element("div").classes("zb-row"):
            self.send_button = ui.button("Send goal", on_click=self.send)
            self.send_button.props("unelevated dense")
            self.cancel_button = ui.button("Cancel", on_click=with_errors_shown(self.cancel))
            self.cancel_button.props("outline dense")
            self.state = ui.label().classes("zb-goal-state")
        self.feedback_view = MessageView(self.section, "Feedback")
        self.result_view = MessageView(self.section, "Result")
        self.follow(None)
        self.changed()
        self.section.live(self.update, _FEEDBACK_HZ)

    def changed(self) -> None:
        if self.client is None:
            return
        is_right = not self.form.problems
        self.send_button.set_enabled(is_right and not self.is_sending)
        if is_right:
            words = ["action", "send_goal", "--feedback", self.name, self.type_name]
            self.section.page.show_command(command_line(*words, self.form.yaml()))

    def take(self, feedback: Any) -> None:
        """Keep the feedback. This method runs in the executor's thread, not in NiceGUI's loop."""
        self.feedback = feedback.feedback
        self.count += 1

    def update(self) -> None:
        feedback, self.feedback = self.feedback, None
        if feedback is not None:
            self.feedback_view.show(feedback, f"number {self.count}")

    def follow(self, goal: Any) -> None:
        """Set the active goal. Enable `Cancel` if there is a goal."""
        self.goal = goal
        self.cancel_button.set_enabled(goal is not None)

    async def send(self) -> None:
        if self.client is None or self.form.problems or self.is_sending:
            return
        self.is_sending = True
        self.send_button.set_enabled(False)
        self.count, self.feedback = 0, None
        self.feedback_view.clear()
        self.result_view.clear()
        self.say("sent")
        try:
            await self.run_goal(self.client.entity)
        except ZbotError as error:
            show_error(error)
            self.say("failed", "zb-bad")
            self.result_view.show_error(error)
        finally:
            self.is_sending = False
            self.follow(None)
            self.send_button.set_enabled(not self.form.problems)

    async def run_goal(self, client: ActionClient[Any, Any, Any]) -> None:
        """Send a goal, wait for its result, and show the result."""
        sent = client.send_goal_to_server_async(self.form.message(), self.take)
        goal: Any = await answer(sent, self.name)
        if not goal.accepted:
            self.say("refused", "zb-bad")
            return
        self.follow(goal)
        self.say("accepted")
        outcome: Any = await goal.get_result_async()
        state = GoalState(outcome.status)
        self.update()
        self.say(state.name.lower(), _COLOURS.get(state, ""))
        self.result_view.show(outcome.result)

    async def cancel(self) -> None:
        goal = self.goal
        if goal is None:
            return
        self.cancel_button.set_enabled(False)
        try:
            response: Any = await answer(goal.cancel_goal_async(), self.name)
        except ZbotError:
            self.cancel_button.set_enabled(self.goal is goal)  # the user may try again
            raise
        if not response.goals_canceling:
            self.cancel_button.set_enabled(self.goal is goal)
            ui.notify("The server refused to cancel: the goal goes on.", type="warning")

    def say(self, text: str, classes: str = "") -> None:
        self.state.set_text(text)
        self.state.classes(replace=f"zb-goal-state {classes}")


PANEL = Panel("/actions", "Actions", "flag", _build)
