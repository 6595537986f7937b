"""Actions of launch files for nodes."""

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
    SetRemap,
    SetROSLogDir,
    SetRosLogDir,
    SetUseSimTime,
)
