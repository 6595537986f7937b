"""Creation and destruction of a node's entities: publishers, timers and all others."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast, overload

from zbot.errors import ArgumentTypeError, InvalidHandleError
from zbot.executor.callback_check import check_callback, unless_called
from zbot.executor.guard_condition import GuardCondition
from zbot.executor.timer import Rate, Timer, check_timer_callback
from zbot.interfaces.python_class import check_is_valid_msg_type, check_is_valid_srv_type
from zbot.names import ACTION_PART
from zbot.node.argument_check import (
    check_object,
    check_order,
    is_class,
    is_name,
    is_number,
    is_profile,
    seconds,
)
from zbot.node.client import Client
from zbot.node.diagnostics import MOST_EQUAL
from zbot.node.errors import InvalidPeriodError
from zbot.node.event_callbacks import PublisherEventCallbacks, SubscriptionEventCallbacks
from zbot.node.private_aliases import PrivateAliases
from zbot.node.publisher import Publisher
from zbot.node.service import Service
from zbot.node.subscription import Subscription
from zbot.qos import QoSProfile, as_profile, qos_profile_services_default
from zbot.time import S_TO_NS
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import Clock
    from zbot.executor.waitable import Waitable
    from zbot.node.message_decoder import ContentFilterOptions
    from zbot.node.state import NodeState
    from zbot.parameters.qos_overrides import QoSOverridingOptions

MsgT = TypeVar("MsgT")
EntityT = TypeVar("EntityT")


class _Listing:
    """Iterator over entities of a node, e.g. `timers`. A `Node` subclass may override it.

    As in rclpy, it leaves out the topics and services of actions.
    """

    def __init__(self, attribute: str, name: str = "") -> None:
        self._read: Callable[[Any], list[Any]] = attrgetter(f"_zbot_state.{attribute}")
        self._name = name  #: attribute with an entity's topic or service

    @overload
    def __get__(self, node: None, owner: type[NodeEntities]) -> _Listing: ...
    @overload
    def __get__(self, node: NodeEntities, owner: type[NodeEntities]) -> Iterator[Any]: ...
    def __get__(
        self, node: NodeEntities | None, owner: type[NodeEntities]
    ) -> _Listing | Iterator[Any]:
        if node is None:  # read on the class, e.g. by inspect.getmembers
            return self
        found = self._read(node).copy()
        if self._name:
            found = [each for each in found if ACTION_PART not in getattr(each, self._name, "")]
        return iter(found)


class NodeEntities(PrivateAliases):
    """rclpy's methods of a node that create and destroy entities."""

    _zbot_state: NodeState

    @property
    def handle(self) -> NodeState:
        """The node's internal state, which user code must not use."""
        return self._zbot_state

    publishers = _Listing("publishers", "topic_name")
    subscriptions = _Listing("subscriptions", "topic_name")
    services = _Listing("services", "service_name")
    clients = _Listing("clients", "service_name")
    timers = _Listing("timers")
    guards = _Listing("guards")

    def create_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher[Any]] = Publisher,
    ) -> Publisher[MsgT]:
        """Create a publisher.

        Args:
            msg_type: Message class.
            topic: Relative, `~/private` or absolute name.
            qos_profile: A profile, or a depth for the default profile.
            callback_group: Group of the event callbacks. `None` means the node's default group.
            event_callbacks: Callbacks for QoS events, a `PublisherEventCallbacks`.
            qos_overriding_options: The QoS policies that parameters may override.
            publisher_class: The class of the publisher, `Publisher` or a subclass.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: `msg_type` is not a message class.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_order(
            "create_publisher", (msg_type, is_class), (topic, is_name), (qos_profile, is_profile)
        )
        check_is_valid_msg_type(msg_type)
        name = handle.resolve(topic, is_service=False)
        qos = self._zbot_overridden("publisher", name, qos_profile, qos_overriding_options)
        events = event_callbacks or PublisherEventCallbacks()
        check_object("event_callbacks", events, "PublisherEventCallbacks", "attach")
        group = self._zbot_group(callback_group)
        token = handle.endpoint(EntityKind.PUBLISHER, name, msg_type, qos)
        with handle.context.until_shutdown(f"the node {handle.full_name}"):
            publisher = publisher_class(
                handle.context,
                msg_type,
                token,
                logger_name=handle.logger_name,
                callback_group=group,
            )
        publisher.topic = topic
        handle.publishers.append(publisher)
        handle.diagnostics.add(token, handle.logger_name)
        events.attach(publisher, handle.ready_queue, handle.context.graph)
        return cast("Publisher[MsgT]", publisher)

    def create_subscription(
        self,
        msg_type: type[MsgT],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool | Literal["payload"] = False,
        content_filter_options: ContentFilterOptions | None = None,
    ) -> Subscription[MsgT]:
        """Create a subscription.

        Args:
            msg_type: Message class.
            topic: Relative, `~/private` or absolute name.
            callback: Takes the message, or the message and its `MessageInfo`.
            qos_profile: A profile, or a depth for the default profile.
            callback_group: Group of the callback. `None` means the node's default group.
            event_callbacks: Callbacks for QoS events, a `SubscriptionEventCallbacks`.
            qos_overriding_options: The QoS policies that parameters may override.
            raw: Whether the callback takes each message as bytes in ROS 2's CDR. With
                `"payload"`, the callback takes the bytes that were sent.
            content_filter_options: Expression that selects messages. `None` selects all messages.

        Raises:
            InvalidTopicNameError: The name breaks ROS 2's grammar.
            WrongTypeError: The callback is not callable.
            WrongStateError: The number of the callback's arguments is not 1 or 2.
            ContentFilterError: The expression does not fit the type.
            NotAMessageTypeError: `msg_type` is not a message class.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_order(
            "create_subscription",
            (msg_type, is_class),
            (topic, is_name),
            (callback, callable),
            (qos_profile, is_profile),
        )
        check_is_valid_msg_type(msg_type)
        name = handle.resolve(topic, is_service=False)
        qos = self._zbot_overridden("subscription", name, qos_profile, qos_overriding_options)
        events = event_callbacks or SubscriptionEventCallbacks()
        check_object("event_callbacks", events, "SubscriptionEventCallbacks", "attach")
        with handle.context.until_shutdown(f"the node {handle.full_name}"):
            subscription = Subscription(
                handle.context,
                msg_type,
                callback,
                handle.endpoint(EntityKind.SUBSCRIPTION, name, msg_type, qos),
                ready_queue=handle.ready_queue,
                callback_group=self._zbot_group(callback_group),
                raw=raw,
                logger_name=handle.logger_name,
                content_filter=content_filter_options,
            )
            subscription.topic = topic
            handle.subscriptions.append(subscription)
            handle.diagnostics.add(subscription.token, handle.logger_name)
            handle.add(subscription)
            handle.note_callback("create_subscription", callback)
            events.attach(subscription, handle.ready_queue, handle.context.graph)
            subscription.start()
        return subscription

    def create_service(
        self,
        srv_type: type[Any],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile | int = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service[Any, Any]:
        """Create a service.

        Args:
            srv_type: Service class.
            srv_name: Relative, `~/private` or absolute name.
            callback: Takes a request and an empty response, and returns a response. The
                callback may be a coroutine function.
            qos_profile: A profile, or a depth for the default profile. The graph shows the profile.
                The profile has no other effect.
            callback_group: Group of the callback. `None` means the node's default group.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: `srv_type` is not a service class.
            WrongTypeError: The callback is not callable.
            WrongStateError: The callback does not take two arguments.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_order(
            "create_service", (srv_type, is_class), (srv_name, is_name), (callback, callable)
        )
        check_is_valid_srv_type(srv_type)
        form = "(request, response)"
        check_callback("create_service", callback, form, position=2, may_do_nothing=True)
        name = handle.resolve(srv_name, is_service=True)
        with handle.context.until_shutdown(f"the node {handle.full_name}"):
            service: Service[Any, Any] = Service(
                handle.context,
                srv_type,
                callback,
                handle.endpoint(EntityKind.SERVICE, name, srv_type, as_profile(qos_profile)),
                ready_queue=handle.ready_queue,
                callback_group=self._zbot_group(callback_group),
                logger_name=handle.logger_name,
            )
        service.srv_name = srv_name
        handle.services.append(service)
        handle.note_callback("create_service", callback)
        handle.add(service)
        return service

    def create_client(
        self,
        srv_type: type[Any],
        srv_name: str,
        *,
        qos_profile: QoSProfile | int = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client[Any, Any]:
        """Create a client of a service.

        Args:
            srv_type: Service class.
            srv_name: Relative, `~/private` or absolute name.
            qos_profile: A profile, or a depth for the default profile. The graph shows the profile.
                The profile has no other effect.
            callback_group: Group of the futures' callbacks. `None` means the node's default group.

        Raises:
            InvalidServiceNameError: The name breaks ROS 2's grammar.
            NotAMessageTypeError: `srv_type` is not a service class.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_order("create_client", (srv_type, is_class), (srv_name, is_name))
        check_is_valid_srv_type(srv_type)
        name = handle.resolve(srv_name, is_service=True)
        with handle.context.until_shutdown(f"the node {handle.full_name}"):
            client: Client[Any, Any] = Client(
                handle.context,
                srv_type,
                handle.endpoint(EntityKind.CLIENT, name, srv_type, as_profile(qos_profile)),
                ready_queue=handle.ready_queue,
                callback_group=self._zbot_group(callback_group),
                logger_name=handle.logger_name,
            )
        client.srv_name = srv_name
        handle.clients.append(client)
        # The diagnostics do not check a tool's client, because they may subscribe to the tokens of
        # the service. After that, Zenoh answers the tool's queries for all tokens incompletely.
        if not handle.context.is_tool:
            handle.diagnostics.add(client.token, handle.logger_name)
        handle.add(client)
        return client

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer.

        Args:
            timer_period_sec: Seconds, 0 or more.
            callback: Called without arguments, or with a `TimerInfo`.
            callback_group: Group of the callback. `None` means the node's default group.
            clock: The clock that measures the period. `None` means the node's clock.
            autostart: Whether the timer starts now. Otherwise `reset()` starts the timer.

        Raises:
            InvalidPeriodError: The period is negative, too large or not a number.
            WrongTypeError: The callback is not callable.
            WrongStateError: The callback does not take these arguments.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_order("create_timer", (timer_period_sec, is_number), (callback, callable))
        period_s = seconds("a timer's period", timer_period_sec)
        check_timer_callback("create_timer", callback)
        if callback is not None:
            handle.note_callback("create_timer", callback)
            handle.note_period(period_s)
        return self._zbot_add_timer(period_s, callback, callback_group, clock, autostart)

    def _zbot_add_timer(
        self,
        period_s: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None,
        clock: Clock | None,
        autostart: bool,
    ) -> Timer:
        handle = self._zbot_state
        if clock is not None:
            check_object("clock", clock, "a clock, e.g. self.get_clock()", "now")
        timer = Timer(
            callback,
            self._zbot_group(callback_group),
            int(period_s * S_TO_NS),
            clock or handle.clock,
            handle.ready_queue,
            autostart=autostart,
            logger_name=handle.logger_name,
        )
        handle.timers.append(timer)
        handle.add(timer)
        if len(handle.timers) == MOST_EQUAL:
            handle.diagnostics.warn_of_many(handle.logger_name, "timers")
        return timer

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition. Its callback runs when any thread calls `trigger()`.

        Raises:
            WrongTypeError: The callback is not callable.
            WrongStateError: The callback needs an argument.
            InvalidHandleError: The node was destroyed.
        """
        handle = self._zbot_alive()
        check_callback("create_guard_condition", callback, "()", may_be_none=unless_called)
        group = self._zbot_group(callback_group)
        guard = GuardCondition(callback, group, ready_queue=handle.ready_queue)
        handle.guards.append(guard)
        handle.add(guard)
        return guard

    def add_waitable(self, waitable: Waitable[Any]) -> None:
        """Let the node's executor run a waitable that the program defines."""
        self._zbot_alive().add_waitable(waitable)

    def remove_waitable(self, waitable: Waitable[Any]) -> None:
        """Remove a waitable. Nothing happens if the node does not have it."""
        self._zbot_state.remove_waitable(waitable)

    @property
    def waitables(self) -> Iterator[Waitable[Any]]:
        """The waitables of the node."""
        return iter([entity.waitable for entity in self._zbot_state.waitables])

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate whose `sleep()` makes a loop run `frequency` times a second.

        Raises:
            ArgumentTypeError: The frequency is not a number.
            InvalidPeriodError: The frequency is not greater than 0, or is greater than 1e9.
        """
        handle = self._zbot_alive()
        if not is_number(frequency):
            raise ArgumentTypeError("a rate's frequency", "a number", frequency)
        if not 0 < frequency <= S_TO_NS:
            raise InvalidPeriodError("a rate's frequency", frequency)
        timer = self._zbot_add_timer(1 / float(frequency), None, None, clock, autostart=True)
        rate = Rate(timer, handle.context)
        handle.rates.append(rate)
        return rate

    def destroy_publisher(self, publisher: Publisher[Any]) -> bool:
        """Destroy a publisher, and return whether the node had it."""
        if publisher in self._zbot_state.publishers:
            self._zbot_state.diagnostics.remove(publisher.token)
        return self._zbot_remove(self._zbot_state.publishers, publisher)

    def destroy_subscription(self, subscription: Subscription[Any]) -> bool:
        """Destroy a subscription, and return whether the node had it."""
        if subscription in self._zbot_state.subscriptions:
            self._zbot_state.diagnostics.remove(subscription.token)
        return self._zbot_remove(self._zbot_state.subscriptions, subscription)

    def destroy_service(self, service: Service[Any, Any]) -> bool:
        """Destroy a service, and return whether the node had it."""
        return self._zbot_remove(self._zbot_state.services, service)

    def destroy_client(self, client: Client[Any, Any]) -> bool:
        """Destroy a client, and return whether the node had it."""
        if client in self._zbot_state.clients:
            self._zbot_state.diagnostics.remove(client.token)
        return self._zbot_remove(self._zbot_state.clients, client)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer, and return whether the node had it."""
        return self._zbot_remove(self._zbot_state.timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition, and return whether the node had it."""
        return self._zbot_remove(self._zbot_state.guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate, and return whether the node had it."""
        handle = self._zbot_state
        return self._zbot_remove(handle.rates, rate) and self._zbot_remove(
            handle.timers, rate.timer
        )

    def _zbot_remove(self, owned: list[EntityT], entity: EntityT) -> bool:
        if entity not in owned:
            return False
        owned.remove(entity)
        self._zbot_state.ready_queue.remove(cast("Any", entity))
        cast("Any", entity).destroy()
        return True

    def _zbot_overridden(
        self,
        entity: str,
        topic: str,
        qos: QoSProfile | int,
        options: QoSOverridingOptions | None,
    ) -> QoSProfile:
        """Return the profile after the node's parameters have overridden its policies."""
        profile = as_profile(qos)
        if options is None:
            return profile
        from zbot.parameters.qos_overrides import overridden  # noqa: PLC0415 - few nodes have options

        return overridden(self._zbot_state.parameters, entity, topic, profile, options)

    def _zbot_group(self, group: CallbackGroup | None) -> CallbackGroup:
        if group is None:
            return self.default_callback_group
        check_object("callback_group", group, "a callback group", "add_entity")
        return group

    def _zbot_alive(self) -> NodeState:
        handle = self._zbot_state
        if handle.is_destroyed:
            raise InvalidHandleError(f"the node {handle.full_name}")
        if handle.context.is_over:
            handle.context.require_valid(f"the node {handle.full_name}")
        return handle
