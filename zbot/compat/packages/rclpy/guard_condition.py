"""Guard conditions."""

from zbot.callback_group import CallbackGroup as CallbackGroup
from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.guard_condition import GuardCondition as GuardCondition
