"""Quality of service (QoS) profiles: how messages are queued, delivered and monitored.

In zbot, all profiles are compatible. A profile says how its own endpoint treats messages.
"""

# ruff: noqa: PLE0237  the policies are descriptors that keep their values in the slots
from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any, Generic, TypeVar, overload

from zbot.errors import (
    ArgumentTypeError,
    InvalidQoSProfileError,
    UnknownQoSKeyError,
    qos_argument_error,
)
from zbot.time import Duration

__all__ = [
    "DeadlineBestAvailable",
    "DurabilityPolicy",
    "HistoryPolicy",
    "LivelinessLeaseDurationeBestAvailable",
    "LivelinessPolicy",
    "PlainQoSProfile",
    "QoSCompatibility",
    "QoSDurabilityPolicy",
    "QoSHistoryPolicy",
    "QoSLivelinessPolicy",
    "QoSPolicyEnum",
    "QoSPolicyKind",
    "QoSPresetProfiles",
    "QoSProfile",
    "QoSReliabilityPolicy",
    "ReliabilityPolicy",
    "as_profile",
    "qos_check_compatible",
    "qos_policy_name_from_kind",
    "qos_profile_action_status_default",
    "qos_profile_best_available",
    "qos_profile_default",
    "qos_profile_parameter_events",
    "qos_profile_parameters",
    "qos_profile_rosout_default",
    "qos_profile_sensor_data",
    "qos_profile_services_default",
    "qos_profile_system_default",
    "qos_profile_unknown",
]


class QoSPolicyKind(IntEnum):
    """Policies of a profile, with ROS 2's numbers."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


class QoSPolicyEnum(IntEnum):
    """Base class of a policy's values. Each value has a short key, e.g. `best_effort`."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short keys of all values."""
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the value of a short key in upper or lower case.

        Raises:
            UnknownQoSKeyError: There is no such value.
        """
        try:
            return cls[name.upper()].value
        except KeyError:
            raise UnknownQoSKeyError(cls.__name__, name, cls.short_keys()) from None

    @property
    def short_key(self) -> str:
        """The value's short key."""
        return self.name.lower()


# The RMW_... members are old ROS 2 names that programs still use.
class HistoryPolicy(QoSPolicyEnum):
    """Policy for the messages that a queue keeps for a slow receiver: the last `depth` or all."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2
    RMW_QOS_POLICY_HISTORY_UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Policy that says whether a message is sent again if the network loses it."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_RELIABILITY_RELIABLE = 1
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = 2
    RMW_QOS_POLICY_RELIABILITY_UNKNOWN = 3


class DurabilityPolicy(QoSPolicyEnum):
    """Policy that says whether a late subscriber gets messages that were sent before it existed."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4
    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = 1
    RMW_QOS_POLICY_DURABILITY_VOLATILE = 2
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 3


