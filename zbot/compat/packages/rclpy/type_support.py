"""Checks of types."""

from zbot.action.server_goal_handle import FeedbackT as FeedbackT
from zbot.action.server_goal_handle import GoalT as GoalT
from zbot.action.server_goal_handle import ResultT as ResultT
from zbot.errors import NotAMessageTypeError as NoTypeSupportImportedException
from zbot.interfaces.message import Action as Action
from zbot.interfaces.message import Message as Msg
from zbot.interfaces.message import Service as Srv

from service_msgs.msg import ServiceEventInfo as ServiceEventInfo
from unique_identifier_msgs.msg import UUID as UUID
