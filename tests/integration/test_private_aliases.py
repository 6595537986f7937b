"""Tests of private names of rclpy's nodes that programs use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot

from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext

MAKE: dict[str, Callable[[zbot.Node], Any]] = {
    "publishers": lambda node: node.create_publisher(String, "chatter", 1),
    "subscriptions": lambda node: node.create_subscription(String, "chatter", print, 1),
    "services": lambda node: node.create_service(Trigger, "go", lambda _, response: response),
    "clients": lambda node: node.create_client(Trigger, "go"),
    "timers": lambda node: node.create_timer(1.0, print),
    "guards": lambda node: node.create_guard_condition(print),
}


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("insider", context=make_context())


def test_logger_clock_and_context_have_private_names(node: zbot.Node) -> None:
    assert node._logger is node.get_logger()
    assert node._clock is node.get_clock()
    assert node._context is node.context


@pytest.mark.parametrize("kind", MAKE)
def test_lists_of_entities_have_private_names(node: zbot.Node, kind: str) -> None:
    made = MAKE[kind](node)
    assert getattr(node, f"_{kind}")[-1] is made
    assert list(getattr(node, kind))[-1] is made


def test_a_program_may_assign_the_private_names(make_context: MakeContext) -> None:
    class Mine(zbot.Node):
        def __init__(self) -> None:
            self._timers: dict[str, zbot.Timer] = {}
            super().__init__("mine", context=make_context())
            self._logger = self._logger.get_child("part")
            self._timers["one"] = self.create_timer(1.0, print)

    mine = Mine()
    assert mine._logger.name == "mine.part"
    assert mine._timers == {"one": next(mine.timers)}


@pytest.mark.parametrize("kind", MAKE)
def test_the_default_group_can_be_assigned(node: zbot.Node, kind: str) -> None:
    group = node._default_callback_group = zbot.ReentrantCallbackGroup()
    assert MAKE[kind](node).callback_group is group
    assert node.default_callback_group is group


def test_the_default_group_can_be_overridden_by_a_property(make_context: MakeContext) -> None:
    class Free(zbot.Node):
        @property
        def default_callback_group(self) -> zbot.CallbackGroup:
            return zbot.ReentrantCallbackGroup()

    free = Free("free", context=make_context())
    assert isinstance(MAKE["timers"](free).callback_group, zbot.ReentrantCallbackGroup)
