"""Placeholder for a service class that few programs use. It loads the class at the first use."""

from __future__ import annotations

from functools import cached_property
from typing import Any, cast

from zbot.interfaces.registry import get_service


class LazyService:
    """Placeholder of a service class. The class is loaded when a part of it is first used.

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
