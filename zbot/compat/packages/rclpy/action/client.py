# Written by python -m zbot.compat.generator; do not edit.
"""Action clients."""

from zbot.action.client import ActionClient
from zbot.action.client_goal_handle import ClientGoalHandle
from zbot.action.endpoint import FeedbackT, GoalT, ResultT
from zbot.compat.annotation import (
    ClientGoalHandleDict,
    FeedbackMessage,
    GetResultServiceResponse,
    SendGoalKWargs,
    SendGoalServiceResponse,
)
from zbot.executor.clock import Clock
from zbot.executor.task import Future, await_or_execute
from zbot.executor.waitable import NumberOfEntities, Waitable
from zbot.interfaces.message import Action
from zbot.interfaces.python_class import check_for_type_support
from zbot.node.service_introspection import ServiceIntrospectionState
from zbot.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from action_msgs.msg import GoalStatus, GoalStatusArray
from action_msgs.srv import CancelGoal
from builtin_interfaces.msg import Time
from unique_identifier_msgs.msg import UUID

__all__ = [
    "Action",
    "ActionClient",
    "CancelGoal",
    "ClientGoalHandle",
    "ClientGoalHandleDict",
    "Clock",
    "FeedbackMessage",
    "FeedbackT",
    "Future",
    "GetResultServiceResponse",
    "GoalStatus",
    "GoalStatusArray",
    "GoalT",
    "NumberOfEntities",
    "QoSProfile",
    "ResultT",
    "SendGoalKWargs",
    "SendGoalServiceResponse",
    "ServiceIntrospectionState",
    "Time",
    "UUID",
    "Waitable",
    "await_or_execute",
    "check_for_type_support",
    "qos_profile_action_status_default",
    "qos_profile_services_default",
]
