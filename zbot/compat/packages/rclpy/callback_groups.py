"""Which callbacks may run at the same time."""

from zbot.callback_group import CallbackGroup as CallbackGroup
from zbot.callback_group import MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup
from zbot.callback_group import ReentrantCallbackGroup as ReentrantCallbackGroup
