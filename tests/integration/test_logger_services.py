"""Tests of the services that read and set the levels of a node's loggers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import zbot
from zbot.log import LoggingSeverity, clear_config, get_logger_level

from rcl_interfaces.msg import LoggerLevel
from rcl_interfaces.srv import GetLoggerLevels, SetLoggerLevels

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin


def test_levels_can_be_set_and_read(make_context: MakeContext, spin: Spin) -> None:
    node = zbot.Node("talkative", context=make_context(), enable_logger_service=True)
    spin(node)
    setting = node.create_client(SetLoggerLevels, "talkative/set_logger_levels")
    levels = [LoggerLevel(name="a.b", level=10), LoggerLevel(name="a.c", level=11)]
    try:
        results = setting.call(SetLoggerLevels.Request(levels=levels)).results
        assert [result.successful for result in results] == [True, False]
        reasons = [result.reason for result in results]
        assert reasons == ["", "Failed reason: Invalid logger level."]
        assert get_logger_level("a.b") is LoggingSeverity.DEBUG
        asking = node.create_client(GetLoggerLevels, "talkative/get_logger_levels")
        levels = asking.call(GetLoggerLevels.Request(names=["a.b", "nobody"])).levels
        assert [(level.name, level.level) for level in levels] == [("a.b", 10), ("nobody", 0)]
    finally:
        clear_config()


def test_other_nodes_have_no_such_services(make_context: MakeContext) -> None:
    node = zbot.Node("quiet", context=make_context())
    names = [name for name, _ in node.get_service_names_and_types_by_node("quiet", "/")]
    assert not [name for name in names if "logger_levels" in name]
