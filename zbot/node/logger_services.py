"""Services of a node to get and set the levels of its process's loggers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.log import get_logger_level, set_logger_level
from zbot.log.errors import InvalidSeverityError

if TYPE_CHECKING:
    from zbot.node.entities import NodeEntities

_INVALID_LEVEL = "Failed reason: Invalid logger level."  # rclpy's text, which programs compare


class LoggingService:
    """Serves `~/get_logger_levels` and `~/set_logger_levels`.

    Nodes that are created with `enable_logger_service=True` have these services.

    Args:
        node: The node that offers the services. Its executor runs their callbacks.
    """

    def __init__(self, node: NodeEntities) -> None:
        from rcl_interfaces.srv import (  # noqa: PLC0415 - the import makes the class
            GetLoggerLevels,
            SetLoggerLevels,
        )

        node.create_service(GetLoggerLevels, "~/get_logger_levels", self._get)
        node.create_service(SetLoggerLevels, "~/set_logger_levels", self._set)

    @staticmethod
    def _get(request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import LoggerLevel  # noqa: PLC0415 - the import makes the class

        response.levels = [
            LoggerLevel(name=name, level=get_logger_level(name)) for name in request.names
        ]
        return response

    @staticmethod
    def _set(request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import SetLoggerLevelsResult  # noqa: PLC0415 - the import makes the class

        for level in request.levels:
            result = SetLoggerLevelsResult(successful=True)
            try:
                set_logger_level(level.name, level.level)
            except InvalidSeverityError:
                result = SetLoggerLevelsResult(successful=False, reason=_INVALID_LEVEL)
            response.results.append(result)
        return response
