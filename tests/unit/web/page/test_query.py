"""Test of the parameters of a page's address."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')

from zbot.web.page.panel import Page


def test_a_parameter_of_the_address_may_have_any_name() -> None:
    page: Any = object.__new__(Page)
    calls: list[tuple[Any, ...]] = []
    page.call = lambda *arguments: calls.append(arguments)
    page.set_query(self="1", node="/a")
    assert page.query == {"self": "1", "node": "/a"}
    assert calls == [("zbot.setQuery", page.query)]
