"""Action servers."""

from zbot.action.generic import FeedbackT as FeedbackT
from zbot.action.generic import GoalT as GoalT
from zbot.action.generic import ResultT as ResultT
from zbot.action.goal_state import GoalEvent as GoalEvent
from zbot.action.server import ActionServer as ActionServer
from zbot.action.server import CancelResponse as CancelResponse
from zbot.action.server import GoalResponse as GoalResponse
from zbot.action.server import default_cancel_callback as default_cancel_callback
from zbot.action.server import default_goal_callback as default_goal_callback
from zbot.action.server import default_handle_accepted_callback as default_handle_accepted_callback
from zbot.action.server_goal_handle import ServerGoalHandle as ServerGoalHandle
from zbot.compat.annotation import FeedbackMessage as FeedbackMessage
from zbot.compat.annotation import GetResultServiceRequest as GetResultServiceRequest
from zbot.compat.annotation import GetResultServiceResponse as GetResultServiceResponse
from zbot.compat.annotation import SendGoalServiceRequest as SendGoalServiceRequest
from zbot.compat.annotation import ServerGoalHandleDict as ServerGoalHandleDict
from zbot.errors import ZbotError as RCLError
from zbot.executor.clock import Clock as Clock
from zbot.executor.task import Future as Future
from zbot.executor.task import Task as Task
from zbot.executor.task import await_or_execute as await_or_execute
from zbot.executor.waitable import NumberOfEntities as NumberOfEntities
from zbot.executor.waitable import Waitable as Waitable
from zbot.interfaces.message import Action as Action
from zbot.interfaces.type_support import check_for_type_support as check_for_type_support
from zbot.node.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_action_status_default as qos_profile_action_status_default
from zbot.qos import qos_profile_services_default as qos_profile_services_default

from action_msgs.msg import GoalInfo as GoalInfo
from action_msgs.msg import GoalStatus as GoalStatus
from action_msgs.srv import CancelGoal as CancelGoal
from unique_identifier_msgs.msg import UUID as UUID
