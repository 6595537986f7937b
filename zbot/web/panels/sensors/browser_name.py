"""Name of a browser, below which it publishes its sensors."""

from __future__ import annotations

import itertools
import re
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.observer.system import System
    from zbot.web.panels.sensors.sensor_kind import SensorKind

_NOT_IN_FRAMES = re.compile(r"\W", re.ASCII)
#: The names of the browsers that show the panel now, by any object that stands for a browser.
_NAMES: WeakKeyDictionary[System, dict[object, str]] = WeakKeyDictionary()


def usual_name(user_agent: str) -> str:
    """Return `phone` or `laptop`, from the text with which a browser describes itself."""
    return "phone" if re.search("Mobi|Android|iPhone|iPad", user_agent) else "laptop"


def free_name(system: System, usual: str) -> str:
    """Return a name that nobody uses: `phone`, or else `phone_2` and so on."""
    topics = {end.name for end in system.snapshot().of_kind(EntityKind.PUBLISHER)}
    taken = {topic.split("/")[1] for topic in topics if topic.startswith("/")}
    taken.update(_NAMES.get(system, {}).values())
    names = itertools.chain([usual], (f"{usual}_{number}" for number in itertools.count(2)))
    return next(name for name in names if name not in taken)


def hold_name(system: System, browser: object, name: str) -> None:
    """Note that a browser uses a name, so that the next browser gets another one."""
    _NAMES.setdefault(system, {})[browser] = name.strip("/")


def drop_name(system: System, browser: object) -> None:
    """Note that a browser has closed its panel. A second call does nothing."""
    _NAMES.get(system, {}).pop(browser, None)


def full_topic(name: str, topic: str) -> str:
    """Return the full name of a topic, which may be relative to the name of a browser."""
    return topic if topic.startswith("/") else f"/{name.strip('/')}/{topic}"


def frame_of(name: str, kind: SensorKind) -> str:
    """Return the frame of a sensor, e.g. `phone_imu`."""
    return f"{_NOT_IN_FRAMES.sub('_', name.strip('/'))}_{kind.frame}"
