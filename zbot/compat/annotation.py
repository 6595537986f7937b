"""Types of rclpy for annotations in programs. They have no effect at run time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias, TypedDict, TypeVar

from zbot.interfaces.message import Service

if TYPE_CHECKING:
    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.clock import ClockChange
    from zbot.node.event_callbacks import PublisherEventCallbacks
    from zbot.parameters.parameter import Parameter
    from zbot.parameters.qos_overrides import QoSOverridingOptions

    from builtin_interfaces.msg import Time
    from service_msgs.msg import ServiceEventInfo
    from unique_identifier_msgs.msg import UUID

GoalT = TypeVar("GoalT")
ResultT_co = TypeVar("ResultT_co", covariant=True)
FeedbackT_co = TypeVar("FeedbackT_co", covariant=True)

#: Value of a parameter: a bool, a number, a string, or a list of values of one of these types.
AllowableParameterValue: TypeAlias = Any
AllowableParameterValueT = TypeVar("AllowableParameterValueT")
CallbackNames: TypeAlias = Literal[
    "on_configure", "on_cleanup", "on_shutdown", "on_activate", "on_deactivate", "on_error"
]
#: Argument of an event's callback: an object of one of the info classes.
EventHandlerData: TypeAlias = Any
JumpHandlePreCallbackType: TypeAlias = Callable[[], None]
ClientGoalHandleDict: TypeAlias = dict[str, object]
ServerGoalHandleDict: TypeAlias = dict[str, object]
#: Value of a QoS policy: a member of an enum, a number or a duration.
QoSProfileAttributes: TypeAlias = Any
#: Function that takes a profile and returns a `SetParametersResult`.
QosCallbackType: TypeAlias = Callable[[Any], Any]
#: Items that an executor yields: a task, the entity with the task's callback, the entity's node.
YieldedCallback: TypeAlias = Any
#: Class of a service. The class has the attributes `Request` and `Response`.
SendGoalService: TypeAlias = Service
GetResultService: TypeAlias = Service
ProtocolType: Any = type(Protocol)


class PyCapsule(Protocol):
    """Pointer in rclpy's C code. zbot has no such pointers."""


class CommonMsgSrvMetaClass(ProtocolType):  # type: ignore[misc]
    """Metaclass of the classes of messages and services."""


class MsgMetaClass(CommonMsgSrvMetaClass):
    """Metaclass of the classes of messages."""


class EventMessage(Protocol):
    """Event of a service."""

    info: ServiceEventInfo


class SendGoalServiceRequest(Protocol[GoalT]):
    """Request in which an action client asks the server to accept a goal."""

    goal_id: UUID
    goal: GoalT


class SendGoalServiceResponse(Protocol):
    """Response of an action server to the request for a goal."""

    accepted: bool
    stamp: Time


class GetResultServiceRequest(Protocol):
    """Request of an action client for the result."""

    goal_id: UUID


class GetResultServiceResponse(Protocol[ResultT_co]):
    """Response of an action server to the request for the result."""

    @property
    def status(self) -> int:
        """End state of the goal."""
        ...

    @property
    def result(self) -> ResultT_co:
        """The result."""
        ...


class FeedbackMessage(Protocol[FeedbackT_co]):
    """Feedback of an action server."""

    @property
    def goal_id(self) -> UUID:
        """Id of the goal."""
        ...

    @property
    def feedback(self) -> FeedbackT_co:
        """The feedback."""
        ...


class TimeJumpDictionary(TypedDict):
    """Jump of a clock, as rclpy's C library reports it."""

    clock_change: ClockChange
    delta: int


class TypeHashDictionary(TypedDict):
    """Hash of a type, as rclpy's C library reports it."""

    version: int
    value: bytes


class SendGoalKWargs(TypedDict):
    """Arguments of `ActionClient.send_goal` after the goal."""

    feedback_callback: Callable[[Any], None] | None
    goal_uuid: UUID | None


class CreateLifecyclePublisherArgs(TypedDict, total=False):
    """Arguments of `create_lifecycle_publisher` after type, topic and profile."""

    callback_group: CallbackGroup | None
    event_callbacks: PublisherEventCallbacks | None
    qos_overriding_options: QoSOverridingOptions | None


class LifecycleNodeArgs(TypedDict, total=False):
    """Arguments of `LifecycleNode` after its name."""

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
