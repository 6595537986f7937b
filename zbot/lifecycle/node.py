"""Managed nodes, and the mixin class that makes a `Node` a managed node."""

from __future__ import annotations

import traceback
from collections.abc import Coroutine
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.errors import ArgumentTypeError, ExternalShutdownException
from zbot.executor.callback_check import check_callback
from zbot.executor.set_by_init import set_by_init
from zbot.lifecycle.errors import CallbackReturnError, NotAManagedEntityError, NotANodeError
from zbot.lifecycle.managed_entity import LifecyclePublisher, ManagedEntity, SimpleManagedEntity
from zbot.lifecycle.services import LifecycleServices
from zbot.lifecycle.state_machine import (
    ACTIVATING,
    ACTIVE,
    CLEANING_UP,
    CONFIGURING,
    DEACTIVATING,
    ERROR_PROCESSING,
    SHUTTING_DOWN,
    StateMachine,
    TransitionCallbackReturn,
    TransitionNotPossibleError,
)
from zbot.node.node import Node
from zbot.process.hooks import user_traceback

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.lifecycle.state_machine import LifecycleState
    from zbot.node.publisher import Publisher
    from zbot.qos import QoSProfile

MsgT = TypeVar("MsgT")

_CALLBACKS = {
    CONFIGURING: "on_configure",
    CLEANING_UP: "on_cleanup",
    SHUTTING_DOWN: "on_shutdown",
    ACTIVATING: "on_activate",
    DEACTIVATING: "on_deactivate",
    ERROR_PROCESSING: "on_error",
}


class _LifecycleData:
    """The private data of a managed node.

    The node holds this object in one attribute, so that programs can use almost any other name.
    """

    def __init__(self) -> None:
        self.machine = StateMachine()
        self.entities: list[ManagedEntity] = []
        self.services: LifecycleServices | None = None

    def trigger(self, wanted: str | int) -> None:
        transition = self.machine.trigger(wanted)
        if self.services is not None:
            self.services.publish_event(transition)


