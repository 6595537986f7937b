"""Requests and responses for tests."""

from typing import Any

from zbot.compat.sample_messages import sample_services


def get_test_srv(service_name: str) -> list[Any]:
    """Return pairs of a filled request and response of a service of `test_msgs`, e.g. `Arrays`.

    Raises:
        UnknownInterfaceError: There is no such service.
    """
    return list(sample_services(f"test_msgs/srv/{service_name}"))
