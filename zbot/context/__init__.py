"""Contexts: one Zenoh session with one domain, from `init()` to `shutdown()`."""

from zbot.context.context import Context, get_default_context

__all__ = ["Context", "get_default_context"]
