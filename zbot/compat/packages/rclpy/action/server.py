# Written by python -m zbot.compat.generator; do not edit.
"""Action servers."""

from zbot.action.endpoint import FeedbackT, GoalT, ResultT
from zbot.action.goal_state import GoalEvent
from zbot.action.server import (
    ActionServer,
    CancelResponse,
    GoalResponse,
    default_cancel_callback,
    default_goal_callback,
    default_handle_accepted_callback,
)
from zbot.action.server_goal_handle import ServerGoalHandle
from zbot.compat.annotation import (
    FeedbackMessage,
    GetResultServiceRequest,
    GetResultServiceResponse,
    SendGoalServiceRequest,
    ServerGoalHandleDict,
)
from zbot.errors import ZbotError as RCLError
from zbot.executor.clock import Clock
from zbot.executor.task import Future, Task, await_or_execute
from zbot.executor.waitable import NumberOfEntities, Waitable
from zbot.interfaces.message import Action
from zbot.interfaces.python_class import check_for_type_support
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from action_msgs.msg import GoalInfo, GoalStatus
from action_msgs.srv import CancelGoal
from unique_identifier_msgs.msg import UUID

__all__ = [
    "Action",
    "ActionServer",
    "CancelGoal",
    "CancelResponse",
    "Clock",
    "FeedbackMessage",
    "FeedbackT",
    "Future",
    "GetResultServiceRequest",
    "GetResultServiceResponse",
    "GoalEvent",
    "GoalInfo",
    "GoalResponse",
    "GoalStatus",
    "GoalT",
    "NumberOfEntities",
    "QoSProfile",
    "RCLError",
    "ResultT",
    "SendGoalServiceRequest",
    "ServerGoalHandle",
    "ServerGoalHandleDict",
    "ServiceIntrospectionState",
    "Task",
    "UUID",
    "Waitable",
    "await_or_execute",
    "check_for_type_support",
    "default_cancel_callback",
    "default_goal_callback",
    "default_handle_accepted_callback",
    "qos_profile_action_status_default",
    "qos_profile_services_default",
]