class LivelinessPolicy(QoSPolicyEnum):
    """Policy that says whether the library or the program asserts that a publisher is alive."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 4  # rclpy's typo, which programs may use


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

#: This value means the strictest value that the topic's present endpoints allow.
DeadlineBestAvailable = Duration(nanoseconds=2**63 - 2)
LivelinessLeaseDurationeBestAvailable = Duration(nanoseconds=2**63 - 2)  # spelt as in rclpy

_PolicyT = TypeVar("_PolicyT", bound=QoSPolicyEnum)
_ValueT = TypeVar("_ValueT")
_DefaultT = TypeVar("_DefaultT")


def _default_if_none(value: _DefaultT | None, default: _DefaultT) -> _DefaultT:
    return default if value is None else value


class _Value(Generic[_ValueT]):
    """Descriptor of a policy whose value has one Python type."""

    def __init__(self, kind: type[_ValueT]) -> None:
        self._kind: type[_ValueT] = kind

    def __set_name__(self, _owner: type, name: str) -> None:
        self._name, self._slot = name, f"_{name}"

    @overload
    def __get__(self, profile: None, _owner: type) -> _Value[_ValueT]: ...
    @overload
    def __get__(self, profile: QoSProfile, _owner: type) -> _ValueT: ...
    def __get__(self, profile: QoSProfile | None, _owner: type) -> _Value[_ValueT] | _ValueT:
        if profile is None:
            return self
        value: _ValueT = getattr(profile, self._slot)
        return value

    def __set__(self, profile: QoSProfile, value: _ValueT) -> None:
        if not isinstance(value, self._kind):
            raise ArgumentTypeError(self._name, f"a {self._kind.__name__}", value)
        setattr(profile, self._slot, value)


class _Policy(_Value[_PolicyT]):
    """Descriptor of a policy whose value is an enum member. It also accepts a member's number."""

    def __set__(self, profile: QoSProfile, value: _PolicyT | int) -> None:
        if not isinstance(value, int):
            name = str(value).upper().replace("-", "_")
            member = f".{name}" if name in self._kind.__members__ else ""
            raise ArgumentTypeError(self._name, f"a {self._kind.__name__}{member}", value)
        try:
            policy = self._kind(value)
        except ValueError:
            reason = f"{self._name} must be a {self._kind.__name__}, not {value!r}"
            raise InvalidQoSProfileError(reason) from None
        if isinstance(value, QoSPolicyEnum) and not isinstance(value, self._kind):
            _warn_of_other_policy(self._name, value, f"{self._kind.__name__}.{policy.name}")
        setattr(profile, self._slot, policy)


def _warn_of_other_policy(
    argument: str, value: QoSPolicyEnum, counts_as: str, *, frames: int = 4
) -> None:
    """Warn. `frames` is their number up to the program, whose line the warning shows."""
    # rclpy takes the number of the member. So a program that runs there is not refused.
    given = f"{type(value).__name__}.{value.name}"
    keyword = type(value).__name__.removesuffix("Policy").lower()
    text = f"{argument} is {given}, which counts as {counts_as}"
    warnings.warn(f"{text}: write {keyword}={given} in a QoSProfile", stacklevel=frames)


