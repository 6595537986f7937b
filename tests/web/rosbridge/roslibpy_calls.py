"""Calls of roslibpy against a running turtlesim. Each is a line of output; the last is `all ok`.

Run: python roslibpy_calls.py ws://127.0.0.1:9090/
"""

from __future__ import annotations

import queue
import sys
import threading
import traceback
from typing import TYPE_CHECKING, Any

import roslibpy  # type: ignore[import-not-found]

if TYPE_CHECKING:
    from collections.abc import Callable

PATIENCE_S = 15


def message(ros: Any, name: str, kind: str, **options: Any) -> Any:
    """Return the first message of a topic."""
    found: queue.Queue[Any] = queue.Queue()
    topic = roslibpy.Topic(ros, name, kind, **options)
    topic.subscribe(found.put)
    try:
        return found.get(timeout=PATIENCE_S)
    finally:
        topic.unsubscribe()


def call(ros: Any, service: str, kind: str, /, **request: Any) -> Any:
    return roslibpy.Service(ros, service, kind).call(
        roslibpy.ServiceRequest(request), timeout=PATIENCE_S
    )


def topics(ros: Any) -> None:
    assert "/turtle1/pose" in ros.get_topics()
    assert ros.get_topic_type("/turtle1/pose") == "turtlesim/msg/Pose"
    assert "/turtle1/pose" in ros.get_topics_for_type("turtlesim/msg/Pose")


def services(ros: Any) -> None:
    assert "/spawn" in ros.get_services()
    assert ros.get_service_type("/spawn") == "turtlesim/srv/Spawn"
    assert "/spawn" in ros.get_services_for_type("turtlesim/srv/Spawn")
    details = ros.get_service_request_details("turtlesim/srv/Spawn")
    assert "theta" in details["typedefs"][0]["fieldnames"]
    details = ros.get_service_response_details("turtlesim/srv/Spawn")
    assert "name" in details["typedefs"][0]["fieldnames"]


def nodes(ros: Any) -> None:
    assert "/turtlesim" in ros.get_nodes()
    assert "/turtle1/pose" in str(ros.get_node_details("/turtlesim"))


def message_details(ros: Any) -> None:
    details = ros.get_message_details("geometry_msgs/Twist")
    assert details["typedefs"][0]["fieldnames"] == ["linear", "angular"]


def time(ros: Any) -> None:
    assert "sec" in str(ros.get_time())


def parameters(ros: Any) -> None:
    name = "/turtlesim:background_r"
    assert name in ros.get_params()
    parameter = roslibpy.Param(ros, name)
    before = parameter.get(timeout=PATIENCE_S)
    parameter.set(9, timeout=PATIENCE_S)
    assert parameter.get(timeout=PATIENCE_S) == 9
    parameter.set(before, timeout=PATIENCE_S)


def subscribe(ros: Any) -> None:
    assert "theta" in message(ros, "/turtle1/pose", "turtlesim/Pose")


def subscribe_throttled(ros: Any) -> None:
    options = {"throttle_rate": 200, "queue_length": 1}
    assert "theta" in message(ros, "/turtle1/pose", "turtlesim/Pose", **options)


def publish(ros: Any) -> None:
    twist = roslibpy.Topic(ros, "/turtle1/cmd_vel", "geometry_msgs/Twist")
    moved = threading.Event()
    pose = roslibpy.Topic(ros, "/turtle1/pose", "turtlesim/Pose")
    pose.subscribe(lambda seen: moved.set() if seen["linear_velocity"] > 0 else None)
    for _ in range(PATIENCE_S * 10):
        twist.publish(roslibpy.Message({"linear": {"x": 1.0}}))
        if moved.wait(0.1):
            break
    assert moved.is_set()
    pose.unsubscribe()
    twist.unadvertise()


def publish_latched(ros: Any) -> None:
    topic = roslibpy.Topic(ros, "/latched", "std_msgs/String", latch=True)
    topic.publish(roslibpy.Message({"data": "kept"}))
    assert message(ros, "/latched", "std_msgs/String") == {"data": "kept"}
    topic.unadvertise()


def call_service(ros: Any) -> None:
    name = call(ros, "/spawn", "turtlesim/Spawn", x=2, y=2.5, theta=0.0, name="")["name"]
    assert name.startswith("turtle")
    call(ros, "/kill", "turtlesim/Kill", name=name)


def call_service_with_an_error(ros: Any) -> None:
    outcome: Any = None
    try:
        outcome = call(ros, "/spawn", "turtlesim/Spawn", x="left")
    except Exception as error:  # noqa: BLE001 - roslibpy has no class for it
        outcome = str(error)
    assert isinstance(outcome, str), outcome
    assert "x" in outcome, outcome


def serve_service(ros: Any) -> None:
    def answer(request: Any, response: Any) -> bool:
        response["success"] = request["data"]
        response["message"] = "from roslibpy"
        return True

    service = roslibpy.Service(ros, "/set_from_program", "std_srvs/SetBool")
    service.advertise(answer)
    while "/set_from_program" not in ros.get_services():
        continue
    found = call(ros, "/set_from_program", "std_srvs/SetBool", data=True)
    assert found["message"] == "from roslibpy"
    service.unadvertise()


def send_goal(ros: Any) -> None:
    action = roslibpy.ActionClient(
        ros, "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute"
    )
    results: queue.Queue[Any] = queue.Queue()
    feedback: list[Any] = []
    action.send_goal(roslibpy.Goal({"theta": 1.0}), results.put, feedback.append, results.put)
    found = results.get(timeout=PATIENCE_S)
    assert "delta" in str(found), found
    assert "remaining" in str(feedback[0]), feedback


def cancel_goal(ros: Any) -> None:
    action = roslibpy.ActionClient(
        ros, "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute"
    )
    results: queue.Queue[Any] = queue.Queue()
    goal = roslibpy.Goal({"theta": -2.0})
    started = threading.Event()
    goal_id = action.send_goal(goal, results.put, lambda _: started.set(), results.put)
    assert started.wait(PATIENCE_S)
    action.cancel_goal(goal_id)
    found = results.get(timeout=PATIENCE_S)
    assert found["status"].value == 5, found


CALLS: tuple[Callable[[Any], None], ...] = (
    topics,
    services,
    nodes,
    message_details,
    time,
    parameters,
    subscribe,
    subscribe_throttled,
    publish,
    publish_latched,
    call_service,
    call_service_with_an_error,
    serve_service,
    send_goal,
    cancel_goal,
)


def main(address: str) -> None:
    ros = roslibpy.Ros(address)
    ros.run(timeout=PATIENCE_S)
    wrong = 0
    for check in CALLS:
        try:
            check(ros)
            print(f"{check.__name__:30} ok", flush=True)
        except Exception:  # noqa: BLE001 - each call is one line of the table
            wrong += 1
            print(f"{check.__name__:30} {traceback.format_exc()}", flush=True)
    ros.close()
    print("all ok" if not wrong else f"{wrong} calls failed", flush=True)
    ros.terminate()


if __name__ == "__main__":
    main(sys.argv[1])
