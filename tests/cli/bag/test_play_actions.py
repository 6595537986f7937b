"""Tests of `zbot bag play --send-actions-as-client`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import zbot as library
from tests.conftest import wait_until
from zbot.action import ActionServer, CancelResponse, ServerGoalHandle
from zbot.bag import Writer

from action_msgs.msg import GoalInfo, GoalStatusArray
from action_msgs.srv import CancelGoal
from example_interfaces.action import Fibonacci
from unique_identifier_msgs.msg import UUID

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start

Goal = ServerGoalHandle[Any, Any, Any]
RECORDED = UUID(uuid=list(range(16)))


class Counter:
    """Server that counts until its goals are cancelled."""

    def __init__(self, node: library.Node) -> None:
        self.goals: list[tuple[int, bytes]] = []
        self.cancelled: list[bytes] = []
        self._stops: dict[bytes, library.Future[None]] = {}
        ActionServer[Any, Any, Any](
            node,
            Fibonacci,
            "fib",
            self._count,
            handle_accepted_callback=self._accept,
            cancel_callback=self._stop,
        )

    def _accept(self, goal: Goal) -> None:
        self.goals.append((goal.request.order, goal.key))
        self._stops[goal.key] = library.Future()
        goal.execute()

    def _stop(self, goal: Goal) -> CancelResponse:
        self._stops[goal.key].set_result(None)
        return CancelResponse.ACCEPT

    async def _count(self, goal: Goal) -> Fibonacci.Result:
        await self._stops[goal.key]
        goal.canceled()
        self.cancelled.append(goal.key)
        return Fibonacci.Result()


def goal_bag(path: Path) -> None:
    """Write a bag with a goal, the order to cancel it, and a status."""
    send: Any = Fibonacci.Impl.SendGoalService
    requests = {
        "send_goal": (send, send.Request(goal_id=RECORDED, goal=Fibonacci.Goal(order=5))),
        "cancel_goal": (CancelGoal, CancelGoal.Request(goal_info=GoalInfo(goal_id=RECORDED))),
    }
    with Writer(path) as bag:
        bag.write("/fib/_action/status", GoalStatusArray(), 1)
        for number, (name, (service, request)) in enumerate(requests.items(), 1):
            event = service.Event(request=[request])
            event.info.event_type = 1  # received by the server
            bag.write(f"/fib/_action/{name}/_service_event", event, number * 300_000_000)


def test_recorded_goals_are_sent_with_new_ids(
    start: Start, bag: Path, make_context: MakeContext, spin: Spin
) -> None:
    goal_bag(bag)
    node = library.Node("server", context=make_context())
    counter = Counter(node)
    spin(node)
    # The second turn has other ids, because a server refuses an id that it knows.
    program = start("zbot", "bag", "play", "lesson", "--send-actions-as-client", "--loop")
    assert wait_until(lambda: len(counter.cancelled) > 1)
    assert program.stop() == 0
    assert "is sent to" not in program.output
    assert set(counter.cancelled) <= {key for _, key in counter.goals}
    assert len(set(counter.cancelled)) > 1
    assert {order for order, _ in counter.goals} == {5}
    assert bytes(RECORDED.uuid) not in counter.cancelled


def test_a_goal_without_a_server_is_one_error(start: Start, bag: Path) -> None:
    goal_bag(bag)
    program = start("zbot", "bag", "play", "lesson", "--send-actions-as-client")
    assert program.wait() == 0
    assert "no request is sent to service '/fib/_action/send_goal': it is not running" in (
        program.output
    )
