# Written by python -m zbot.compat.generator; do not edit.
"""Requests and responses for tests."""

from zbot.compat.sample_messages import get_test_srv

__all__ = [
    "get_test_srv",
]
