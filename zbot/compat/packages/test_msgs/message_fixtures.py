# Written by python -m zbot.compat.generator; do not edit.
"""Messages for tests, from `get_test_msg("BasicTypes")` or `get_msg_basic_types()`."""

from zbot.compat.sample_messages import function_of_type as __getattr__, get_test_msg

__all__ = [
    "get_test_msg",
]
