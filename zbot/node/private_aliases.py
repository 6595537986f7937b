"""What rclpy's nodes keep behind names that begin with `_`, and programs use all the same."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup


class _Alias:
    """Reads something of a node; a program may set an attribute of that name for itself."""

    def __init__(self, path: str) -> None:
        self._read: Callable[[Any], Any] = attrgetter(path)

    def __get__(self, node: Any, owner: type[Any]) -> Any:
        return self if node is None else self._read(node)


class PrivateAliases:
    """A node's logger, clock and lists, as `self._logger.info(...)` finds them in rclpy.

    The lists are the node's own, so what is taken out of one is not destroyed with the node.
    """

    _logger: Any = _Alias("_zbot_logger")
    _clock: Any = _Alias("_zbot_state.clock")
    _context: Any = _Alias("_zbot_state.context")
    _publishers: Any = _Alias("_zbot_state.publishers")
    _subscriptions: Any = _Alias("_zbot_state.subscriptions")
    _services: Any = _Alias("_zbot_state.services")
    _clients: Any = _Alias("_zbot_state.clients")
    _timers: Any = _Alias("_zbot_state.timers")
    _guards: Any = _Alias("_zbot_state.guards")
    _default_callback_group: Any = _Alias("_zbot_state.default_callback_group")

    @property
    def default_callback_group(self) -> CallbackGroup:
        """Where callbacks belong that were given no group; a subclass may choose another."""
        group: CallbackGroup = self._default_callback_group
        return group
