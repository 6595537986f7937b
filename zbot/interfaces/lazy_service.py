"""Classes that are made when they are needed, for what most programs never use."""

from __future__ import annotations

from functools import cached_property
from typing import Any, cast

from zbot.interfaces.registry import get_service


class LateService:
    """Stands for a service class until the first request comes.

    Args:
        name: Full name, `rcl_interfaces/srv/GetParameters`; must be the name of a service.
    """

    def __init__(self, name: str) -> None:
        self._name = name

    @cached_property
    def Request(self) -> Any:  # noqa: N802 - as in a service class
        """The request's class."""
        return cast("Any", get_service(self._name)).Request

    @cached_property
    def Response(self) -> Any:  # noqa: N802 - as in a service class
        """The response's class."""
        return cast("Any", get_service(self._name)).Response
