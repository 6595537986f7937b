"""Contexts."""

from zbot.context import Context
