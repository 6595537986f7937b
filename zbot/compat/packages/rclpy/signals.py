"""Ctrl-C and SIGTERM."""

from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.guard_condition import GuardCondition as GuardCondition
from zbot.signals import SignalHandlerGuardCondition as SignalHandlerGuardCondition
from zbot.signals import SignalHandlerOptions as SignalHandlerOptions
from zbot.signals import install as install_signal_handlers
from zbot.signals import installed as get_current_signal_handlers_options
from zbot.signals import uninstall as uninstall_signal_handlers
