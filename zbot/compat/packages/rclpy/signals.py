# Written by python -m zbot.compat.generator; do not edit.
"""Ctrl-C and SIGTERM."""

from zbot.errors import InvalidHandleError as InvalidHandle
from zbot.executor.guard_condition import GuardCondition, SignalHandlerGuardCondition
from zbot.process.signals import (
    SignalHandlerOptions,
    install as install_signal_handlers,
    installed as get_current_signal_handlers_options,
    uninstall as uninstall_signal_handlers,
)

__all__ = [
    "GuardCondition",
    "InvalidHandle",
    "SignalHandlerGuardCondition",
    "SignalHandlerOptions",
    "get_current_signal_handlers_options",
    "install_signal_handlers",
    "uninstall_signal_handlers",
]
