"""Groups that decide which callbacks may run at the same time."""

from zbot.executor.callback_group import (
    CallbackGroup,
    MutuallyExclusiveCallbackGroup,
    ReentrantCallbackGroup,
)
