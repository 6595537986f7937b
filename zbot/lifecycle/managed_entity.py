"""Managed entities: objects with callbacks for the transitions of a managed node."""

from __future__ import annotations

from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar, overload

from zbot.lifecycle.state_machine import TransitionCallbackReturn
from zbot.log import get_logger
from zbot.node.publisher import Publisher

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.lifecycle.state_machine import LifecycleState

    Action = Callable[..., Any]

MsgT = TypeVar("MsgT")


class ManagedEntity:
    """Base class with a callback for each transition of the node.

    Each callback gets the state before the transition. A callback that is not overridden returns
    SUCCESS.
    """

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Prepare: read parameters, create publishers and subscriptions, allocate memory."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Release everything that `on_configure` created."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Release everything. No transition follows."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Begin to work."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Pause."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Clean up after an error. The node is unconfigured after SUCCESS, otherwise finalized."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """Managed entity that knows whether its node is active."""

    def __init__(self) -> None:
        self._enabled = False

    @property
    def is_activated(self) -> bool:
        """Whether the node is active."""
        return self._enabled

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Begin to work."""
        self._enabled = True
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Pause."""
        self._enabled = False
        return TransitionCallbackReturn.SUCCESS

    @overload
    @staticmethod
    def when_enabled(
        wrapped: None = None, *, when_not_enabled: Callable[[], Any] | None = None
    ) -> Callable[[Action], Action]: ...

    @overload
    @staticmethod
    def when_enabled(
        wrapped: Action, *, when_not_enabled: Callable[[], Any] | None = None
    ) -> Action: ...

    @staticmethod
    def when_enabled(
        wrapped: Action | None = None, *, when_not_enabled: Callable[[], Any] | None = None
    ) -> Action | Callable[[Action], Action]:
        """Decorate a method, so that it runs only while the node is active.

        Args:
            wrapped: The method.
            when_not_enabled: Function that is called instead while the node is not active. The
                method then returns the function's result, or `None` without such a function.
        """

        def decorate(method: Action) -> Action:
            @wraps(method)
            def work_if_active(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> Any:
                if self.is_activated:
                    return method(self, *args, **kwargs)
                return when_not_enabled() if when_not_enabled is not None else None

            return work_if_active

        return decorate if wrapped is None else decorate(wrapped)


class LifecyclePublisher(SimpleManagedEntity, Publisher[MsgT]):
    """Publishes only while its node is active.

    `LifecycleNode.create_lifecycle_publisher` creates such publishers.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)
        self._has_warned = False

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Publish from now on."""
        self._has_warned = False
        return SimpleManagedEntity.on_activate(self, state)

    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message. While the node is not active, drop each message, and log one warning.

        This method raises the errors of `zbot.Publisher.publish`.
        """
        if self.is_activated:
            Publisher.publish(self, msg)
        elif not self._has_warned:
            self._has_warned = True
            get_logger(self.logger_name).warning(
                f"a message on {self.topic_name} was dropped: the node is not active "
                "(no more warnings come until the node is active)"
            )
