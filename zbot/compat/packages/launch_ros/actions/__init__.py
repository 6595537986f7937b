# Written by python -m zbot.compat.generator; do not edit.
"""Actions of launch files for nodes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions import (
    ComposableNodeContainer,
    LifecycleNode,
    LifecycleTransition,
    LoadComposableNodes,
    Node,
    PushROSNamespace,
    PushRosNamespace,
    ROSTimer,
    RosTimer,
    SetParameter,
    SetParametersFromFile,
    SetROSLogDir,
    SetRemap,
    SetRosLogDir,
    SetUseSimTime,
)

__all__ = [
    "ComposableNodeContainer",
    "LifecycleNode",
    "LifecycleTransition",
    "LoadComposableNodes",
    "Node",
    "PushROSNamespace",
    "PushRosNamespace",
    "ROSTimer",
    "RosTimer",
    "SetParameter",
    "SetParametersFromFile",
    "SetROSLogDir",
    "SetRemap",
    "SetRosLogDir",
    "SetUseSimTime",
]

if TYPE_CHECKING:
    from . import composable_node_container as composable_node_container
    from . import lifecycle_node as lifecycle_node
    from . import lifecycle_transition as lifecycle_transition
    from . import load_composable_nodes as load_composable_nodes
    from . import node as node
    from . import push_ros_namespace as push_ros_namespace
    from . import ros_timer as ros_timer
    from . import set_parameter as set_parameter
    from . import set_parameters_from_file as set_parameters_from_file
    from . import set_remap as set_remap
    from . import set_ros_log_dir as set_ros_log_dir
    from . import set_use_sim_time as set_use_sim_time
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "composable_node_container",
            "lifecycle_node",
            "lifecycle_transition",
            "load_composable_nodes",
            "node",
            "push_ros_namespace",
            "ros_timer",
            "set_parameter",
            "set_parameters_from_file",
            "set_remap",
            "set_ros_log_dir",
            "set_use_sim_time",
        ),
    )[0]
