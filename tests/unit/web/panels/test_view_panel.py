"""The view of a page is opened and released once, however often its user clicks."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.observer.errors import ViewerError
from zbot.web.panels.view import panel


def test_a_second_click_does_not_start_the_view_again(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[Any] = []
    tasks = SimpleNamespace(create=lambda coroutine, **_: started.append(coroutine))
    monkeypatch.setattr(panel, "background_tasks", tasks)
    view = object.__new__(panel._View)
    view.page = SimpleNamespace(server=SimpleNamespace(scheme="http"))  # type: ignore[assignment]
    view.is_starting = False
    monkeypatch.setattr(view, "say", lambda *_, **__: None)
    monkeypatch.setattr(view, "open", _fail)
    view.view = None
    view.start()
    view.start()
    assert len(started) == 1
    asyncio.run(started.pop())
    view.start()
    assert len(started) == 1
    started.pop().close()


async def _fail() -> None:
    raise ViewerError("there is no class")
