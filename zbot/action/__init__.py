"""Actions: goals that take time, send feedback, and have a result at the end.

    from example_interfaces.action import Fibonacci
    from zbot.action import ActionServer

    def count(goal_handle):
        for step in range(goal_handle.request.order):
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=[step]))
        goal_handle.succeed()
        return Fibonacci.Result(sequence=list(range(goal_handle.request.order)))

    ActionServer(node, Fibonacci, "count", count)

An action uses three services and two topics of ROS 2. Their names begin with `<action>/_action/`.
The services are `send_goal`, `cancel_goal` and `get_result`. The topics are `feedback` and
`status`.
"""

from zbot.action.client import ActionClient as ActionClient
from zbot.action.client_goal_handle import ClientGoalHandle as ClientGoalHandle
from zbot.action.errors import ActionMessageError as ActionMessageError
from zbot.action.errors import NotAnActionTypeError as NotAnActionTypeError
from zbot.action.goal_state import GoalEvent as GoalEvent
from zbot.action.goal_state import GoalState as GoalState
from zbot.action.goal_state import GoalTransitionError as GoalTransitionError
from zbot.action.graph import (
    get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node,
)
from zbot.action.graph import get_action_names_and_types as get_action_names_and_types
from zbot.action.graph import (
    get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node,
)
from zbot.action.server import ActionServer as ActionServer
from zbot.action.server import CancelResponse as CancelResponse
from zbot.action.server import GoalResponse as GoalResponse
from zbot.action.server_goal_handle import ServerGoalHandle as ServerGoalHandle
