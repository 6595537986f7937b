"""Topics and services of types that are found only later are shown then."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from zbot.interfaces import get_interface
from zbot.remote.types import UnknownTypeError
from zbot.web.foxglove import type_search
from zbot.web.foxglove.channels import Channels
from zbot.web.foxglove.services import Services
from zbot.web.foxglove.type_search import TypeSearch

if TYPE_CHECKING:
    from zbot.log.record import Record

GRAPH: Any = SimpleNamespace(
    topics=lambda: [("/lamp", ["std_msgs/msg/String"])],
    services=lambda: [("/switch", ["std_srvs/srv/SetBool"])],
)


def test_what_is_found_late_is_shown(monkeypatch: pytest.MonkeyPatch, logged: list[Record]) -> None:
    foxglove = pytest.importorskip("foxglove", reason="pip install foxglove-sdk")
    answers: list[str] = []
    offered: list[Any] = []

    def find(name: str) -> Any:
        if not answers:
            raise UnknownTypeError(name)
        return get_interface(name)

    monkeypatch.setattr(type_search, "_FIRST_PAUSE_S", 0.0)
    system: Any = SimpleNamespace()
    types = TypeSearch(find)
    channels = Channels(system, foxglove.Context(), types)
    services = Services(system, SimpleNamespace(add_services=offered.extend), types)
    for _ in range(2):
        channels.update(GRAPH)
        services.update(GRAPH)
    first, second = (record.message for record in logged)
    assert first.startswith("/lamp is not shown: no definition of std_msgs/msg/String was found")
    assert second.startswith("/switch cannot be called: no definition of std_srvs/srv/SetBool")
    answers.append("a node answers now")
    channels.update(GRAPH)
    services.update(GRAPH)
    assert list(channels._topics) == ["/lamp"]
    assert [service.name for service in offered] == ["/switch"]
