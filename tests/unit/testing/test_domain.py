"""Tests of the domain of a test."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING

from zbot.package.user_folders import definitions_folder
from zbot.testing.domain import isolate, reserved_domain
from zbot.transport import config, membership

if TYPE_CHECKING:
    from pathlib import Path

    import pytest


def test_each_reserved_domain_is_another_one() -> None:
    with reserved_domain() as first, reserved_domain() as second, reserved_domain() as third:
        assert len({first, second, third}) == 3


def test_a_domain_with_a_router_is_not_reserved(monkeypatch: pytest.MonkeyPatch) -> None:
    with reserved_domain() as first, reserved_domain() as used:
        taken = {config.MEETING_PORT + first}
        monkeypatch.setattr("zbot.testing.domain._is_free", lambda port: port not in taken)
        monkeypatch.setattr("time.monotonic_ns", lambda: (first - 1) * 1000)
        with reserved_domain() as other:
            assert other not in {first, used}


def test_a_test_is_in_its_domain_whatever_the_environment_says(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("ZBOT_COMMAND_DOMAIN", "3")
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")
    isolate(monkeypatch, 57, tmp_path)
    assert config.domain_id() == 57
    assert os.environ["ROS_DOMAIN_ID"] == "57"
    assert config.discovery_range() is config.DiscoveryRange.LOCALHOST


def test_a_test_leaves_the_class_and_keeps_added_definitions(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    added = definitions_folder() / "arm_msgs" / "msg" / "Grip.msg"
    added.parent.mkdir(parents=True)
    added.write_text("float64 force\n")
    joined = {"role": "student", "host": "10.0.0.1", "port": 7447, "number": 5}
    (membership.folder() / membership.FILE).write_text(json.dumps(joined))
    assert config.domain_id() == 5
    isolate(monkeypatch, 57, tmp_path)
    assert membership.load() is None
    assert config.domain_id() == 57
    assert (definitions_folder() / "arm_msgs" / "msg" / "Grip.msg").is_file()
