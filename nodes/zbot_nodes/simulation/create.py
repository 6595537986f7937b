"""Add a robot to the simulator, and exit.

Run:     zbot run ros_gz_sim create -name bot -topic robot_description -z 0.1
Options: -world NAME, -file FILE, -topic TOPIC, -string TEXT, -param PARAMETER, -name NAME,
         -allow_renaming, -x, -y, -z in metres, -R, -P, -Y in radians. The parameters of the node
         have the same names.
Calls:   /world/NAME/create (ros_gz_interfaces/SpawnEntity)
"""

from __future__ import annotations

import sys
from pathlib import Path

from ros_gz_interfaces.msg import EntityFactory
from ros_gz_interfaces.srv import SpawnEntity

import zbot
from zbot.parameters.ros_args import remove_ros_args
from zbot_nodes.simulation.arguments import is_set, pose, read_options
from zbot_nodes.simulation.descriptions import from_topic, wait_until

_TYPE = "ros_gz_interfaces/srv/SpawnEntity"
_NAMES = ("world", "file", "string", "topic", "name", "x", "y", "z", "R", "P", "Y")
_FLAGS = ("allow_renaming", "unpause")


def options_of(node: zbot.Node, words: list[str]) -> dict[str, str]:
    """Return the options on the command line, and the parameters of the node."""
    given, _ = read_options(words, _FLAGS)
    found = {}
    for name in (*_NAMES, "allow_renaming"):
        if node.has_parameter(name):
            value = str(node.get_parameter(name).value)
            found.update({name: value} if value else {})
    return {**found, **given}


def request_of(node: zbot.Node, options: dict[str, str]) -> EntityFactory:
    """Return the request for the simulator."""
    wanted = EntityFactory(name=options.get("name", ""), pose=pose(options))
    wanted.allow_renaming = is_set(options, "allow_renaming")
    if options.get("topic"):
        wanted.sdf = from_topic(node, options["topic"])
    elif options.get("string"):
        wanted.sdf = options["string"]
    elif options.get("param"):
        wanted.sdf = str(node.get_parameter(options["param"]).value)
    elif options.get("file"):
        path = Path(options["file"])
        wanted.sdf_filename = str(path.absolute()) if path.exists() else options["file"]
    else:
        sys.exit("error: write -file, -topic, -string or -param")
    return wanted


def world_of(node: zbot.Node, name: str) -> str:
    """Return the service of the simulator, after it has started."""
    known: list[str] = [f"/world/{name}/create"] if name else []

    def look() -> bool:
        rows = node.get_service_names_and_types()
        known.extend(service for service, types in rows if _TYPE in types and not name)
        return bool(known)

    wait_until(node, look, "the simulator")
    return known[0]


def main() -> None:
    """Add the robot."""
    with zbot.init():
        node = zbot.Node(
            "ros_gz_sim",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        options = options_of(node, remove_ros_args()[1:])
        wanted = request_of(node, options)
        service = world_of(node, options.get("world", ""))
        client = node.create_client(SpawnEntity, service)
        wait_until(node, client.service_is_ready, f"the service {service}")
        future = client.call_async(SpawnEntity.Request(entity_factory=wanted))
        zbot.spin_until_future_complete(node, future)
        answer = future.result()
        if answer is None or not answer.success:
            node.get_logger().error("Failed to create the entity. The simulator says why.")
            sys.exit(1)
        node.get_logger().info("Entity creation successful.")


if __name__ == "__main__":
    main()
