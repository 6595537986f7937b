"""Tests of timers of launch files in simulated time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.launch import LaunchDescription, LaunchService
from zbot.launch.actions import (
    GroupAction,
    RegisterEventHandler,
    RosTimer,
    SetParameter,
    SetUseSimTime,
    Shutdown,
    TimerAction,
)
from zbot.launch.event_handler import OnShutdown

from rosgraph_msgs.msg import Clock

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


_HOUR_S = 3600
_PATIENCE_S = 15.0


def _timer() -> RosTimer:
    return RosTimer(period=_HOUR_S, actions=[Shutdown(reason="an hour")])


@pytest.mark.parametrize(
    "describe",
    [
        lambda: [SetUseSimTime(True), _timer()],
        lambda: [_timer(), SetUseSimTime(True)],
        lambda: [GroupAction([SetParameter("use_sim_time", True), _timer()])],
    ],
)
def test_timers_follow_simulated_time(
    describe: Callable[[], list[Any]],
    make_context: Callable[[], zbot.Context],
    spin: Callable[..., object],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path))
    node = zbot.Node("simulator", context=make_context())
    publisher = node.create_publisher(Clock, "/clock", 1)
    time = Clock()

    def step() -> None:
        time.clock.sec += _HOUR_S // 4
        publisher.publish(time)

    node.create_timer(0.02, step)
    spin(node)
    ended: list[str] = []
    too_late = TimerAction(period=_PATIENCE_S, actions=[Shutdown(reason="no hour has passed")])
    service = LaunchService(noninteractive=True)
    handler = OnShutdown(on_shutdown=lambda event, _: ended.append(event.reason))
    entities = [RegisterEventHandler(handler), *describe(), too_late]
    service.include_launch_description(LaunchDescription(entities))
    assert service.run() == 0
    assert ended == ["an hour"]
