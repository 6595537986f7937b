"""A browser keeps its name while it sends readings."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.panels.sensors.browser_name import free_name
from zbot.web.panels.sensors.panel import SensorsPanel


class FakeCard:
    """Card of a sensor that publishes nothing."""

    kind = SimpleNamespace(key="camera")

    def take(self, reading: Any) -> None: ...

    def suspend(self) -> None: ...


class FakeSystem:
    """System without nodes."""

    @staticmethod
    def snapshot() -> Any:
        return SimpleNamespace(of_kind=lambda *_: ())


def test_the_name_is_held_again_after_a_short_loss_of_the_connection() -> None:
    system: Any = FakeSystem()
    panel: Any = object.__new__(SensorsPanel)
    panel._page = SimpleNamespace(system=system, call=lambda *_: None)
    panel._name = SimpleNamespace(value="phone")
    panel._cards = {"camera": FakeCard()}
    panel._suspend()
    assert free_name(system, "phone") == "phone"
    panel._take(["camera", 1, None])
    assert free_name(system, "phone") != "phone"
