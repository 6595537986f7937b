"""Actions of `ros_gz_bridge` and `ros_gz_sim`: the bridge and the simulator of Gazebo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from zbot.launch.actions.group import GroupAction
from zbot.launch.actions.include import IncludeLaunchDescription
from zbot.launch.errors import LaunchUsageError
from zbot.launch.substitutions.package import FindPackageShare
from zbot.launch.substitutions.path_join import PathJoinSubstitution
from zbot.log import get_logger

if TYPE_CHECKING:
    from zbot.launch.condition import Condition

#: They choose a process for a C++ component. In zbot, each program is a process.
_CONTAINER = ("container_name", "create_own_container", "use_composition")


class GazeboAction(GroupAction):
    """Group that includes a launch file of zbot, whose arguments are those of the action.

    Args:
        condition: Decides whether the action is done.
        given: The arguments of the file. What is `None` is left out.

    Raises:
        LaunchUsageError: The genuine action has no such argument.
    """

    place: ClassVar[tuple[str, str]]  #: the package and its launch file
    names: ClassVar[tuple[str, ...]]  #: the arguments of the file
    unused: ClassVar[tuple[str, ...]] = ()  #: arguments that have no effect in zbot

    def __init__(self, *, condition: Condition | None = None, **given: Any) -> None:
        for name, value in given.items():
            if name in self.unused and value:
                get_logger("launch").warning(f"{type(self).__name__}: {name} has no effect in zbot")
            elif name not in self.known():
                known = ", ".join(self.names)
                raise LaunchUsageError(
                    f"{type(self).__name__} has no argument {name!r}; it has {known}"
                )
        package, file = self.place
        path = PathJoinSubstitution([FindPackageShare(package), "launch", file])
        pairs = [(name, given[name]) for name in self.names if given.get(name) is not None]
        include = IncludeLaunchDescription(path, launch_arguments=pairs)
        super().__init__([include], condition=condition)

    @classmethod
    def known(cls) -> tuple[str, ...]:
        """Return the names of all arguments that the genuine action has."""
        return (*cls.names, *_CONTAINER, *cls.unused)


class RosGzBridge(GazeboAction):
    """Connects topics of the simulator with topics of ROS 2, as a YAML file lists them."""

    place = ("ros_gz_bridge", "ros_gz_bridge.launch.py")
    names = ("bridge_name", "config_file", "namespace", "log_level", "use_respawn")
    unused = ("bridge_params", "extra_bridge_params")


class GzServer(GazeboAction):
    """Simulates a world without a view."""

    place = ("ros_gz_sim", "gz_server.launch.py")
    names = ("world_sdf_file", "world_sdf_string")
    unused = ("initial_sim_time", "verbosity_level")


class GzSpawnModel(GazeboAction):
    """Adds a robot to the world that is simulated."""

    place = ("ros_gz_sim", "gz_spawn_model.launch.py")
    names = (
        *("world", "file", "model_string", "xml_string", "topic", "entity_name"),
        *("allow_renaming", "x", "y", "z", "roll", "pitch", "yaw"),
    )
