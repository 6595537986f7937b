"""Tests of the opening of Zenoh sessions."""

from __future__ import annotations

import pytest
import zenoh

from zbot.transport import zenoh_session

SHARED_MEMORY = "transport/shared_memory/enabled"


def config_with_shared_memory(word: str) -> zenoh.Config:
    config: zenoh.Config = zenoh.Config()
    config.insert_json5(SHARED_MEMORY, word)
    return config


@pytest.mark.parametrize(
    ("opened", "given", "expected"),
    [(0, "true", True), (49, "true", True), (50, "true", False), (0, "false", False)],
)
def test_the_first_sessions_of_a_process_share_memory(
    opened: int, given: str, expected: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(zenoh_session._Library, "opened", opened)
    config = config_with_shared_memory(given)
    assert zenoh_session.shares_memory(config) is expected


def test_each_session_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(zenoh_session._Library, "opened", 49)
    config = config_with_shared_memory("true")
    config.insert_json5("listen/endpoints", "[]")
    config.insert_json5("scouting/multicast/enabled", "false")
    zenoh_session.open_session("the 50th session", config).close()
    assert config.get_json(SHARED_MEMORY) == "true"
    assert not zenoh_session.shares_memory(config)
    zenoh_session.open_session("the 51st session", config).close()
    assert config.get_json(SHARED_MEMORY) == "false"
