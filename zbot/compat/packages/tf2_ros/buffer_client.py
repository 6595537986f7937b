# Written by python -m zbot.compat.generator; do not edit.
"""A buffer of another node."""

from zbot.tf2.remote_buffer import BufferClient

__all__ = [
    "BufferClient",
]
