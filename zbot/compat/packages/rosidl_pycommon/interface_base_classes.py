"""Base classes of all generated classes in distributions after Kilted."""

from zbot.interfaces.message import Action as BaseAction
from zbot.interfaces.message import Impl as BaseImpl
from zbot.interfaces.message import Message as BaseMessage
from zbot.interfaces.message import Service as BaseService
