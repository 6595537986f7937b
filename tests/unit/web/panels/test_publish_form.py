"""The form that publishes is made in the details of its topic."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.panels.topics import publish_form

if TYPE_CHECKING:
    from collections.abc import Callable


class FakeExpansion:
    """Element that knows whether new elements come into it."""

    is_open = False

    def __enter__(self) -> None:
        self.is_open = True

    def __exit__(self, *_: object) -> None:
        self.is_open = False

    def classes(self, _: str) -> FakeExpansion:
        return self

    def props(self, _: str) -> FakeExpansion:
        return self


def test_the_wait_for_the_type_ends_with_the_details(monkeypatch: pytest.MonkeyPatch) -> None:
    expansion = FakeExpansion()
    places: list[bool] = []
    looks: list[Callable[[], None]] = []

    def live(look: Callable[[], None], _hz: float) -> Callable[[], None]:
        looks.append(look)
        return lambda: None

    fake = SimpleNamespace(
        expansion=lambda *_, **__: expansion,
        timer=lambda *_, **__: places.append(expansion.is_open),
    )
    monkeypatch.setattr(publish_form, "ui", fake)
    graph = SimpleNamespace(publishers=lambda _: ())
    section: Any = SimpleNamespace(live=live, system=SimpleNamespace(snapshot=lambda: graph))
    watch: Any = SimpleNamespace(topic="/chatter", type_name="std_msgs/msg/String")
    publish_form.add_publish_form(section, watch)
    looks[0]()
    assert places == [True]
