"""What lives along with a managed node."""

from __future__ import annotations

from functools import wraps
from typing import TYPE_CHECKING, Any, overload

from zbot.lifecycle.state_machine import TransitionCallbackReturn

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.lifecycle.state_machine import LifecycleState

    Action = Callable[..., Any]


class ManagedEntity:
    """Something that is told of each transition of its node.

    Each method gets the state that the node comes from, and succeeds unless it is overridden.
    """

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Get ready: read parameters, make publishers and subscriptions, take memory."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Give back what `on_configure` took."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Give everything back: no transition follows."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Begin to work."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Pause."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:  # noqa: ARG002
        """Clean up after an error; the node is unconfigured after success, else finalized."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """An entity that knows whether its node is active."""

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
        """Decorate a method that does its work only while the node is active.

        Args:
            wrapped: The method.
            when_not_enabled: Called instead while the node is not active, and its result is the
                method's; `None` if left out.
        """

        def decorate(method: Action) -> Action:
            @wraps(method)
            def work_if_active(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> Any:
                if self.is_activated:
                    return method(self, *args, **kwargs)
                return when_not_enabled() if when_not_enabled is not None else None

            return work_if_active

        return decorate if wrapped is None else decorate(wrapped)
