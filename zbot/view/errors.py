"""Errors of the 3D view."""

from __future__ import annotations

from zbot.errors import ZbotError


class DisplayError(ZbotError, ValueError):
    """A message cannot be drawn. The text is the sentence that its display shows."""
