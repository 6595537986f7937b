"""Launch files, which start, watch and stop several nodes and programs together.

Names, arguments and behaviour are the same as in launch and launch_ros of ROS 2.
"""

from zbot.launch.action import Action as Action
from zbot.launch.condition import Condition as Condition
from zbot.launch.context import LaunchContext as LaunchContext
from zbot.launch.description import LaunchDescription as LaunchDescription
from zbot.launch.entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from zbot.launch.event import Event as Event
from zbot.launch.event_handler import EventHandler as EventHandler
from zbot.launch.introspector import LaunchIntrospector as LaunchIntrospector
from zbot.launch.service import LaunchService as LaunchService
from zbot.launch.source import LaunchDescriptionSource as LaunchDescriptionSource
from zbot.launch.substitution import SomeSubstitutionsType as SomeSubstitutionsType
from zbot.launch.substitution import Substitution as Substitution
