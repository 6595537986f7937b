"""Namespaces, remaps and parameters for all nodes that follow."""

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

#: Names of launch configurations, as launch_ros has them: so a group's end ends them too.
NAMESPACE, REMAPS, PARAMETERS = "ros_namespace", "ros_remaps", "global_params"


def join_namespace(base: str, name: str) -> str:
    """Return a namespace inside another; an absolute one stands for itself."""
    if not name:
        return base
    if name.startswith("/") or not base:
        return name
    return f"{base.rstrip('/')}/{name}"


def absolute(namespace: str) -> str:
    """Return a namespace with its first slash and without a last one."""
    return "/" + namespace.strip("/")


def prefix_namespace(base_ns: str | None = None, ns: str | None = None) -> str | None:
    """Return a namespace inside another, either of which may be missing; see above."""
    if base_ns is None or ns is None:
        joined = base_ns if ns is None else ns
    else:
        joined = join_namespace(base_ns, ns)
    return joined if joined in {None, "/"} else str(joined).rstrip("/")


def is_namespace_absolute(ns: str) -> bool:
    """Return whether a namespace stands for itself."""
    return ns.startswith("/")


def is_root_namespace(ns: str) -> bool:
    """Return whether a namespace is that of all others."""
    return ns == "/"


class PushROSNamespace(Action):
    """Put the nodes that follow into a namespace."""

    def __init__(self, namespace: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.namespace = normalize(namespace)

    def execute(self, context: LaunchContext) -> None:
        """Add to the namespace that holds."""
        present = str(context.launch_configurations.get(NAMESPACE, ""))
        joined = join_namespace(present, perform(context, self.namespace))
        context.launch_configurations[NAMESPACE] = absolute(joined)


PushRosNamespace = PushROSNamespace


class SetRemap(Action):
    """Let the nodes that follow use another name for a topic or service."""

    def __init__(
        self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **options: Any
    ) -> None:
        super().__init__(**options)
        self.src, self.dst = normalize(src), normalize(dst)

    def execute(self, context: LaunchContext) -> None:
        """Add to the remaps that hold."""
        remap = perform(context, self.src), perform(context, self.dst)
        present = context.launch_configurations.get(REMAPS, [])
        context.launch_configurations[REMAPS] = [*present, remap]


class SetParameter(Action):
    """Set a parameter of the nodes that follow."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, **options: Any) -> None:
        super().__init__(**options)
        self.name, self.value = normalize(name), value

    def execute(self, context: LaunchContext) -> None:
        """Add to the parameters that hold."""
        _add(context, (perform(context, self.name), evaluate(context, self.value)))


class SetParametersFromFile(Action):
    """Give a parameter file to the nodes that follow."""

    def __init__(
        self,
        filename: SomeSubstitutionsType,
        *,
        node_name: SomeSubstitutionsType | None = None,
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self.filename = normalize(filename)
        del node_name  # the file itself says which node gets what

    def execute(self, context: LaunchContext) -> None:
        """Add to the parameters that hold."""
        _add(context, ParameterFile(perform(context, self.filename)))


class SetUseSimTime(Action):
    """Let the nodes that follow take the time from `/clock`, or not."""

    def __init__(self, value: bool | SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.value = normalize(str(value) if isinstance(value, bool) else value)

    def execute(self, context: LaunchContext) -> None:
        """Add to the parameters that hold."""
        _add(context, ("use_sim_time", bool(to_bool(perform(context, self.value)))))


class SetROSLogDir(Action):
    """Let the processes that follow write their log files to a folder.

    Args:
        new_log_dir: The folder; a relative one stands in the one that holds.
        options: As for `Action`.
    """

    def __init__(self, new_log_dir: SomeSubstitutionsType, **options: Any) -> None:
        super().__init__(**options)
        self.log_dir = normalize(new_log_dir)

    def execute(self, context: LaunchContext) -> None:
        """Set the variable."""
        present = context.environment.get("ROS_LOG_DIR") or str(get_logging_directory())
        folder = Path(present) / perform(context, self.log_dir)
        context.environment["ROS_LOG_DIR"] = str(folder)


SetRosLogDir = SetROSLogDir


def _add(context: LaunchContext, parameter: Any) -> None:
    present = context.launch_configurations.get(PARAMETERS, [])
    context.launch_configurations[PARAMETERS] = [*present, parameter]
