"""Guard conditions."""

from zbot.context import Context, get_default_context
from zbot.executor.callback_group import CallbackGroup
from zbot.executor.guard_condition import GuardCondition
