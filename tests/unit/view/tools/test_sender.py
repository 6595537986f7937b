"""Goals are published, and sent to a navigation that does not listen to the topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionServer
from zbot.executor.spin_thread import SpinThread
from zbot.observer.system import System
from zbot.view.tools.sender import Sender

from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateToPose

if TYPE_CHECKING:
    from tests.conftest import MakeContext

TYPE = "geometry_msgs/msg/PoseStamped"


@pytest.mark.parametrize("listens", [False, True])
def test_a_navigation_gets_a_goal_once(make_context: MakeContext, listens: bool) -> None:
    context = make_context()
    node = zbot.Node("navigator", context=context)
    goals: list[Any] = []
    published: list[Any] = []

    def execute(handle: Any) -> Any:
        goals.append(handle.request.pose)
        handle.succeed()
        return NavigateToPose.Result()

    server = ActionServer(node, NavigateToPose, "navigate_to_pose", execute)
    if listens:
        node.create_subscription(PoseStamped, "goal_pose", published.append, 10)
    pose = PoseStamped()
    pose.pose.position.x = 2.0
    spinner = SpinThread(node, "test")
    with System(domain_id=context.get_domain_id()) as system:
        assert wait_until(lambda: any(system.snapshot().actions()), 10)
        sender = Sender(system)
        sender.open("/goal_pose", TYPE)
        assert wait_until(
            lambda: bool(system.snapshot().subscriptions("/goal_pose")) is listens, 10
        )
        assert sender.send("/goal_pose", TYPE, pose) == int(listens)
        assert sender.navigate(pose, "/goal_pose") == ([] if listens else ["/navigate_to_pose"])
        assert wait_until(lambda: len(published if listens else goals) == 1, 10)
    assert (goals, published) == (([], [pose]) if listens else ([pose], []))
    spinner.stop()
    server.destroy()
