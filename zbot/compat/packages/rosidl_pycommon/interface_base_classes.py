"""What newer distributions than Kilted derive every generated class from."""

from zbot.interfaces.message import Action as BaseAction
from zbot.interfaces.message import Impl as BaseImpl
from zbot.interfaces.message import Message as BaseMessage
from zbot.interfaces.message import Service as BaseService
