"""What a launch file can have done with nodes."""

from zbot.launch.actions import ComposableNodeContainer as ComposableNodeContainer
from zbot.launch.actions import LifecycleNode as LifecycleNode
from zbot.launch.actions import LifecycleTransition as LifecycleTransition
from zbot.launch.actions import LoadComposableNodes as LoadComposableNodes
from zbot.launch.actions import Node as Node
from zbot.launch.actions import PushROSNamespace as PushROSNamespace
from zbot.launch.actions import PushRosNamespace as PushRosNamespace
from zbot.launch.actions import ROSTimer as ROSTimer
from zbot.launch.actions import RosTimer as RosTimer
from zbot.launch.actions import SetParameter as SetParameter
from zbot.launch.actions import SetParametersFromFile as SetParametersFromFile
from zbot.launch.actions import SetRemap as SetRemap
from zbot.launch.actions import SetROSLogDir as SetROSLogDir
from zbot.launch.actions import SetRosLogDir as SetRosLogDir
from zbot.launch.actions import SetUseSimTime as SetUseSimTime
