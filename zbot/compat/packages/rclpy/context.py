"""Contexts."""

from zbot.context import Context as Context
