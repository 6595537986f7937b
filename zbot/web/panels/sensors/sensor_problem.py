"""Sentences that say why a sensor of a browser does not work."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from zbot.web.panels.sensors.sensor_kind import SensorKind

INSECURE = (
    "Browsers give sensors only to pages with https and to pages of their own machine. Type "
    "`zbot web --https`, and open the address that it prints."
)
READ_ONLY = "This page is read-only: it cannot publish."
_SENTENCES = {
    "insecure": INSECURE,
    "denied": "You did not allow it. Allow the {what} for this page in the browser's settings.",
    "absent": "This device has no {what}, or the browser does not know it.",
    "busy": "Another program uses the {what}. Close it, and try again.",
    "unsupported": "This browser has no function for the {what}.",
    "silent": "The browser gives no values: this device may have no such sensor.",
    "ended": "The browser has stopped the {what}.",
    "large": "The pictures are too large. Choose a smaller size.",
}
_NAMES = {
    "camera": "camera",
    "microphone": "microphone",
    "motion": "motion sensor",
    "position": "position",
}


def sentence(kind: SensorKind, code: Any) -> str:
    """Return the sentence about a code of `sensors.js`."""
    text = _SENTENCES.get(str(code), "The browser refuses it.")
    return text.format(what=_NAMES[kind.key])


def taken_topic(topic: str) -> str:
    """Return the sentence that another browser publishes a topic."""
    return f"Another browser publishes {topic}. Choose another name."
