"""Actions that set namespace, remaps and parameters for all later nodes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.parameters import ParameterFile, evaluate
from zbot.launch.substitution import normalize, perform, to_bool
from zbot.log.log_file import get_logging_directory

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType

#: Launch configurations that contain the namespace, the remaps and the parameters of later nodes.
#: launch_ros uses the same names. A scoped group restores these configurations.
NAMESPACE, REMAPS, PARAMETERS = "ros_namespace", "ros_remaps", "global_params"


def join_namespace(base: str, name: str) -> str:
    """Return the namespace `base/name`. An absolute `name` stays unchanged."""
    if not name:
        return base
    if name.startswith("/") or not base:
        return name
    return f"{base.rstrip('/')}/{name}"


def absolute(namespace: str) -> str:
    """Return a namespace with a leading slash and without a trailing slash."""
    return "/" + namespace.strip("/")


def prefix_namespace(base_ns: str | None = None, ns: str | None = None) -> str | None:
    """Join two namespaces like `join_namespace`, and remove a trailing slash.

    If one argument is None, return the other argument.
    """
    if base_ns is None or ns is None:
        joined = base_ns if ns is None else ns
    else:
        joined = join_namespace(base_ns, ns)
    return joined if joined in {None, "/"} else str(joined).rstrip("/")


def is_namespace_absolute(ns: str) -> bool:
    """Return whether a namespace is absolute."""
    return ns.startswith("/")


def is_root_namespace(ns: str) -> bool:
    """Return whether a namespace is the root, `/`."""
    return ns == "/"


class PushROSNamespace(Action):
    """Put later nodes into a namespace."""

    def __init__(self, namespace: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.namespace = normalize(namespace)

    def execute(self, context: LaunchContext) -> None:
        """Append the namespace to the present namespace."""
        present = str(context.launch_configurations.get(NAMESPACE, ""))
        joined = join_namespace(present, perform(context, self.namespace))
        context.launch_configurations[NAMESPACE] = absolute(joined)


PushRosNamespace = PushROSNamespace


class SetRemap(Action):
    """Remap a topic or service name for later nodes."""

    def __init__(
        self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.src, self.dst = normalize(src), normalize(dst)

    def execute(self, context: LaunchContext) -> None:
        """Append the remap to the present remaps."""
        remap = perform(context, self.src), perform(context, self.dst)
        present = context.launch_configurations.get(REMAPS, [])
        context.launch_configurations[REMAPS] = [*present, remap]


class SetParameter(Action):
    """Set a parameter of later nodes."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, **options: Any) -> None:
        super().__init__(**options)
        self.name, self.value = normalize(name), value

    def execute(self, context: LaunchContext) -> None:
        """Append the setting to the present parameters."""
        _add(context, (perform(context, self.name), evaluate(context, self.value)))


class SetParametersFromFile(Action):
    """Set the parameters of later nodes from a file."""

    def __init__(
        self,
        filename: SomeSubstitutionsType,
        *,
        node_name: SomeSubstitutionsType | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.filename = normalize(filename)
        del node_name  # the file itself contains the names of the nodes

    def execute(self, context: LaunchContext) -> None:
        """Append the setting to the present parameters."""
        _add(context, ParameterFile(perform(context, self.filename)))


class SetUseSimTime(Action):
    """Set whether the clocks of later nodes use the time from `/clock`."""

    def __init__(self, value: bool | SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.value = normalize(str(value) if isinstance(value, bool) else value)

    def execute(self, context: LaunchContext) -> None:
        """Append the setting to the present parameters."""
        _add(context, ("use_sim_time", bool(to_bool(perform(context, self.value)))))


class SetROSLogDir(Action):
    """Set the folder of the log files of later processes.

    Args:
        new_log_dir: The folder. A relative path starts in the present log folder.
        options: The options of `Action`.
    """

    def __init__(self, new_log_dir: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.log_dir = normalize(new_log_dir)

    def execute(self, context: LaunchContext) -> None:
        """Set the variable `ROS_LOG_DIR`."""
        present = context.environment.get("ROS_LOG_DIR") or str(get_logging_directory())
        folder = Path(present) / perform(context, self.log_dir)
        context.environment["ROS_LOG_DIR"] = str(folder)


SetRosLogDir = SetROSLogDir


def _add(context: LaunchContext, parameter: Any) -> None:
    present = context.launch_configurations.get(PARAMETERS, [])
    context.launch_configurations[PARAMETERS] = [*present, parameter]
