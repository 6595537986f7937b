"""Panel that publishes the sensors of the browser."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from nicegui import background_tasks, ui

from zbot.classroom.sensor_rule import sensors_refusal
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import run_in_thread
from zbot.web.panels.sensors.browser_name import drop_name, free_name, hold_name, usual_name
from zbot.web.panels.sensors.phone_invitation import add_phone_invitation
from zbot.web.panels.sensors.sensor_card import SensorCard
from zbot.web.panels.sensors.sensor_kind import KINDS
from zbot.web.panels.sensors.sensor_problem import INSECURE, READ_ONLY

if TYPE_CHECKING:
    from collections.abc import Sequence

_HZ = 2.0
_RULE_S = 3.0  # time between two questions to the class
_HINT = (
    "The sensors of this browser become topics while this page is open. Each browser has a name "
    "of its own, which is the first part of its topics."
)


class SensorsPanel:
    """Panel of one browser.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        page.show_command(command_line("topic", "list", "-t"))
        self._said = ui.label(READ_ONLY if page.read_only else _HINT).classes("zb-muted")
        self._warning = ui.label(INSECURE).classes("zb-warn")
        self._warning.set_visibility(False)
        if page.read_only:
            return
        agent = page.user_agent
        self._name = ui.input("Name", value=free_name(page.system, usual_name(agent)))
        self._name.props("dense outlined debounce=600").classes("zb-sensors-name")
        with ui.element("div").classes("zb-sensors"):
            cards = [
                SensorCard(page, kind, self._get_name, self._keep, self._may_publish)
                for kind in KINDS
            ]
        add_phone_invitation(page)
        self._cards = {card.kind.key: card for card in cards}
        self._name.on_value_change(self._renamed)
        self._is_restoring = False
        self._rule: str | None = ""  # why the class forbids it; empty until the class has answered
        self._hold_name()
        ui.on("zbot_sensors", lambda event: self._begin(event.args))
        ui.on("zbot_sensor", lambda event: self._take(event.args))
        ui.on("zbot_sensor_problem", lambda event: self._fail(event.args))
        ui.context.client.on_disconnect(self._suspend)
        page.on_close(self._suspend)
        page.live(self._show, _HZ)
        page.call("zbotSensors.begin")
        watching = background_tasks.create(self._watch_rule(), name="zbot sensors")
        page.on_close(watching.cancel)

    def _may_publish(self) -> bool:
        return self._rule is None

    async def _watch_rule(self) -> None:
        """Ask the class again and again whether it allows sensors."""
        while True:
            self._follow(await run_in_thread(sensors_refusal))
            await asyncio.sleep(_RULE_S)

    def _follow(self, rule: str | None) -> None:
        if rule == self._rule:
            return
        self._rule = rule
        self._said.set_text(rule or _HINT)
        for card in self._cards.values():
            card.forbid(rule)

    def _get_name(self) -> str:
        return str(self._name.value or "").strip()

    def _hold_name(self) -> None:
        hold_name(self._page.system, self, self._get_name())

    def _begin(self, words: Any) -> None:
        """Show the settings that the browser kept, and tell it all settings."""
        is_secure, kept = words if isinstance(words, list) and len(words) == 2 else (True, None)
        self._warning.set_visibility(not is_secure)
        self._is_restoring = True  # the settings are told to the browser once, at the end
        if isinstance(kept, dict):
            if isinstance(kept.get("name"), str):
                self._name.set_value(kept["name"][:100])
            for key, card in self._cards.items():
                card.restore(kept.get(key))
        for card in self._cards.values():
            card.configure()
        self._is_restoring = False
        self._keep()  # after a reload, the browser has the same name again

    def _take(self, words: Any) -> None:
        key, number, reading = _words(words, 3)
        card = self._cards.get(str(key))
        if card is not None:
            self._hold_name()  # a short loss of the connection has dropped it
            card.take(reading)
            self._page.call("zbotSensors.taken", card.kind.key, number)

    def _fail(self, words: Any) -> None:
        key, code = _words(words, 2)
        card = self._cards.get(str(key))
        if card is not None:
            card.fail(code)

    def _renamed(self) -> None:
        self._hold_name()
        self._keep()
        for card in self._cards.values():
            card.reopen()

    def _keep(self) -> None:
        if self._is_restoring:
            return
        settings = {key: card.settings for key, card in self._cards.items()}
        self._page.call("zbotSensors.keep", {"name": self._get_name(), **settings})

    def _suspend(self) -> None:
        """Stop publishing: the browser is gone, or has lost its connection for a moment."""
        drop_name(self._page.system, self)
        for card in self._cards.values():
            card.suspend()

    def _show(self) -> None:
        for card in self._cards.values():
            card.show()


def _words(words: Any, count: int) -> Sequence[Any]:
    """Return the words of a browser, or as many None if a browser sent something else."""
    return words if isinstance(words, list) and len(words) == count else [None] * count


def _build(page: Page) -> None:
    SensorsPanel(page)


PANEL = Panel("/sensors", "Sensors", "sensors", _build)
