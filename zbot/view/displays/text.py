"""Display Text: the value of a sensor as a line of text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.view.displays.display import Display
from zbot.view.shape import Item, Note

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.view.shape import Shape

_TEXTS: dict[str, Callable[[Any], str]] = {
    "Temperature": lambda message: f"{message.temperature:.2f} °C",
    "RelativeHumidity": lambda message: f"{100 * message.relative_humidity:.1f} %",
    "Illuminance": lambda message: f"{message.illuminance:.1f} lx",
    "FluidPressure": lambda message: f"{message.fluid_pressure:.1f} Pa",
    "BatteryState": lambda message: f"{message.voltage:.2f} V, {100 * message.percentage:.0f} %",
    "NavSatFix": lambda message: (
        f"{message.latitude:.6f}°, {message.longitude:.6f}°, {message.altitude:.1f} m"
    ),
}


class Text(Display):
    """Value of a sensor beside the scene."""

    name = "Text"
    types = tuple(f"sensor_msgs/msg/{name}" for name in _TEXTS)

    def take(self, message: Any) -> None:
        """Show a value."""
        self.items = {"": Item("", 0, tuple(self.shapes(message)))}

    def shapes(self, message: Any) -> list[Shape]:
        """Return the line of text."""
        return [Note(_TEXTS[type(message).__name__](message))]
