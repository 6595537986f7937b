# Written by python -m zbot.compat.generator; do not edit.
"""Options of a subscription that takes only some messages."""

from zbot.node.message_decoder import ContentFilterOptions

__all__ = [
    "ContentFilterOptions",
]
