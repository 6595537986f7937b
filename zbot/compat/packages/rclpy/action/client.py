"""Action clients."""

from zbot.action.client import ActionClient as ActionClient
from zbot.action.client_goal_handle import ClientGoalHandle as ClientGoalHandle
from zbot.action.generic import FeedbackT as FeedbackT
from zbot.action.generic import GoalT as GoalT
from zbot.action.generic import ResultT as ResultT
from zbot.compat.annotation import ClientGoalHandleDict as ClientGoalHandleDict
from zbot.compat.annotation import FeedbackMessage as FeedbackMessage
from zbot.compat.annotation import GetResultServiceResponse as GetResultServiceResponse
from zbot.compat.annotation import SendGoalKWargs as SendGoalKWargs
from zbot.compat.annotation import SendGoalServiceResponse as SendGoalServiceResponse
from zbot.executor.clock import Clock as Clock
from zbot.executor.task import Future as Future
from zbot.executor.task import await_or_execute as await_or_execute
from zbot.executor.waitable import NumberOfEntities as NumberOfEntities
from zbot.executor.waitable import Waitable as Waitable
from zbot.interfaces.message import Action as Action
from zbot.interfaces.type_support import check_for_type_support as check_for_type_support
from zbot.node.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from zbot.qos import QoSProfile as QoSProfile
from zbot.qos import qos_profile_action_status_default as qos_profile_action_status_default
from zbot.qos import qos_profile_services_default as qos_profile_services_default

from action_msgs.msg import GoalStatus as GoalStatus
from action_msgs.msg import GoalStatusArray as GoalStatusArray
from action_msgs.srv import CancelGoal as CancelGoal
from builtin_interfaces.msg import Time as Time
from unique_identifier_msgs.msg import UUID as UUID
