"""Operator who leads the pump through its states, and hears the water and the transitions."""

from typing import Any

import rclpy
from rclpy.task import Future

from lifecycle_msgs.msg import Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetState
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("operator")
change = node.create_client(ChangeState, "/pump/change_state")
state = node.create_client(GetState, "/pump/get_state")
water, scrapped, seen = Future(), Future(), []


def on_transition(event: TransitionEvent) -> None:
    seen.append(event.goal_state.label)
    if event.goal_state.label == "finalized":
        scrapped.set_result(True)


def waited(future: Future) -> Any:
    rclpy.spin_until_future_complete(node, future, timeout_sec=60)
    return future.result()


def lead(transition: int) -> str:
    request = ChangeState.Request(transition=Transition(id=transition))
    accepted = waited(change.call_async(request)).success
    return f"{accepted} {waited(state.call_async(GetState.Request())).current_state.label}"


node.create_subscription(TransitionEvent, "/pump/transition_event", on_transition, 10)
node.create_subscription(UInt32, "flow", water.set_result, 10)
for client in (change, state):
    assert client.wait_for_service(60)
print("too early:", lead(Transition.TRANSITION_ACTIVATE))
print(lead(Transition.TRANSITION_CONFIGURE), "| water", water.done())
print(lead(Transition.TRANSITION_ACTIVATE), "| water", waited(water).data > 0)
print(lead(Transition.TRANSITION_DEACTIVATE), "|", lead(Transition.TRANSITION_CLEANUP))
print(lead(Transition.TRANSITION_UNCONFIGURED_SHUTDOWN), waited(scrapped), seen[-1])
rclpy.shutdown()
