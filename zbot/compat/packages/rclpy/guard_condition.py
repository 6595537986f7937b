"""Guard conditions."""

from zbot.context import Context as Context
from zbot.context import get_default_context as get_default_context
from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.guard_condition import GuardCondition as GuardCondition
