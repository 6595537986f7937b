"""Actions of launch files, with the same names as in launch and launch_ros."""

from zbot.launch.action import Action as Action
from zbot.launch.actions.composable import ComposableNodeContainer as ComposableNodeContainer
from zbot.launch.actions.composable import LoadComposableNodes as LoadComposableNodes
from zbot.launch.actions.configuration import AppendEnvironmentVariable as AppendEnvironmentVariable
from zbot.launch.actions.configuration import PopEnvironment as PopEnvironment
from zbot.launch.actions.configuration import PopLaunchConfigurations as PopLaunchConfigurations
from zbot.launch.actions.configuration import PushEnvironment as PushEnvironment
from zbot.launch.actions.configuration import PushLaunchConfigurations as PushLaunchConfigurations
from zbot.launch.actions.configuration import (
    ReplaceEnvironmentVariables as ReplaceEnvironmentVariables,
)
from zbot.launch.actions.configuration import ResetEnvironment as ResetEnvironment
from zbot.launch.actions.configuration import ResetLaunchConfigurations as ResetLaunchConfigurations
from zbot.launch.actions.configuration import SetEnvironmentVariable as SetEnvironmentVariable
from zbot.launch.actions.configuration import SetLaunchConfiguration as SetLaunchConfiguration
from zbot.launch.actions.configuration import UnsetEnvironmentVariable as UnsetEnvironmentVariable
from zbot.launch.actions.configuration import UnsetLaunchConfiguration as UnsetLaunchConfiguration
from zbot.launch.actions.declare_argument import (
    DeclareBooleanLaunchArgument as DeclareBooleanLaunchArgument,
)
from zbot.launch.actions.declare_argument import DeclareLaunchArgument as DeclareLaunchArgument
from zbot.launch.actions.event_action import EmitEvent as EmitEvent
from zbot.launch.actions.event_action import RegisterEventHandler as RegisterEventHandler
from zbot.launch.actions.event_action import Shutdown as Shutdown
from zbot.launch.actions.event_action import UnregisterEventHandler as UnregisterEventHandler
from zbot.launch.actions.event_action import shutdown_on_process_exit as shutdown_on_process_exit
from zbot.launch.actions.execute import ExecuteLocal as ExecuteLocal
from zbot.launch.actions.execute import ExecuteProcess as ExecuteProcess
from zbot.launch.actions.group import GroupAction as GroupAction
from zbot.launch.actions.include import IncludeLaunchDescription as IncludeLaunchDescription
from zbot.launch.actions.lifecycle_node import LifecycleNode as LifecycleNode
from zbot.launch.actions.lifecycle_node import LifecycleTransition as LifecycleTransition
from zbot.launch.actions.log import Log as Log
from zbot.launch.actions.log import LogDebug as LogDebug
from zbot.launch.actions.log import LogError as LogError
from zbot.launch.actions.log import LogInfo as LogInfo
from zbot.launch.actions.log import LogWarning as LogWarning
from zbot.launch.actions.loop import ForEach as ForEach
from zbot.launch.actions.loop import ForLoop as ForLoop
from zbot.launch.actions.node import Node as Node
from zbot.launch.actions.opaque import OpaqueCoroutine as OpaqueCoroutine
from zbot.launch.actions.opaque import OpaqueFunction as OpaqueFunction
from zbot.launch.actions.ros_names import PushROSNamespace as PushROSNamespace
from zbot.launch.actions.ros_names import PushRosNamespace as PushRosNamespace
from zbot.launch.actions.ros_names import SetParameter as SetParameter
from zbot.launch.actions.ros_names import SetParametersFromFile as SetParametersFromFile
from zbot.launch.actions.ros_names import SetRemap as SetRemap
from zbot.launch.actions.ros_names import SetROSLogDir as SetROSLogDir
from zbot.launch.actions.ros_names import SetRosLogDir as SetRosLogDir
from zbot.launch.actions.ros_names import SetUseSimTime as SetUseSimTime
from zbot.launch.actions.timer import ROSTimer as ROSTimer
from zbot.launch.actions.timer import RosTimer as RosTimer
from zbot.launch.actions.timer import TimerAction as TimerAction
