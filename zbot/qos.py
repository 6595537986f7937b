"""Quality of service: how a topic's messages are kept, delivered and watched over.

In zbot every pair of profiles can talk; a profile says what each side does with its messages.
"""

# ruff: noqa: PLE0237  the policies are descriptors, which keep their values in the slots
from __future__ import annotations

import warnings
from enum import Enum, IntEnum
from typing import Any, Generic, TypeVar, overload

from zbot.errors import (
    ArgumentTypeError,
    InvalidQoSProfileError,
    QoSArgumentError,
    UnknownQoSKeyError,
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
    """The policies that a profile is made of, with the numbers of ROS 2."""

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
    """A policy's values, also known by short keys: `best_effort` for `BEST_EFFORT`."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the values as a person types them."""
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the value of a short key, whatever its case.

        Raises:
            UnknownQoSKeyError: There is no such value.
        """
        try:
            return cls[name.upper()].value
        except KeyError:
            raise UnknownQoSKeyError(cls.__name__, name, cls.short_keys()) from None

    @property
    def short_key(self) -> str:
        """The value as a person types it."""
        return self.name.lower()


# The RMW_... members are the names of ROS 2's first years, which programs still use.
class HistoryPolicy(QoSPolicyEnum):
    """Which messages wait for a slow partner: the last `depth`, or all of them."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2
    RMW_QOS_POLICY_HISTORY_UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether a message lost by the network is sent again."""

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
    """Whether a late subscriber still gets the messages sent before it came."""

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
    """Who says that a publisher is alive: the library, or the program itself."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 4  # rclpy's slip of the pen, which programs may have copied


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

#: As strict as the partners found at creation allow.
DeadlineBestAvailable = Duration(nanoseconds=2**63 - 2)
LivelinessLeaseDurationeBestAvailable = Duration(nanoseconds=2**63 - 2)  # spelt as in rclpy

_PolicyT = TypeVar("_PolicyT", bound=QoSPolicyEnum)
_ValueT = TypeVar("_ValueT", Duration, bool)
_DefaultT = TypeVar("_DefaultT")


def _or(value: _DefaultT | None, default: _DefaultT) -> _DefaultT:
    return default if value is None else value


class _Policy(Generic[_PolicyT]):
    """A settable policy: one of its enum's members, or their number."""

    def __init__(self, policy: type[_PolicyT]) -> None:
        self._policy = policy

    def __set_name__(self, _owner: type, name: str) -> None:
        self._name, self._slot = name, f"_{name}"

    @overload
    def __get__(self, profile: None, _owner: type) -> _Policy[_PolicyT]: ...
    @overload
    def __get__(self, profile: QoSProfile, _owner: type) -> _PolicyT: ...
    def __get__(self, profile: QoSProfile | None, _owner: type) -> _Policy[_PolicyT] | _PolicyT:
        if profile is None:
            return self
        value: _PolicyT = getattr(profile, self._slot)
        return value

    def __set__(self, profile: QoSProfile, value: _PolicyT | int) -> None:
        if not isinstance(value, int):
            raise ArgumentTypeError(self._name, f"a {self._policy.__name__}", value)
        try:
            policy = self._policy(value)
        except ValueError:
            reason = f"{self._name} must be a {self._policy.__name__}, not {value!r}"
            raise InvalidQoSProfileError(reason) from None
        setattr(profile, self._slot, policy)


class _Value(Generic[_ValueT]):
    """A settable value of one Python type."""

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


class QoSProfile:
    """A set of policies for a publisher, subscription, service or client.

    Args:
        history: Which messages wait for a slow partner; with `depth` alone, the last ones.
        depth: How many messages wait, with `KEEP_LAST`.
        reliability: Reliable unless said otherwise.
        durability: Volatile unless said otherwise; `TRANSIENT_LOCAL` serves late subscribers.
        lifespan: Age after which a message is no longer delivered; zero means never.
        deadline: Longest time between two messages; zero means any.
        liveliness: Who says that a publisher is alive.
        liveliness_lease_duration: Time without such a sign after which it counts as dead; zero
            means never.
        avoid_ros_namespace_conventions: Kept for programs that set it; zbot adds no prefixes.

    Raises:
        InvalidQoSProfileError: Neither history nor depth is given, `KEEP_LAST` has no depth, or
            a number is out of range.
        ArgumentTypeError: An argument is of another type than it must be.
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
            raise InvalidQoSProfileError("history KEEP_LAST needs a depth: how many messages?")
        self.depth = 10 if depth is None else depth
        self.reliability = _or(reliability, ReliabilityPolicy.RELIABLE)
        self.durability = _or(durability, DurabilityPolicy.VOLATILE)
        self.lifespan = _or(lifespan, Duration())
        self.deadline = _or(deadline, Duration())
        self.liveliness = _or(liveliness, LivelinessPolicy.SYSTEM_DEFAULT)
        self.liveliness_lease_duration = _or(liveliness_lease_duration, Duration())
        self.avoid_ros_namespace_conventions = _or(avoid_ros_namespace_conventions, False)

    @property
    def depth(self) -> int:
        """How many messages wait for a slow partner, with `KEEP_LAST`."""
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
            warning = "a depth of 0 keeps no message: the default depth is used instead"
            warnings.warn(warning, stacklevel=3)
        self._depth = value

    def get_c_qos_profile(self) -> PlainQoSProfile:
        """Return the policies as rclpy hands them to its C library."""
        return PlainQoSProfile(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return NotImplemented
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__)

    __hash__ = None  # type: ignore[assignment]  # its policies can be set: no key for a dict

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
    """Return the profile itself, or the default one with the depth given.

    Raises:
        QoSArgumentError: It is neither a profile nor an integer.
        InvalidQoSProfileError: The depth is negative.
    """
    if isinstance(qos_or_depth, QoSProfile):
        return qos_or_depth
    if not isinstance(qos_or_depth, int) or isinstance(qos_or_depth, bool):
        raise QoSArgumentError(qos_or_depth)
    return QoSProfile(depth=qos_or_depth)


qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(depth=10)
#: Every policy as the receiving side prefers it.
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    depth=0,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
#: For sensors: the newest readings matter, a lost one does not.
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
#: For parameters: like services, with room for many requests at once.
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#: As strict as the partners found at creation allow.
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=DeadlineBestAvailable,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=LivelinessLeaseDurationeBestAvailable,
)
#: For `/rosout`: a late reader gets the log lines of the last ten seconds.
qos_profile_rosout_default = QoSProfile(
    depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)


class QoSPresetProfiles(Enum):
    """The profiles that ROS 2 names. Equal ones are one member, under the first name."""

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
        """Return the names as a person types them."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile of a short key, whatever its case.

        Raises:
            UnknownQoSKeyError: There is no such profile.
        """
        try:
            return cls[name.upper()].value
        except KeyError:
            raise UnknownQoSKeyError(cls.__name__, name, cls.short_keys()) from None


class PlainQoSProfile:
    """A profile's policies by their names; rclpy keeps them in a structure of its C library.

    Args:
        profile: Whose policies; later changes of it are not seen.
    """

    def __init__(self, profile: QoSProfile) -> None:
        self._policies = {name: getattr(profile, name) for name in _FIELDS}

    def to_dict(self) -> dict[str, Any]:
        """Return the policies as `QoSProfile(**policies)` takes them."""
        return dict(self._policies)

    @classmethod
    def predefined(cls, name: str) -> PlainQoSProfile:
        """Return the policies of a profile such as `qos_profile_sensor_data`.

        Raises:
            UnknownQoSKeyError: There is no such profile.
        """
        return cls(QoSPresetProfiles.get_from_short_key(name.removeprefix("qos_profile_")))


class QoSCompatibility(Enum):
    """The answer of `qos_check_compatible`."""

    OK = 0
    WARNING = 1
    ERROR = 2


def qos_check_compatible(
    publisher_qos: QoSProfile,  # noqa: ARG001 - rclpy's signature
    subscription_qos: QoSProfile,  # noqa: ARG001 - rclpy's signature
) -> tuple[QoSCompatibility, str]:
    """Tell whether two profiles can talk, and why not: in zbot every pair can."""
    return QoSCompatibility.OK, ""


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return the policy's name, e.g. `RELIABILITY` for 16.

    Raises:
        ValueError: There is no such policy.
    """
    return QoSPolicyKind(policy_kind).name
