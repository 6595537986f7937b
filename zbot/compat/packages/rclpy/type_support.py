"""Checks of types."""

from zbot.action.generic import FeedbackT as FeedbackT
from zbot.action.generic import GoalT as GoalT
from zbot.action.generic import ResultT as ResultT
from zbot.compat.annotation import CommonMsgSrvMetaClass as CommonMsgSrvMetaClass
from zbot.compat.annotation import EventMessage as EventMessage
from zbot.compat.annotation import FeedbackMessage as FeedbackMessage
from zbot.compat.annotation import GetResultService as GetResultService
from zbot.compat.annotation import GetResultServiceRequest as GetResultServiceRequest
from zbot.compat.annotation import GetResultServiceResponse as GetResultServiceResponse
from zbot.compat.annotation import MsgMetaClass as MsgMetaClass
from zbot.compat.annotation import ProtocolType as ProtocolType
from zbot.compat.annotation import PyCapsule as PyCapsule
from zbot.compat.annotation import SendGoalService as SendGoalService
from zbot.compat.annotation import SendGoalServiceRequest as SendGoalServiceRequest
from zbot.compat.annotation import SendGoalServiceResponse as SendGoalServiceResponse
from zbot.interfaces.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.interfaces.message import Action as Action
from zbot.interfaces.message import Message as Msg
from zbot.interfaces.message import Service as Srv
from zbot.interfaces.type_support import ActionT as ActionT
from zbot.interfaces.type_support import MsgT as MsgT
from zbot.interfaces.type_support import SrvRequestT as SrvRequestT
from zbot.interfaces.type_support import SrvResponseT as SrvResponseT
from zbot.interfaces.type_support import SrvT as SrvT
from zbot.interfaces.type_support import check_for_type_support as check_for_type_support
from zbot.interfaces.type_support import check_is_valid_msg_type as check_is_valid_msg_type
from zbot.interfaces.type_support import check_is_valid_srv_type as check_is_valid_srv_type

from builtin_interfaces.msg import Time as Time
from service_msgs.msg import ServiceEventInfo as ServiceEventInfo
from unique_identifier_msgs.msg import UUID as UUID
