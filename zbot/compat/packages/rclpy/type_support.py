# Written by python -m zbot.compat.generator; do not edit.
"""Checks of types."""

from zbot.action.endpoint import FeedbackT, GoalT, ResultT
from zbot.compat.annotation import (
    CommonMsgSrvMetaClass,
    EventMessage,
    FeedbackMessage,
    GetResultService,
    GetResultServiceRequest,
    GetResultServiceResponse,
    MsgMetaClass,
    ProtocolType,
    PyCapsule,
    SendGoalService,
    SendGoalServiceRequest,
    SendGoalServiceResponse,
)
from zbot.interfaces.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.interfaces.message import Action, Message as Msg, Service as Srv
from zbot.interfaces.python_class import (
    ActionT,
    MsgT,
    SrvRequestT,
    SrvResponseT,
    SrvT,
    check_for_type_support,
    check_is_valid_msg_type,
    check_is_valid_srv_type,
)
from builtin_interfaces.msg import Time
from service_msgs.msg import ServiceEventInfo
from unique_identifier_msgs.msg import UUID

__all__ = [
    "Action",
    "ActionT",
    "CommonMsgSrvMetaClass",
    "EventMessage",
    "FeedbackMessage",
    "FeedbackT",
    "GetResultService",
    "GetResultServiceRequest",
    "GetResultServiceResponse",
    "GoalT",
    "Msg",
    "MsgMetaClass",
    "MsgT",
    "NoTypeSupportImportedException",
    "ProtocolType",
    "PyCapsule",
    "ResultT",
    "SendGoalService",
    "SendGoalServiceRequest",
    "SendGoalServiceResponse",
    "ServiceEventInfo",
    "Srv",
    "SrvRequestT",
    "SrvResponseT",
    "SrvT",
    "Time",
    "UUID",
    "check_for_type_support",
    "check_is_valid_msg_type",
    "check_is_valid_srv_type",
]