class QoSProfile:
    """A set of policies for a publisher, subscription, service or client.

    Args:
        history: Messages that the queue keeps. The default is `KEEP_LAST`, which needs `depth`.
        depth: Length of the queue with `KEEP_LAST`, in messages.
        reliability: `RELIABLE` by default.
        durability: `VOLATILE` by default. `TRANSIENT_LOCAL` keeps messages for late subscribers.
        lifespan: Age after which a message is not delivered any more. Zero means no limit.
        deadline: Longest time between two messages. Zero means no limit.
        liveliness: Whether zbot or the program asserts that a publisher is alive.
        liveliness_lease_duration: A publisher counts as dead after this time without an assertion.
            Zero means no limit.
        avoid_ros_namespace_conventions: It has no effect, because zbot adds no prefixes to names.

    Raises:
        InvalidQoSProfileError: History and depth are both missing, `KEEP_LAST` has no depth, or a
            number is out of range.
        ArgumentTypeError: An argument has the wrong type.
    """

    __slots__ = (
        "_avoid_ros_namespace_conventions",
        "_deadline",
        "_depth",
        "_durability",
        "_history",
        "_lifespan",
        "_liveliness",
        "_liveliness_lease_duration",
        "_reliability",
    )

    history: _Policy[HistoryPolicy] = _Policy(HistoryPolicy)
    reliability: _Policy[ReliabilityPolicy] = _Policy(ReliabilityPolicy)
    durability: _Policy[DurabilityPolicy] = _Policy(DurabilityPolicy)
    lifespan: _Value[Duration] = _Value(Duration)
    deadline: _Value[Duration] = _Value(Duration)
    liveliness: _Policy[LivelinessPolicy] = _Policy(LivelinessPolicy)
    liveliness_lease_duration: _Value[Duration] = _Value(Duration)
    avoid_ros_namespace_conventions: _Value[bool] = _Value(bool)

    def __init__(  # noqa: PLR0917 - rclpy's signature
        self,
        history: HistoryPolicy | int | None = None,
        depth: int | None = None,
        reliability: ReliabilityPolicy | int | None = None,
        durability: DurabilityPolicy | int | None = None,
        lifespan: Duration | None = None,
        deadline: Duration | None = None,
        liveliness: LivelinessPolicy | int | None = None,
        liveliness_lease_duration: Duration | None = None,
        avoid_ros_namespace_conventions: bool | None = None,
    ) -> None:
        if history is None and depth is None:
            raise InvalidQoSProfileError("give it a depth, a history policy or both")
        self.history = HistoryPolicy.KEEP_LAST if history is None else history
        if depth is None and self.history == HistoryPolicy.KEEP_LAST:
            raise InvalidQoSProfileError("history KEEP_LAST needs a depth, in messages")
        self.depth = 10 if depth is None else depth
        self.reliability = _default_if_none(reliability, ReliabilityPolicy.RELIABLE)
        self.durability = _default_if_none(durability, DurabilityPolicy.VOLATILE)
        self.lifespan = _default_if_none(lifespan, Duration())
        self.deadline = _default_if_none(deadline, Duration())
        self.liveliness = _default_if_none(liveliness, LivelinessPolicy.SYSTEM_DEFAULT)
        self.liveliness_lease_duration = _default_if_none(liveliness_lease_duration, Duration())
        self.avoid_ros_namespace_conventions = _default_if_none(
            avoid_ros_namespace_conventions, False
        )

    @property
    def depth(self) -> int:
        """Length of the queue with `KEEP_LAST`, in messages."""
        return self._depth

    @depth.setter
    def depth(self, value: int) -> None:
        if not isinstance(value, int) or isinstance(value, bool):
            raise ArgumentTypeError("depth", "an integer", value)
        if value < 0:
            raise InvalidQoSProfileError(
                f"history depth must be greater than or equal to zero, not {value}"
            )
        if value == 0 and self.history == HistoryPolicy.KEEP_LAST:
            warning = "A zero depth with KEEP_LAST doesn't make sense: a depth of 1 is used instead"
            warnings.warn(warning, stacklevel=3)
        self._depth = value

    def get_c_qos_profile(self) -> PlainQoSProfile:
        """Return the policies in the form that rclpy passes to its C library."""
        return PlainQoSProfile(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return NotImplemented
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__)

    __hash__ = None  # type: ignore[assignment]  # mutable, so not hashable

    def __str__(self) -> str:
        values = ((name, getattr(self, name)) for name in _FIELDS)
        numbers = ((name, int(v) if isinstance(v, QoSPolicyEnum) else v) for name, v in values)
        return f"QoSProfile({', '.join(f'{name}={value}' for name, value in numbers)})"

    def __repr__(self) -> str:
        values = ((name, getattr(self, name)) for name in _FIELDS)
        named = ((name, v.name if isinstance(v, QoSPolicyEnum) else v) for name, v in values)
        return f"QoSProfile({', '.join(f'{name}={value}' for name, value in named)})"


#: the order in which ROS 2 prints a profile
_FIELDS = (
    "history",
    "depth",
    "reliability",
    "durability",
    "lifespan",
    "deadline",
    "liveliness",
    "liveliness_lease_duration",
    "avoid_ros_namespace_conventions",
)


def as_profile(qos_or_depth: QoSProfile | int) -> QoSProfile:
    """Return the given profile, or the default profile with the given depth.

    Raises:
        WrongTypeError: The value is neither a profile nor an integer.
        InvalidQoSProfileError: The depth is negative.
    """
    if isinstance(qos_or_depth, QoSProfile):
        return qos_or_depth
    if not isinstance(qos_or_depth, int) or isinstance(qos_or_depth, bool):
        raise qos_argument_error(qos_or_depth)
    if isinstance(qos_or_depth, QoSPolicyEnum):
        counts_as = f"the depth {int(qos_or_depth)}"
        # The frames are those of a call of create_publisher.
        _warn_of_other_policy("the QoS profile", qos_or_depth, counts_as, frames=5)
    return QoSProfile(depth=qos_or_depth)


qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(depth=10)
#: Every policy has the middleware's default.
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    depth=0,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
#: For sensors: the newest values matter, and a lost value does not matter.
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
#: For parameters: the profile of services, but with a longer queue for many simultaneous requests.
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#: The strictest profile that the topic's other endpoints allow when an endpoint is created.
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=DeadlineBestAvailable,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=LivelinessLeaseDurationeBestAvailable,
)
#: For `/rosout`: a late subscriber gets the log lines of the last ten seconds.
qos_profile_rosout_default = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)


class QoSPresetProfiles(Enum):
    """Predefined profiles of ROS 2. Equal profiles are aliases of one member."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available
    ROSOUT_DEFAULT = qos_profile_rosout_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short keys of all profiles."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile of a short key in upper or lower case.

        Raises:
            UnknownQoSKeyError: There is no such profile.
        """
        try:
            return cls[name.upper()].value
        except KeyError:
            raise UnknownQoSKeyError(cls.__name__, name, cls.short_keys()) from None


class PlainQoSProfile:
    """Policies of a profile by name. It replaces the C structure of rclpy.

    Args:
        profile: The profile whose policies are copied.
    """

    def __init__(self, profile: QoSProfile) -> None:
        self._policies = {name: getattr(profile, name) for name in _FIELDS}

    def to_dict(self) -> dict[str, Any]:
        """Return the policies as keyword arguments of `QoSProfile`."""
        return dict(self._policies)

    @classmethod
    def predefined(cls, name: str) -> PlainQoSProfile:
        """Return the policies of a profile such as `qos_profile_sensor_data`.

        Raises:
            UnknownQoSKeyError: There is no such profile.
        """
        return cls(QoSPresetProfiles.get_from_short_key(name.removeprefix("qos_profile_")))


class QoSCompatibility(Enum):
    """Result of `qos_check_compatible`."""

    OK = 0
    WARNING = 1
    ERROR = 2


#: For each policy: the publisher's value and the subscription's value that do not fit together.
_MISMATCHES = {
    "reliability": ("BEST_EFFORT", "RELIABLE"),
    "durability": ("VOLATILE", "TRANSIENT_LOCAL"),
    "liveliness": ("AUTOMATIC", "MANUAL_BY_TOPIC"),
}
_UNCERTAIN = ("SYSTEM_DEFAULT", "UNKNOWN")


def qos_check_compatible(
    publisher_qos: QoSProfile, subscription_qos: QoSProfile
) -> tuple[QoSCompatibility, str]:
    """Return whether two profiles are compatible in DDS, and the reasons. zbot always delivers."""
    errors, warned = [], []
    for policy, (offered, requested) in _MISMATCHES.items():
        ours, theirs = getattr(publisher_qos, policy).name, getattr(subscription_qos, policy).name
        text = f"publisher {policy} is {ours} and subscription {policy} is {theirs};"
        if (ours, theirs) == (offered, requested):
            errors.append(f"ERROR: {text}")
        elif ours in {offered, *_UNCERTAIN} and theirs in {requested, *_UNCERTAIN}:
            warned.append(f"WARNING: {text}")
    for policy in ("deadline", "liveliness_lease_duration"):
        span, wanted = getattr(publisher_qos, policy), getattr(subscription_qos, policy)
        if wanted != Duration() and (span == Duration() or wanted < span):
            errors.append(f"ERROR: subscription {policy} is shorter than publisher {policy};")
    without_errors = QoSCompatibility.WARNING if warned else QoSCompatibility.OK
    return QoSCompatibility.ERROR if errors else without_errors, "".join(errors or warned)


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return a policy's name, e.g. `RELIABILITY` for 16.

    Raises:
        ValueError: There is no policy with that number.
    """
    return QoSPolicyKind(policy_kind).name
