"""Error of the page, of plots and of the servers for web programs."""

from __future__ import annotations

from zbot.errors import ZbotError


class ViewerError(ZbotError):
    """A viewer of the domain cannot do what its user or its client asked."""
