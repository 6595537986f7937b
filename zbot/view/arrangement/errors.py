"""Errors of arrangements."""

from __future__ import annotations

from zbot.errors import ZbotError


class ArrangementError(ZbotError, ValueError):
    """A file is not an arrangement of displays."""
