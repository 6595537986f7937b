"""Test of `zbot doctor` in a domain with many topics."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.unit.tokens import endpoint_token
from zbot.errors import suggestion
from zbot.graph.snapshot import Snapshot
from zbot.wire.tokens import EntityKind
from zbot_cli.commands import doctor

if TYPE_CHECKING:
    import pytest

ROBOTS = 50


def test_published_names_are_prepared_once_for_all_topics(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    prepared: list[str] = []
    letters = suggestion._letters

    def counted(name: str) -> frozenset[str]:
        prepared.append(name)
        return letters(name)

    monkeypatch.setattr(suggestion, "_letters", counted)
    kinds = {"scan": EntityKind.PUBLISHER, "scam": EntityKind.SUBSCRIPTION}
    graph = Snapshot(
        tuple(
            endpoint_token(f"/robot{number}/{name}", kind=kind)
            for number in range(ROBOTS)
            for name, kind in kinds.items()
        )
    )
    found = list(doctor._lonely_subscriptions(graph))
    assert found[0].text == "/robot0/scam has no publisher"
    assert len(found) == ROBOTS
    assert len(prepared) < ROBOTS * 10