class LifecycleNodeMixin(ManagedEntity):
    """Makes a `Node` a managed node. Call `Node`'s constructor before the mixin's constructor.

    Args:
        enable_communication_interface: Whether services let other programs see and change the
            node's state.
        callback_group: Group of these services. If left out, the node's default group is used.

    Raises:
        NotANodeError: `Node` is missing among the base classes.
        ArgumentTypeError: `enable_communication_interface` is not a bool.
    """

    _zbot_lifecycle: _LifecycleData = set_by_init("'my_node'")

    def __init__(
        self,
        *,
        enable_communication_interface: bool = True,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        if not isinstance(enable_communication_interface, bool):
            name = "enable_communication_interface"
            raise ArgumentTypeError(name, "a bool", enable_communication_interface)
        node = self._zbot_node()
        self._zbot_lifecycle = data = _LifecycleData()
        node.handle.parameters.may_grow = True  # `on_configure` may declare parameters
        if enable_communication_interface:
            data.services = LifecycleServices(
                node, data.machine, self._zbot_change_state, callback_group
            )

    def _zbot_node(self) -> Node:
        if not isinstance(self, Node):
            raise NotANodeError(type(self))
        return self

    @cached_property
    def _state_machine(self) -> StateMachine:
        # This is a private name of rclpy, but programs read its `current_state`. `cached_property`
        # lets a program assign its own state machine to the name.
        return self._zbot_lifecycle.machine

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Make an unconfigured node inactive. Return the result of `on_configure`."""
        return self._zbot_change_state("configure")

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Make an inactive node unconfigured. Return the result of `on_cleanup`."""
        return self._zbot_change_state("cleanup")

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Make an inactive node active. Return the result of `on_activate`."""
        return self._zbot_change_state("activate")

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Make an active node inactive. Return the result of `on_deactivate`."""
        return self._zbot_change_state("deactivate")

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Shut the node down. Return the result of `on_shutdown`.

        Raises:
            TransitionNotPossibleError: The node is finalized, or it is in a transition.
        """
        self._zbot_lifecycle.machine.find("shutdown")
        return self._zbot_change_state("shutdown")

    def _zbot_change_state(self, wanted: str | int) -> TransitionCallbackReturn:
        data = self._zbot_lifecycle
        start = data.machine.state
        try:
            data.trigger(wanted)
        except TransitionNotPossibleError as error:
            self._zbot_node().get_logger().error(str(error))
            return TransitionCallbackReturn.ERROR
        outcome = self._zbot_finish(start)
        if outcome is TransitionCallbackReturn.ERROR:
            self._zbot_finish(start)  # runs on_error
        if data.machine.state != ACTIVE:
            self._zbot_deactivate_entities(start)
        return outcome

    def _zbot_finish(self, start: LifecycleState) -> TransitionCallbackReturn:
        """Run the callback of the node's transition state, and leave that state."""
        data = self._zbot_lifecycle
        outcome = self._zbot_run(_CALLBACKS[data.machine.state], start)
        data.trigger(outcome.to_label())
        return outcome

    def _zbot_run(self, callback: str, start: LifecycleState) -> TransitionCallbackReturn:
        try:
            return _call(self, callback, start)
        except ExternalShutdownException:
            raise
        except Exception as error:  # noqa: BLE001 - the state machine handles errors of callbacks
            lines = traceback.format_exception(
                type(error), error, user_traceback(error.__traceback__)
            )
            self._zbot_node().get_logger().error(
                f"{callback}() failed in the transition from {start.label}:\n" + "".join(lines)
            )
            return TransitionCallbackReturn.ERROR

    def _zbot_deactivate_entities(self, start: LifecycleState) -> None:
        # If the node is inactive, each `SimpleManagedEntity` must be inactive, also if a callback
        # failed.
        for entity in self._zbot_lifecycle.entities:
            if isinstance(entity, SimpleManagedEntity):
                SimpleManagedEntity.on_deactivate(entity, start)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Prepare. By default, call the managed entities' callbacks until one does not succeed."""
        return self._zbot_call_entities("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Release what `on_configure` created. By default, call the managed entities."""
        return self._zbot_call_entities("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Release everything. By default, call the managed entities."""
        return self._zbot_call_entities("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Begin to work. By default, call the managed entities, such as publishers.

        An override must call `super().on_activate(state)` at its end.
        """
        return self._zbot_call_entities("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Pause. By default, call the managed entities."""
        return self._zbot_call_entities("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up after an error. By default, call the managed entities."""
        return self._zbot_call_entities("on_error", state)

    def _zbot_call_entities(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in list(self._zbot_lifecycle.entities):
            outcome = _call(entity, callback, state)
            if outcome is not TransitionCallbackReturn.SUCCESS:
                return outcome
        return TransitionCallbackReturn.SUCCESS

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Call an entity's callbacks at each transition from now on.

        Raises:
            NotAManagedEntityError: `entity` is not a `ManagedEntity`.
        """
        if not isinstance(entity, ManagedEntity):
            raise NotAManagedEntityError(entity)
        if entity not in self._zbot_lifecycle.entities:
            self._zbot_lifecycle.entities.append(entity)

    def create_lifecycle_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
    ) -> LifecyclePublisher[MsgT]:
        """Create a publisher that publishes only while the node is active.

        Args:
            msg_type: Message class.
            topic: Relative, `~/private` or absolute name.
            qos_profile: A profile, or the depth of the default profile.
            callback_group: Group of the event callbacks. If left out, the node's default group is
                used.
            event_callbacks: A `PublisherEventCallbacks`.
            qos_overriding_options: The policies that parameters may override.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
            InvalidHandleError: The node was destroyed.
        """
        publisher: Publisher[MsgT] = Node.create_publisher(
            self._zbot_node(),
            msg_type,
            topic,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            publisher_class=LifecyclePublisher,
        )
        managed = cast("LifecyclePublisher[MsgT]", publisher)
        self.add_managed_entity(managed)
        return managed

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher[Any]) -> bool:
        """Destroy a managed publisher. Return whether it belonged to this node."""
        if publisher in self._zbot_lifecycle.entities:
            self._zbot_lifecycle.entities.remove(publisher)
        return Node.destroy_publisher(self._zbot_node(), publisher)


def _call(entity: ManagedEntity, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
    function: Callable[[LifecycleState], object] = getattr(entity, callback)
    check_callback(callback, function, "(state)")
    outcome = function(state)
    if not isinstance(outcome, TransitionCallbackReturn):
        if isinstance(outcome, Coroutine):
            outcome.close()  # it is never awaited
        raise CallbackReturnError(entity, callback, outcome)
    return outcome


class LifecycleNode(LifecycleNodeMixin, Node):
    """A managed node. Other programs configure, activate, deactivate and shut it down.

    Args:
        node_name: Base name of letters, digits and `_`.
        enable_communication_interface: Whether other programs can see and change the node's state.
        **kwargs: Options of `zbot.Node`.

    Raises:
        InvalidNodeNameError: The name breaks ROS 2's grammar.
        NotInitializedError: `init()` was not called, or `shutdown()` was called.
    """

    def __init__(
        self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any
    ) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(
            self, enable_communication_interface=enable_communication_interface
        )
