"""QoS profiles as rosbag2 writes them in YAML, in bags and in files of overrides."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.bag.errors import BagValueError
from zbot.errors import ZbotError
from zbot.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyEnum,
    QoSProfile,
    ReliabilityPolicy,
)
from zbot.text.yaml_reader import YamlError, read_yaml
from zbot.time import S_TO_NS, Duration, Infinite

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

_POLICIES: dict[str, type[QoSPolicyEnum]] = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}
_DURATIONS = ("deadline", "lifespan", "liveliness_lease_duration")
# Old bags have other numbers for "no limit": 2147483647 s, with different nanoseconds.
_OLD_INFINITE_S = 2**31 - 1


def qos_overrides_error(path: Path, reason: str) -> BagValueError:
    """Return the error that a file of QoS overrides is not valid."""
    return BagValueError(f"cannot use the QoS overrides in '{path}': {reason}")


def profile_values(profile: QoSProfile) -> dict[str, Any]:
    """Return a profile as the map that rosbag2 writes."""
    return {
        "history": profile.history.short_key,
        "depth": profile.depth,
        "reliability": profile.reliability.short_key,
        "durability": profile.durability.short_key,
        "deadline": _span(profile.deadline),
        "lifespan": _span(profile.lifespan),
        "liveliness": profile.liveliness.short_key,
        "liveliness_lease_duration": _span(profile.liveliness_lease_duration),
        "avoid_ros_namespace_conventions": profile.avoid_ros_namespace_conventions,
    }


def profiles_text(profiles: Sequence[QoSProfile]) -> str:
    """Return profiles as the YAML text in a channel of an MCAP file."""
    import yaml  # noqa: PLC0415 - takes 15 ms

    text: str = yaml.safe_dump(list(map(profile_values, profiles)), sort_keys=False)
    return text


def read_profiles(value: Any) -> list[QoSProfile]:
    """Return the profiles in a bag: a list of maps, or the YAML text of such a list.

    A profile that cannot be read is left out: the messages are more important.
    """
    if isinstance(value, str):
        try:
            value = read_yaml(value)
        except YamlError:
            return []
    found = []
    for item in value if isinstance(value, list) else []:
        try:
            found.append(read_profile(item))
        except (ZbotError, AttributeError, KeyError, TypeError, ValueError):
            continue
    return found


def read_profile(values: dict[str, Any]) -> QoSProfile:
    """Return the profile in a map. Policies may be names or, as in old bags, numbers.

    Raises:
        ValueError: A key or a value is not known.
    """
    arguments: dict[str, Any] = {}
    for key, value in values.items():
        if key in _POLICIES:
            arguments[key] = _policy(_POLICIES[key], value)
        elif key in _DURATIONS:
            arguments[key] = _duration(value)
        elif key in {"depth", "avoid_ros_namespace_conventions"}:
            arguments[key] = value
        else:
            raise ValueError(f"Unexpected key `{key}` for QoS profile.")
    if arguments.get("history", HistoryPolicy.KEEP_LAST) is HistoryPolicy.KEEP_LAST:
        arguments["depth"] = arguments.get("depth") or 10
    return QoSProfile(**{"history": HistoryPolicy.KEEP_LAST, **arguments})


def read_overrides(path: Path) -> dict[str, QoSProfile]:
    """Return the profiles in a file of overrides, by topic.

    Raises:
        BagValueError: The file cannot be read, or is not a map from topics to profiles.
    """
    try:
        found = read_yaml(path.read_text(encoding="utf-8"))
        return {str(topic): read_profile(values) for topic, values in (found or {}).items()}
    except OSError as error:
        raise qos_overrides_error(path, error.strerror or str(error)) from error
    except (AttributeError, TypeError):
        raise qos_overrides_error(path, "it is not a map from topics to profiles") from None
    except (ZbotError, ValueError) as error:
        raise qos_overrides_error(path, str(error)) from error


def profile_to_publish(recorded: Sequence[QoSProfile]) -> QoSProfile:
    """Return a profile to publish the messages of a topic again.

    If all recorded publishers had the same policies, apart from history, depth and lifespan, the
    result is the first profile. Otherwise the result is the default profile, which is compatible
    with most subscriptions.
    """
    if not recorded or any(_contract(profile) != _contract(recorded[0]) for profile in recorded):
        return QoSProfile(depth=10)
    return recorded[0]


def _contract(profile: QoSProfile) -> tuple[Any, ...]:
    return (
        profile.reliability,
        profile.durability,
        profile.deadline,
        profile.liveliness,
        profile.liveliness_lease_duration,
    )


def _policy(policy: type[QoSPolicyEnum], value: Any) -> QoSPolicyEnum:
    if isinstance(value, int):
        return policy(value)
    return policy(policy.get_from_short_key(str(value)))


def _span(duration: Duration) -> dict[str, int]:
    seconds, nanoseconds = divmod(duration.nanoseconds, S_TO_NS)
    return {"sec": seconds, "nsec": nanoseconds}


def _duration(value: Any) -> Duration:
    if not value:
        return Duration()
    try:
        seconds, nanoseconds = int(value["sec"]), int(value["nsec"])
    except (KeyError, TypeError):
        raise ValueError(
            "Time overrides must include both seconds (sec) and nanoseconds (nsec)."
        ) from None
    if seconds < 0 or nanoseconds < 0:
        raise ValueError("Time duration may not be a negative value.")
    if seconds >= _OLD_INFINITE_S:
        return Infinite
    return Duration(nanoseconds=seconds * S_TO_NS + nanoseconds)
