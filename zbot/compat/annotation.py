"""Names of rclpy that only annotations need: nothing at run time depends on them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias, TypedDict, TypeVar

from zbot.interfaces.message import Service

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import ClockChange
    from zbot.node.qos_events import PublisherEventCallbacks
    from zbot.parameters.parameter import Parameter
    from zbot.parameters.qos_overrides import QoSOverridingOptions

    from builtin_interfaces.msg import Time
    from service_msgs.msg import ServiceEventInfo
    from unique_identifier_msgs.msg import UUID

GoalT = TypeVar("GoalT")
ResultT_co = TypeVar("ResultT_co", covariant=True)
FeedbackT_co = TypeVar("FeedbackT_co", covariant=True)

#: What can be a parameter's value: a truth value, number or text, or a list of one of these.
AllowableParameterValue: TypeAlias = Any
AllowableParameterValueT = TypeVar("AllowableParameterValueT")
CallbackNames: TypeAlias = Literal[
    "on_configure", "on_cleanup", "on_shutdown", "on_activate", "on_deactivate", "on_error"
]
#: What an event's callback gets: one of the info classes.
EventHandlerData: TypeAlias = Any
JumpHandlePreCallbackType: TypeAlias = Callable[[], None]
ClientGoalHandleDict: TypeAlias = dict[str, object]
ServerGoalHandleDict: TypeAlias = dict[str, object]
#: A value of a profile's policy: a member of one of its enums, a number or a duration.
QoSProfileAttributes: TypeAlias = Any
#: A function that takes a profile and returns a `SetParametersResult`.
QosCallbackType: TypeAlias = Callable[[Any], Any]
#: What an executor yields: a task, what it is a callback of, and its node.
YieldedCallback: TypeAlias = Any
#: A class with these attributes is a service's: `Request`, `Response`.
SendGoalService: TypeAlias = Service
GetResultService: TypeAlias = Service
ProtocolType: Any = type(Protocol)


class PyCapsule(Protocol):
    """A pointer of C, which zbot has none of."""


class CommonMsgSrvMetaClass(ProtocolType):  # type: ignore[misc]
    """What the classes of messages and services have in common."""


class MsgMetaClass(CommonMsgSrvMetaClass):
    """What the classes of messages have in common."""


class EventMessage(Protocol):
    """A service's event."""

    info: ServiceEventInfo


class SendGoalServiceRequest(Protocol[GoalT]):
    """An action client's request."""

    goal_id: UUID
    goal: GoalT


class SendGoalServiceResponse(Protocol):
    """An action server's answer to it."""

    accepted: bool
    stamp: Time


class GetResultServiceRequest(Protocol):
    """An action client's question for the result."""

    goal_id: UUID


class GetResultServiceResponse(Protocol[ResultT_co]):
    """An action server's answer to it."""

    @property
    def status(self) -> int:
        """How the goal ended."""
        ...

    @property
    def result(self) -> ResultT_co:
        """The result."""
        ...


class FeedbackMessage(Protocol[FeedbackT_co]):
    """What an action server tells meanwhile."""

    @property
    def goal_id(self) -> UUID:
        """Whose feedback it is."""
        ...

    @property
    def feedback(self) -> FeedbackT_co:
        """The feedback."""
        ...


class TimeJumpDictionary(TypedDict):
    """A clock's jump, as rclpy's C library tells it."""

    clock_change: ClockChange
    delta: int


class TypeHashDictionary(TypedDict):
    """A type's hash, as rclpy's C library tells it."""

    version: int
    value: bytes


class SendGoalKWargs(TypedDict):
    """What `ActionClient.send_goal` takes beside the goal."""

    feedback_callback: Callable[[Any], None] | None
    goal_uuid: UUID | None


class CreateLifecyclePublisherArgs(TypedDict, total=False):
    """What `create_lifecycle_publisher` takes beside type, topic and profile."""

    callback_group: CallbackGroup | None
    event_callbacks: PublisherEventCallbacks | None
    qos_overriding_options: QoSOverridingOptions | None


class LifecycleNodeArgs(TypedDict, total=False):
    """What `LifecycleNode` takes beside its name."""

    context: Context | None
    cli_args: list[str] | None
    namespace: str | None
    use_global_arguments: bool
    enable_rosout: bool
    start_parameter_services: bool
    parameter_overrides: list[Parameter[Any]] | None
    allow_undeclared_parameters: bool
    automatically_declare_parameters_from_overrides: bool
    enable_logger_service: bool
