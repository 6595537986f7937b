"""Private attributes of rclpy's nodes that programs use although they are private."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup


class Alias:
    """Read-only alias of an attribute. A program may use the alias's name for its own attribute.

    Args:
        path: The attribute, e.g. `_zbot_state.clock`.
        convert: Function whose result is the alias's value.
    """

    def __init__(self, path: str, convert: Callable[[Any], Any] = lambda value: value) -> None:
        self._read: Callable[[Any], Any] = attrgetter(path)
        self._convert = convert

    def __get__(self, node: Any, owner: type[Any]) -> Any:
        return self if node is None else self._convert(self._read(node))


class PrivateAliases:
    """A node's logger, clock and lists under rclpy's names, as in `self._logger.info(...)`.

    The lists are the node's own lists. If a program removes an entity from a list, the node does
    not destroy this entity.
    """

    _logger: Any = Alias("_zbot_logger")
    _clock: Any = Alias("_zbot_state.clock")
    _context: Any = Alias("_zbot_state.context")
    _publishers: Any = Alias("_zbot_state.publishers")
    _subscriptions: Any = Alias("_zbot_state.subscriptions")
    _services: Any = Alias("_zbot_state.services")
    _clients: Any = Alias("_zbot_state.clients")
    _timers: Any = Alias("_zbot_state.timers")
    _guards: Any = Alias("_zbot_state.guards")
    _default_callback_group: Any = Alias("_zbot_state.default_callback_group")

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of entities that were created without a group. A subclass may override this."""
        group: CallbackGroup = self._default_callback_group
        return group
