"""Service class that is loaded at the first request, for services that few programs use."""

from __future__ import annotations

from functools import cached_property
from typing import Any, cast

from zbot.interfaces.registry import get_service


class LazyService:
    """Placeholder of a service class, which is loaded when one of its parts is first used.

    Args:
        name: Full name of a service, e.g. `rcl_interfaces/srv/GetParameters`.
    """

    def __init__(self, name: str) -> None:
        self._name = name

    @cached_property
    def Request(self) -> Any:  # noqa: N802 - as in a service class
        """The request class."""
        return cast("Any", get_service(self._name)).Request

    @cached_property
    def Response(self) -> Any:  # noqa: N802 - as in a service class
        """The response class."""
        return cast("Any", get_service(self._name)).Response
