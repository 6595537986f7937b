"""Card of one sensor: its switch, its topic and its rate."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nicegui import ui

from zbot.errors import ZbotError
from zbot.web.page.command_line import command_line
from zbot.web.panels.sensors.browser_name import frame_of, full_topic
from zbot.web.panels.sensors.sensor_kind import CAMERA, SensorKind
from zbot.web.panels.sensors.sensor_problem import sentence
from zbot.web.panels.sensors.sensor_publisher import SensorPublisher

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.web.page.panel import Page

_WIDTHS = {320: "small", 640: "middle", 1280: "large"}
_FACINGS = {"environment": "back", "user": "front"}
_LEAST_HZ = 0.1
_WAITS = "Waits for the first value of the browser"


class SensorCard:
    """Card of one sensor of one browser.

    Args:
        page: The page.
        kind: The kind of the sensor.
        name: Function that returns the name of the browser.
        on_change: Called when the user has changed a setting.
        may_publish: Function that returns whether the class allows it, as far as this is known.
    """

    def __init__(
        self,
        page: Page,
        kind: SensorKind,
        name: Callable[[], str],
        on_change: Callable[[], None],
        may_publish: Callable[[], bool],
    ) -> None:
        self.kind = kind
        self._page, self._name, self._on_change = page, name, on_change
        self._may_publish = may_publish
        self._publisher: SensorPublisher | None = None
        self._width: ui.select | None = None
        self._facing: ui.select | None = None
        with ui.element("div").classes("zb-card zb-col zb-sensor"):
            self._switch = ui.switch(kind.title, on_change=self._switched).props("dense")
            # iOS asks for the permission only while it handles the click.
            start = f'(isOn) => zbotSensors.change("{kind.key}", isOn)'
            self._switch.on("update:model-value", js_handler=start)
            self._topic = ui.input(value=kind.topic).props("dense outlined debounce=600")
            self._topic.props["aria-label"] = f"Topic of {kind.title}"
            with ui.element("div").classes("zb-row"):
                self._add_options()
            self._said = ui.label().classes("zb-muted").props("role=status")
        # The listeners come last, because the elements are complete now.
        self._topic.on_value_change(self._renamed)

    def _add_options(self) -> None:
        kind = self.kind
        self._rate = ui.number(value=kind.rate_hz, min=_LEAST_HZ, max=kind.most_hz, suffix="Hz")
        self._rate.props("dense outlined debounce=600").classes("zb-short-number")
        self._rate.props["aria-label"] = f"Rate of {kind.title}, Hz"
        self._rate.on_value_change(self.configure)
        if kind is not CAMERA:
            return
        self._width = ui.select(_WIDTHS, value=640, on_change=self.configure)
        self._width.props('dense outlined options-dense aria-label="Size of the pictures"')
        self._facing = ui.select(_FACINGS, value="environment", on_change=self.configure)
        self._facing.props('dense outlined options-dense aria-label="Which camera"')
        ui.element("video").classes("zb-sensor-video").props("muted playsinline hidden").props[
            "aria-label"
        ] = "What the camera sees"

    @property
    def topic(self) -> str:
        """The topic's full name."""
        return full_topic(self._name(), str(self._topic.value or "").strip())

    @property
    def settings(self) -> dict[str, Any]:
        """The settings that the browser keeps."""
        found = {"topic": self._topic.value, "hz": self._rate_hz}
        if self._width is not None and self._facing is not None:
            found |= {"width": self._width.value, "facing": self._facing.value}
        return found

    @property
    def _rate_hz(self) -> float:
        value = self._rate.value
        if not isinstance(value, int | float) or not _LEAST_HZ <= value <= self.kind.most_hz:
            return self.kind.rate_hz
        return float(value)

    def restore(self, kept: Any) -> None:
        """Show settings that the browser kept. Wrong settings are left out."""
        if not isinstance(kept, dict):
            return
        if isinstance(kept.get("topic"), str):
            self._topic.set_value(kept["topic"][:200])
        if isinstance(kept.get("hz"), int | float):
            self._rate.set_value(kept["hz"])
        if self._width is not None and kept.get("width") in _WIDTHS:
            self._width.set_value(kept["width"])
        if self._facing is not None and kept.get("facing") in _FACINGS:
            self._facing.set_value(kept["facing"])

    def configure(self) -> None:
        """Tell the browser the settings. It begins again if the sensor is on."""
        self._page.call("zbotSensors.configure", self.kind.key, self.settings)
        self._on_change()

    def _switched(self) -> None:
        self.suspend()
        self._said.set_text("")
        if self._switch.value:
            self._open()

    def _renamed(self) -> None:
        self._on_change()
        self.reopen()

    def reopen(self) -> None:
        """Publish on the topic's present name, if the sensor is on."""
        self.suspend()
        if self._switch.value:
            self._open()

    def _open(self) -> None:
        if not self._may_publish():
            return
        frame_id = frame_of(self._name(), self.kind)
        try:
            self._publisher = SensorPublisher(self._page.system, self.kind, self.topic, frame_id)
        except ZbotError as error:
            self.refuse(str(error))
            return
        self._page.show_command(command_line("topic", "hz", self.topic))

    def forbid(self, reason: str | None) -> None:
        """Switch the sensor off, and let nobody switch it on. None allows it again."""
        self._switch.set_enabled(reason is None)
        if reason is not None and self.is_on:
            self.refuse(reason)

    def refuse(self, reason: str) -> None:
        """Switch the sensor off, and say why."""
        self.suspend()
        self._page.call("zbotSensors.stop", self.kind.key)
        self._switch.set_value(False)
        self._said.set_text(reason)

    def fail(self, code: Any) -> None:
        """Take a problem of the browser."""
        self.refuse(sentence(self.kind, code))

    def take(self, reading: Any) -> None:
        """Publish a reading of the browser."""
        if not self._switch.value:
            return
        if self._publisher is None:
            self._open()  # the connection is back, or the rule of the class is known
        if self._publisher is not None and isinstance(reading, list):
            self._publisher.take(reading)

    def suspend(self) -> None:
        """Stop publishing until the next reading."""
        publisher, self._publisher = self._publisher, None
        if publisher is not None:
            publisher.release()

    @property
    def is_on(self) -> bool:
        """Whether the user has switched the sensor on."""
        return bool(self._switch.value)

    def show(self) -> None:
        """Show how much was published."""
        if self._publisher is None:
            return
        count = self._publisher.count
        text = f"{count} published, {self._publisher.rate_hz:.1f} Hz" if count else _WAITS
        self._said.set_text(text)
