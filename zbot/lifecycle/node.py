"""Managed nodes: they are configured, activated, paused and shut down from outside."""

from __future__ import annotations

import traceback
from collections.abc import Coroutine
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.errors import ArgumentTypeError, ExternalShutdownException
from zbot.lifecycle.errors import CallbackReturnError, NotAManagedEntityError, NotANodeError
from zbot.lifecycle.managed_entity import ManagedEntity, SimpleManagedEntity
from zbot.lifecycle.publisher import LifecyclePublisher
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
from zbot.process.signals import user_part

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


class _Life:
    """What a managed node keeps for itself.

    It is one attribute, so that students can call theirs what they like.
    """

    def __init__(self) -> None:
        self.machine = StateMachine()
        self.entities: list[ManagedEntity] = []
        self.services: LifecycleServices | None = None

    def trigger(self, wanted: str | int) -> None:
        transition = self.machine.trigger(wanted)
        if self.services is not None:
            self.services.tell(transition)


class LifecycleNodeMixin(ManagedEntity):
    """Makes a `Node` a managed one; its constructor is to be called after that of `Node`.

    Args:
        enable_communication_interface: Whether other programs see its state and can change it.
        callback_group: Where the services for that run; the node's own if left out.

    Raises:
        NotANodeError: `Node` is missing among the base classes.
        ArgumentTypeError: `enable_communication_interface` is no bool.
    """

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
        self._zbot_life = life = _Life()
        if enable_communication_interface:
            life.services = LifecycleServices(
                node, life.machine, self._zbot_change_state, callback_group
            )

    def _zbot_node(self) -> Node:
        if not isinstance(self, Node):
            raise NotANodeError(type(self))
        return self

    @cached_property
    def _state_machine(self) -> StateMachine:
        # rclpy's private name, by which programs ask for `current_state`. It is no property,
        # because a student may give a machine of their own that name.
        return self._zbot_life.machine

    # -- transitions ---------------------------------------------------------------------------

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Make an unconfigured node inactive; return what its callback said."""
        return self._zbot_change_state("configure")

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Make an inactive node unconfigured; return what its callback said."""
        return self._zbot_change_state("cleanup")

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Make an inactive node active; return what its callback said."""
        return self._zbot_change_state("activate")

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Make an active node inactive; return what its callback said."""
        return self._zbot_change_state("deactivate")

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """End the node's life; return what its callback said.

        Raises:
            TransitionNotPossibleError: It is over already, or a transition is under way.
        """
        self._zbot_life.machine.find("shutdown")
        return self._zbot_change_state("shutdown")

    def _zbot_change_state(self, wanted: str | int) -> TransitionCallbackReturn:
        life = self._zbot_life
        start = life.machine.state
        try:
            life.trigger(wanted)
        except TransitionNotPossibleError as error:
            self._zbot_node().get_logger().error(str(error))
            return TransitionCallbackReturn.ERROR
        outcome = self._zbot_finish(start)
        if outcome is TransitionCallbackReturn.ERROR:
            self._zbot_finish(start)  # with on_error
        if life.machine.state != ACTIVE:
            self._zbot_switch_off(start)
        return outcome

    def _zbot_finish(self, start: LifecycleState) -> TransitionCallbackReturn:
        """Run the callback of the state in which the node is, and leave the state."""
        life = self._zbot_life
        outcome = self._zbot_run(_CALLBACKS[life.machine.state], start)
        life.trigger(outcome.to_label())
        return outcome

    def _zbot_run(self, callback: str, start: LifecycleState) -> TransitionCallbackReturn:
        try:
            return _call(self, callback, start)
        except ExternalShutdownException:
            raise
        except Exception as error:  # noqa: BLE001 - a user's callback: the machine handles it
            lines = traceback.format_exception(type(error), error, user_part(error.__traceback__))
            self._zbot_node().get_logger().error(
                f"{callback}() failed in the transition from {start.label}:\n" + "".join(lines)
            )
            return TransitionCallbackReturn.ERROR

    def _zbot_switch_off(self, start: LifecycleState) -> None:
        # Whatever callbacks did or forgot: nothing simple works in a node that is not active.
        for entity in self._zbot_life.entities:
            if isinstance(entity, SimpleManagedEntity):
                SimpleManagedEntity.on_deactivate(entity, start)

    # -- callbacks -----------------------------------------------------------------------------

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Get ready; by default, let the managed entities do so until one does not succeed."""
        return self._zbot_tell_entities("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Undo `on_configure`; by default, let the managed entities do so."""
        return self._zbot_tell_entities("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Give everything back; by default, let the managed entities do so."""
        return self._zbot_tell_entities("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Begin to work; by default, let the managed entities do so, publishers among them.

        Whoever overrides it calls `super().on_activate(state)` at the end.
        """
        return self._zbot_tell_entities("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Pause; by default, let the managed entities do so."""
        return self._zbot_tell_entities("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up after an error; by default, let the managed entities do so."""
        return self._zbot_tell_entities("on_error", state)

    def _zbot_tell_entities(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in list(self._zbot_life.entities):
            outcome = _call(entity, callback, state)
            if outcome is not TransitionCallbackReturn.SUCCESS:
                return outcome
        return TransitionCallbackReturn.SUCCESS

    # -- managed entities ----------------------------------------------------------------------

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Tell an entity of each transition from now on.

        Raises:
            NotAManagedEntityError: It does not know of transitions.
        """
        if not isinstance(entity, ManagedEntity):
            raise NotAManagedEntityError(entity)
        if entity not in self._zbot_life.entities:
            self._zbot_life.entities.append(entity)

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
            qos_profile: A profile, or the depth of the default one.
            callback_group: Where its events' callbacks run; the node's own if left out.
            event_callbacks: A `PublisherEventCallbacks`.
            qos_overriding_options: Which policies parameters may override.

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
        """Destroy a managed publisher; return whether it was this node's."""
        if publisher in self._zbot_life.entities:
            self._zbot_life.entities.remove(publisher)
        return Node.destroy_publisher(self._zbot_node(), publisher)


def _call(entity: ManagedEntity, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
    function: Callable[[LifecycleState], object] = getattr(entity, callback)
    outcome = function(state)
    if not isinstance(outcome, TransitionCallbackReturn):
        if isinstance(outcome, Coroutine):
            outcome.close()  # nobody is going to await it
        raise CallbackReturnError(entity, callback, outcome)
    return outcome


class LifecycleNode(LifecycleNodeMixin, Node):
    """A managed node: other programs configure, activate, pause and shut it down.

    Args:
        node_name: Base name: letters, digits and `_`.
        enable_communication_interface: Whether other programs see its state and can change it.
        **kwargs: Options of `zbot.Node`.

    Raises:
        InvalidNodeNameError: The name breaks ROS 2's grammar.
        NotInitializedError: `init()` was not called, or `shutdown()` was.
    """

    def __init__(
        self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any
    ) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(
            self, enable_communication_interface=enable_communication_interface
        )
