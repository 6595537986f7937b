"""Text of the error for a field whose message type does not exist, such as `Pose pose`."""

from __future__ import annotations

from zbot.interfaces import registry
from zbot.interfaces.spec import PRIMITIVES


def text_for_type(name: str) -> str:
    """Return what to write in place of a message type that its package does not have.

    The result is empty if no other type has this name.

    Args:
        name: Full name of the type. The name `Pose` in a package `robot` is `robot/msg/Pose`.
    """
    package, _, short = name.split("/")
    if short.lower() in PRIMITIVES:
        right = [short.lower()]
    else:
        right = [f"{other}/{short}" for other in registry.packages() if _has(other, short)][:3]
    return f"{package} has no message {short}: write {' or '.join(right)}" if right else ""


def _has(package: str, short: str) -> bool:
    return f"{package}/msg/{short}" in registry.interface_names(package)
