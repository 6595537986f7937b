# Written by python -m zbot.compat.generator; do not edit.
"""Base classes of all generated classes in distributions after Kilted."""

from zbot.interfaces.message import (
    Action as BaseAction,
    Impl as BaseImpl,
    Message as BaseMessage,
    Service as BaseService,
)

__all__ = [
    "BaseAction",
    "BaseImpl",
    "BaseMessage",
    "BaseService",
]
