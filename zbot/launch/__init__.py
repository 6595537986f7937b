"""Launch files: several nodes and programs started, watched and stopped together.

The names, arguments and meanings are those of ROS 2's launch and launch_ros.
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
