"""Contexts: one Zenoh session with one domain, from `init()` to `shutdown()`."""

from zbot.context.context import Context
from zbot.context.default_context import get_default_context

__all__ = ["Context", "get_default_context"]
