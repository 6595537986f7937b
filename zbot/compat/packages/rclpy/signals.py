"""Ctrl-C and SIGTERM."""

from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.signal_guard_condition import (
    SignalHandlerGuardCondition,
)
from zbot.process.signals import SignalHandlerOptions
from zbot.process.signals import install as install_signal_handlers
from zbot.process.signals import installed as get_current_signal_handlers_options
from zbot.process.signals import uninstall as uninstall_signal_handlers
