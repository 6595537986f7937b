"""Text of a QoS profile as one chunk of a liveliness token, in rmw_zenoh's form.

    <reliability>:<durability>:<history>,<depth>:<deadline>:<lifespan>:<liveliness>,<lease>

The three durations are `<seconds>,<nanoseconds>`. A component is empty if it has its default value.
"""

from __future__ import annotations

from typing import TypeVar

from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyEnum,
    QoSProfile,
    ReliabilityPolicy,
)
from zbot.text.whole_number import whole_number
from zbot.time import S_TO_NS, Duration, Infinite

__all__ = ["parse_qos", "qos_text"]

DEFAULT_DEPTH = 42  # rmw_zenoh's depth for a profile without a depth
_INFINITE_S, _INFINITE_NS = divmod(Infinite.nanoseconds, S_TO_NS)
# rmw writes "best available" as one nanosecond less than infinite.
_BEST_AVAILABLE_NS = Infinite.nanoseconds - 1
_SEPARATORS = 5

_PolicyT = TypeVar("_PolicyT", bound=QoSPolicyEnum)


def qos_text(profile: QoSProfile) -> str:
    """Return the profile's text. `SYSTEM_DEFAULT` and `BEST_AVAILABLE` become the default value."""
    reliability = _policy_text(profile.reliability, ReliabilityPolicy.RELIABLE)
    durability = _policy_text(profile.durability, DurabilityPolicy.VOLATILE)
    history = _policy_text(profile.history, HistoryPolicy.KEEP_LAST)
    liveliness = _policy_text(profile.liveliness, LivelinessPolicy.AUTOMATIC)
    depth = "" if profile.depth in {0, DEFAULT_DEPTH} else str(profile.depth)
    deadline, lifespan = _span_text(profile.deadline), _span_text(profile.lifespan)
    lease = _span_text(profile.liveliness_lease_duration)
    return (
        f"{reliability}:{durability}:{history},{depth}:{deadline}:{lifespan}:{liveliness},{lease}"
    )


def parse_qos(text: str) -> QoSProfile:
    """Return the profile that a text contains. Durations without a limit become `Infinite`.

    If a policy's number is not known, the policy becomes `UNKNOWN`.

    Raises:
        ValueError: The text has another form.
    """
    parts = text.split(":")
    if len(parts) <= _SEPARATORS:
        raise ValueError(f"QoS {text!r} has less than {_SEPARATORS} colons")
    history, depth = _split(parts[2], 2)
    liveliness, lease_s, lease_ns = _split(parts[5], 3)
    return QoSProfile(
        reliability=_policy(parts[0], ReliabilityPolicy.RELIABLE),
        durability=_policy(parts[1], DurabilityPolicy.VOLATILE),
        history=_policy(history, HistoryPolicy.KEEP_LAST),
        depth=_number(depth, DEFAULT_DEPTH) or DEFAULT_DEPTH,
        deadline=_span(*_split(parts[3], 2)),
        lifespan=_span(*_split(parts[4], 2)),
        liveliness=_policy(liveliness, LivelinessPolicy.AUTOMATIC),
        liveliness_lease_duration=_span(lease_s, lease_ns),
    )


def _policy_text(policy: QoSPolicyEnum, default: QoSPolicyEnum) -> str:
    if policy.name in {"SYSTEM_DEFAULT", "BEST_AVAILABLE", default.name}:
        return ""
    return str(policy.value)


def _span_text(span: Duration) -> str:
    if span.nanoseconds <= 0 or span.nanoseconds >= _BEST_AVAILABLE_NS:
        return ","
    seconds, rest = divmod(span.nanoseconds, S_TO_NS)
    # The seconds are left out if they are those of Infinite. The same is true for nanoseconds.
    return f"{'' if seconds == _INFINITE_S else seconds},{'' if rest == _INFINITE_NS else rest}"


def _split(text: str, count: int) -> list[str]:
    parts = text.split(",")
    if len(parts) < count:
        raise ValueError(f"QoS component {text!r} has less than {count} parts")
    return parts[:count]


def _number(text: str, default: int) -> int:
    if not text:
        return default
    number = whole_number(text, len(str(2**63)))
    if number is None:
        raise ValueError(f"QoS component {text!r} is not a number")
    return number


def _policy(text: str, default: _PolicyT) -> _PolicyT:
    number = _number(text, default.value)
    policies = type(default)
    known = {policy.value: policy for policy in policies}
    return known.get(number, policies["UNKNOWN"])


def _span(seconds: str, nanoseconds: str) -> Duration:
    total = _number(seconds, _INFINITE_S) * S_TO_NS + _number(nanoseconds, _INFINITE_NS)
    return Duration(nanoseconds=total) if 0 < total < Infinite.nanoseconds else Infinite
