"""Error of a command line."""

from __future__ import annotations

from zbot.errors import ZbotError


class CommandError(ZbotError):
    """A command cannot do what its command line says. The message is all that it prints."""
