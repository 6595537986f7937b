"""Messages for tests, from `get_test_msg("BasicTypes")` or `get_msg_basic_types()`."""

from collections.abc import Callable
from functools import partial
from typing import Any

from zbot.compat.sample_messages import sample_messages
from zbot.interfaces import registry


def get_test_msg(message_name: str) -> list[Any]:
    """Return filled messages of a type of `test_msgs`, e.g. `Arrays`.

    Raises:
        UnknownInterfaceError: There is no such type.
    """
    return sample_messages(f"test_msgs/msg/{message_name}")


def __getattr__(name: str) -> Callable[[], list[Any]]:
    """Return the function of one type, e.g. `get_msg_wstrings` for `WStrings`."""
    if name.startswith("get_msg_"):
        wanted = name.removeprefix("get_msg_").replace("_", "")
        for full in registry.interface_names("test_msgs"):
            _, kind, short = full.split("/")
            if kind == "msg" and short.lower() == wanted:
                return partial(get_test_msg, short)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
