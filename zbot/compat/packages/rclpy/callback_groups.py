"""Which callbacks may run at the same time."""

from zbot.executor.callback_group import CallbackGroup as CallbackGroup
from zbot.executor.callback_group import (
    MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup,
)
from zbot.executor.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
