"""Error of the page and of the servers for web programs."""

from __future__ import annotations

from zbot.errors import ZbotError


class WebError(ZbotError):
    """The page or a server cannot do what the user or a web program asked."""
