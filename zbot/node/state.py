"""State of a node: its names, its entities and its parameters."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.errors import InvalidHandleError
from zbot.errors.call_source import called_function
from zbot.errors.suggestion import nearest
from zbot.executor.callback_group import CallbackGroup, MutuallyExclusiveCallbackGroup
from zbot.executor.clock import ROSClock
from zbot.executor.forgotten_spin import callback_place, note_callback, waiting_text
from zbot.executor.ready_queue import ReadyQueue
from zbot.executor.waitable import WaitableEntity
from zbot.interfaces import type_hash, type_name
from zbot.log import get_logger
from zbot.names import (
    expand_topic_name,
    is_hidden,
    validate_full_topic_name,
    validate_topic_name,
)
from zbot.node.diagnostics import GivenParameters, diagnostics_of
from zbot.parameters.store import ParameterStore
from zbot.process import fork
from zbot.process.main_part import is_program
from zbot.wire.tokens import EndpointToken, NodeToken

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.guard_condition import GuardCondition
    from zbot.executor.spinnable import NodeExecutor
    from zbot.executor.timer import Rate, Timer
    from zbot.executor.waitable import Waitable
    from zbot.node.client import Client
    from zbot.node.publisher import Publisher
    from zbot.node.service import Service
    from zbot.node.subscription import Subscription
    from zbot.parameters.ros_args import Arguments
    from zbot.parameters.store import Changes
    from zbot.qos import QoSProfile
    from zbot.wire.tokens import EntityKind

_SPIN_DELAY_S = 10.0  # a program may load data before it spins
_LONG_PERIOD_S = 100.0  # few timers have such a period, but many have as many milliseconds


class NodeState:
    """State of a node. The node keeps this object in a single attribute.

    So a `Node` subclass can use names such as `timer`, `publisher`, `name` and `_state` for itself.

    Args:
        context: The context of the node.
        arguments: The command line that applies to the node.
        name: Base name, remapped.
        namespace: Absolute namespace, remapped.
    """

    def __init__(self, context: Context, arguments: Arguments, name: str, namespace: str) -> None:
        self.context = context
        self.arguments = arguments
        self.ready_queue = ReadyQueue()
        self.executor: NodeExecutor | None = None
        self.default_callback_group: CallbackGroup = MutuallyExclusiveCallbackGroup()
        self.publishers: list[Publisher[Any]] = []
        self.subscriptions: list[Subscription[Any]] = []
        self.services: list[Service[Any, Any]] = []
        self.clients: list[Client[Any, Any]] = []
        self.timers: list[Timer] = []
        self.guards: list[GuardCondition] = []
        self.rates: list[Rate] = []
        self.waitables: list[WaitableEntity] = []
        self.clock = ROSClock()
        self.parameters = ParameterStore(self._publish_changes)
        self.parameter_events: Publisher[Any] | None = None
        self.is_destroyed = False
        self._used_names: set[str] = set()  # full names before remapping
        self._first_callback = ""  # line and function of the program that created the first one
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._users = 0  # number of `with` blocks that use the node now
        token = NodeToken(
            domain=context.get_domain_id(),
            zid=context.zid,
            nid=0,
            namespace=namespace,
            node=name,
            enclave=arguments.enclave,
        )
        self.token = context.dialect.with_key(context.graph.numbers.numbered(token))
        with context.until_shutdown(f"the node {name!r}"):
            self.announcement = context.graph.announce(self.token)
        self.diagnostics = diagnostics_of(context)
        self.diagnostics.add(self.token, self.logger_name)

    @property
    def full_name(self) -> str:
        """The fully qualified name of the node."""
        return self.token.full_node_name

    @property
    def logger_name(self) -> str:
        """The full name with dots, as log lines show it."""
        return self.full_name[1:].replace("/", ".")

    def note_callback(self, call: str, callback: Any) -> None:
        """Note a callback. If it is the program's first for the node, warn later without a spin."""
        if self._first_callback:
            return
        place = callback_place(self.token.node, call, callback)
        if place:
            note_callback(place)
        # An object such as a `BasicNavigator` creates entities itself, and spins when it has to.
        if place and called_function() == call:
            self._first_callback = place
            waiting = self._waiting_text
            self.diagnostics.warn_later(self.logger_name, ("spin",), waiting, _SPIN_DELAY_S)

    def _waiting_text(self) -> str:
        if self.is_destroyed or self.ready_queue.was_attached:
            return ""
        return waiting_text(self._first_callback, _SPIN_DELAY_S)

    def check_parameters(self) -> None:
        """Warn later of given parameters that the node does not declare."""
        on_command_line = self.arguments.names_for(self.token.node)
        self.diagnostics.add_parameters(
            GivenParameters(
                self.parameters,
                on_command_line,
                self.logger_name,
                was_spun=lambda: self.ready_queue.was_attached,
            )
        )

    def check_remaps(self) -> None:
        """Warn later of remappings that may have a misspelt name, if there are remappings."""
        if self.arguments.remaps:
            self.diagnostics.warn_later(self.logger_name, ("remap",), self._remap_text)

    def _remap_text(self) -> str:
        used = sorted(self._used_names)
        for source in self.arguments.remapped_names(self.token.node, self.token.namespace):
            guess = None if source in used else nearest(source, used)
            if guess is not None:
                return (
                    f"the remapping of {source} has no effect, but this node uses {guess}: "
                    "is one of the names misspelt?"
                )
        return ""

    def note_period(self, period_s: float) -> None:
        """Tell a user who may have given a timer's period in milliseconds."""
        if period_s >= _LONG_PERIOD_S and is_program() and not is_hidden(self.token.node):
            get_logger(self.logger_name).info(
                f"create_timer({period_s:g}): the first call comes after {period_s:g} seconds; "
                f"for {period_s:g} milliseconds, write {period_s / 1000:g}"
            )

    def resolve(self, name: str, *, is_service: bool, only_expand: bool = False) -> str:
        """Return the full name of a topic or service, remapped if `only_expand` is false."""
        validate_topic_name(name, is_service=is_service)
        full = expand_topic_name(name, self.token.node, self.token.namespace)
        validate_full_topic_name(full, is_service=is_service)
        if only_expand:
            return full
        self._used_names.add(full)
        node, namespace = self.token.node, self.token.namespace
        return self.arguments.remapped(full, node, namespace, is_service=is_service)

    def endpoint(
        self, kind: EntityKind, name: str, msg_type: type[Any], qos: QoSProfile
    ) -> EndpointToken:
        """Return the token of a new endpoint of this node."""
        return self.named_endpoint(kind, name, (type_name(msg_type), type_hash(msg_type)), qos)

    def named_endpoint(
        self,
        kind: EntityKind,
        name: str,
        named_type: tuple[str, str],
        qos: QoSProfile,
        owner: NodeToken | None = None,
    ) -> EndpointToken:
        """Return the token of a new endpoint whose type is given by its name and hash.

        Args:
            kind: The kind of endpoint.
            name: Full name of the topic or service.
            named_type: Name and hash of the type.
            qos: The endpoint's profile.
            owner: Token of the node that the endpoint belongs to. By default, this is this node.
        """
        dialect, owner = self.context.dialect, owner or self.token
        token = EndpointToken(
            domain=dialect.domain_of(self.token.domain, name),
            zid=owner.zid,
            nid=owner.nid,
            eid=0,
            kind=kind,
            namespace=owner.namespace,
            node=owner.node,
            enclave=owner.enclave,
            name=name,
            type_name=named_type[0],
            type_hash=named_type[1],
            qos=qos,
        )
        return dialect.with_key(self.context.graph.numbers.numbered(token))

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Let the node's executor run a waitable that the program defines."""
        entity = WaitableEntity(waitable, self.ready_queue)
        self.waitables.append(entity)
        self.ready_queue.add(entity)

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Remove a waitable. Nothing happens if the node does not have it."""
        for entity in [known for known in self.waitables if known.waitable is waitable]:
            self.waitables.remove(entity)
            self.ready_queue.remove(entity)
            entity.destroy()

    def destroy_when_not_in_use(self) -> None:
        """Destroy the node immediately. This method's name comes from rclpy."""
        for node in self.context.nodes:
            if node.handle is self:
                node.destroy_node()

    def __enter__(self) -> NodeState:
        with self._lock:
            # As in rclpy, a destroyed node stays usable until the end of the outermost block.
            if self.is_destroyed and not self._users:
                raise InvalidHandleError(f"the node {self.full_name}")
            self._users += 1
        return self

    def __exit__(self, *exc_info: object) -> None:
        """End the use of the node."""
        with self._lock:
            self._users -= 1

    def add(self, entity: Any) -> None:
        """Let the node's executor run the callbacks of an entity."""
        entity.callback_group.add_entity(entity)
        self.ready_queue.add(entity)

    def _publish_changes(self, changes: Changes) -> None:
        """Publish changes of parameters on `/parameter_events`."""
        publisher = self.parameter_events
        if publisher is not None and publisher.is_open:
            publisher.publish(
                publisher.msg_type(
                    stamp=self.clock.now().to_msg(),
                    node=self.full_name,
                    new_parameters=[parameter.to_parameter_msg() for parameter in changes.new],
                    changed_parameters=[
                        parameter.to_parameter_msg() for parameter in changes.changed
                    ],
                    deleted_parameters=[
                        parameter.to_parameter_msg() for parameter in changes.deleted
                    ],
                )
            )

    def leave_to_parent(self) -> None:
        """In a forked child, leave all entities to the parent process."""
        fork.keep(dict(vars(self)), self.ready_queue.entities)
        for publisher in self.publishers:
            publisher.leave_to_parent()

    def destroy(self) -> None:
        """Destroy all entities of the node.

        Endpoints of one kind are destroyed in reverse order of creation.
        """
        owned: tuple[Timer | Rate | GuardCondition, ...] = (
            *self.timers,
            *self.rates,
            *self.guards,
        )
        for entity in (*owned, *self.waitables):
            entity.destroy()
        for served in (*reversed(self.services), *reversed(self.clients)):
            self.diagnostics.remove(served.token)
            served.destroy()
        for endpoint in (*reversed(self.subscriptions), *reversed(self.publishers)):
            self.diagnostics.remove(endpoint.token)
            endpoint.destroy()
        self._forget_all()
        self.diagnostics.remove(self.token)
        self.context.undeclare(self.announcement)

    def _forget_all(self) -> None:
        lists: tuple[list[Any], ...] = (
            *(self.timers, self.rates, self.guards, self.waitables),
            *(self.services, self.clients, self.subscriptions, self.publishers),
        )
        for owned in lists:
            owned.clear()
