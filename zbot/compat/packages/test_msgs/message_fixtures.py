"""Messages to test with."""

from typing import Any

from zbot.compat.sample_messages import sample_messages


def get_test_msg(message_name: str) -> list[Any]:
    """Return filled messages of a type of `test_msgs`, e.g. `Arrays`.

    Raises:
        UnknownInterfaceError: There is no such type.
    """
    return sample_messages(f"test_msgs/msg/{message_name}")
