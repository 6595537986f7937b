"""Launch files, which start, watch and stop several nodes and programs together.

Names, arguments and behaviour are the same as in launch and launch_ros of ROS 2.
"""

# Only in this room, modules may import each other in a circle. ROS 2 defines the parts of a launch
# by each other: an action has conditions, substitutions and events. A condition and a substitution
# are evaluated with the context. The context has the event handlers, and these return actions. The
# actions and the parser of files call each other too, because an action includes other files.

from zbot.launch.action import Action as Action
from zbot.launch.condition import Condition as Condition
from zbot.launch.context import LaunchContext as LaunchContext
from zbot.launch.description import LaunchDescription as LaunchDescription
from zbot.launch.description import LaunchIntrospector as LaunchIntrospector
from zbot.launch.entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from zbot.launch.event import Event as Event
from zbot.launch.event_handler import EventHandler as EventHandler
from zbot.launch.service import LaunchService as LaunchService
from zbot.launch.source import LaunchDescriptionSource as LaunchDescriptionSource
from zbot.launch.substitution import SomeSubstitutionsType as SomeSubstitutionsType
from zbot.launch.substitution import Substitution as Substitution
