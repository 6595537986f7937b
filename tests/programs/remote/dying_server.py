"""Action server that is killed at a stage of its goals. The stage is the program's argument."""

from __future__ import annotations

import os
import signal
import sys
from typing import Any

import zbot
from zbot.action import ActionServer, CancelResponse, GoalResponse

from example_interfaces.action import Fibonacci

STAGES = (
    *("deciding", "accepted", "executing", "feedback", "canceling", "canceled"),
    *("succeeded", "requested"),
)


def reach(stage: str) -> None:
    """Kill this process if it was started to die at this stage."""
    if sys.argv[1:] == [stage]:
        os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))


def decide(_: Any) -> GoalResponse:
    reach("deciding")
    return GoalResponse.ACCEPT


def cancel(_: Any) -> CancelResponse:
    reach("canceling")
    return CancelResponse.ACCEPT


def begin(goal: Any) -> None:
    reach("accepted")
    goal.execute()


class Server(ActionServer[Any, Any, Any]):
    """Server that is killed when a client asks for a result."""

    async def _on_result_request(self, request: Any, response: Any) -> Any:
        reach("requested")
        return await super()._on_result_request(request, response)


async def pause() -> None:
    over: zbot.Future[None] = zbot.Future()
    timer = node.create_timer(0.01, lambda: over.set_result(None))
    await over
    node.destroy_timer(timer)


async def execute(goal: Any) -> Fibonacci.Result:
    reach("executing")
    goal.publish_feedback(Fibonacci.Feedback(sequence=[0]))
    reach("feedback")
    while goal.request.order == 0 and not goal.is_cancel_requested:
        await pause()
    if goal.is_cancel_requested:
        goal.canceled()
        reach("canceled")
        return Fibonacci.Result()
    goal.succeed()
    reach("succeeded")
    return Fibonacci.Result(sequence=[goal.request.order])


with zbot.init():
    node = zbot.Node("server")
    server = Server(
        node,
        Fibonacci,
        "fibonacci",
        execute,
        goal_callback=decide,
        handle_accepted_callback=begin,
        cancel_callback=cancel,
    )
    print("ready", flush=True)
    zbot.spin(node)
