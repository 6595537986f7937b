"""Add a robot to the simulator, and exit, as Gazebo Classic's program does.

Run:     zbot run gazebo_ros spawn_entity.py -entity bot -topic robot_description
Options: -entity NAME, -file FILE, -topic TOPIC, -database MODEL, -stdin, -x, -y, -z in metres,
         -R, -P, -Y in radians, -robot_namespace NAMESPACE, -gazebo_namespace NAMESPACE,
         -timeout SECONDS, -spawn_service_timeout SECONDS, -unpause
Calls:   /spawn_entity (gazebo_msgs/SpawnEntity)
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from gazebo_msgs.srv import SpawnEntity

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.simulation.arguments import is_set, number, pose, read_options
from zbot_nodes.simulation.descriptions import from_file, from_models, from_topic, wait_until

from std_srvs.srv import Empty

if TYPE_CHECKING:
    from zbot.executor.task import Future

_FLAGS = ("stdin", "unpause", "package_to_model", "b", "bond", "h", "help")
_USUAL_TIMEOUT_S = 30.0


def description(node: zbot.Node, options: dict[str, str]) -> str:
    """Return the description that the options name."""
    if "file" in options:
        return from_file(options["file"])
    if is_set(options, "stdin"):
        return sys.stdin.read()
    if "topic" in options:
        return from_topic(node, options["topic"])
    if "database" in options:
        return from_models(options["database"])
    sys.exit("error: write -file, -topic, -database or -stdin")


def call(node: zbot.Node, kind: Any, service: str, request: Any, timeout_s: float) -> Any:
    """Call a service.

    Raises:
        SystemExit: There is no answer in time.
    """
    client = node.create_client(kind, service)
    if not client.wait_for_service(timeout_sec=timeout_s):
        node.get_logger().error(
            f"Service {service} unavailable. Was Gazebo started with GazeboRosFactory?"
        )
        sys.exit(1)
    future: Future[Any] = client.call_async(request)
    wait_until(node, future.done, f"the answer of {service}")
    return future.result()


def main() -> None:
    """Add the robot."""
    options, _ = read_options(remove_ros_args()[1:], _FLAGS)
    with zbot.init():
        node = zbot.Node("spawn_entity")
        start = options.get("gazebo_namespace", "").rstrip("/")
        request = SpawnEntity.Request(
            name=options.get("entity", ""),
            xml=description(node, options),
            robot_namespace=options.get("robot_namespace", node.get_namespace()),
            initial_pose=pose(options),
            reference_frame=options.get("reference_frame", ""),
        )
        given = {"spawn_service_timeout": str(_USUAL_TIMEOUT_S), **options}
        timeout_s = number(given, "spawn_service_timeout")
        node.get_logger().info(f"Calling service {start}/spawn_entity")
        answer = call(node, SpawnEntity, f"{start}/spawn_entity", request, timeout_s)
        node.get_logger().info(f"Spawn status: {answer.status_message}")
        if not answer.success:
            node.get_logger().error("Spawn service failed. Exiting.")
            sys.exit(1)
        if is_set(options, "unpause"):
            call(node, Empty, f"{start}/unpause_physics", Empty.Request(), timeout_s)


if __name__ == "__main__":
    main()
