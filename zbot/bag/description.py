"""Text about a bag, as `ros2 bag info` prints it."""

from __future__ import annotations

import time
from collections import Counter
from typing import TYPE_CHECKING, Any

from zbot.names import ACTION_PART
from zbot.time import S_TO_NS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

    from zbot.bag.metadata import BagMetadata, TopicInformation
    from zbot.bag.reader import Reader

_INDENT = 19
_EVENT_TOPIC, _EVENT_TYPE = "/_service_event", "_Event"
SORT_KEYS: dict[str, Callable[[TopicInformation], Any]] = {
    "name": lambda information: information.topic.name,
    "type": lambda information: information.topic.type_name,
    "count": lambda information: information.message_count,
    "serialization_format": lambda information: information.topic.serialization_format,
}


def is_service_event(name: str, type_name: str) -> bool:
    """Return whether a topic has the recorded calls of a service."""
    return name.endswith(_EVENT_TOPIC) and type_name.endswith(_EVENT_TYPE)


def service_name(topic: str) -> str:
    """Return the name of the service whose calls are on a topic."""
    return topic.removesuffix(_EVENT_TOPIC)


def topic_names(metadata: BagMetadata, sort: str = "name") -> list[str]:
    """Return the names of topics, without the topics of services and actions."""
    return [
        information.topic.name
        for information in _sorted(metadata, sort)
        if not _is_event(information) and not action_name(information.topic.name)
    ]


def description(
    metadata: BagMetadata,
    *,
    sort: str = "name",
    sizes: dict[str, int] | None = None,
    calls: dict[str, tuple[int, int]] | None = None,
) -> str:
    """Return the text of `ros2 bag info`, which begins with an empty line.

    Args:
        metadata: The bag's description.
        sort: A key of `SORT_KEYS`.
        sizes: Bytes of the messages of each topic, for `--verbose`.
        calls: Numbers of requests and responses of each service, for `--verbose`.
    """
    everything = _sorted(metadata, sort)
    actions = _actions(everything)
    plain = [information for information in everything if not action_name(information.topic.name)]
    events = [information for information in plain if _is_event(information)]
    topics = [information for information in plain if not _is_event(information)]
    lines = [
        "",
        f"Files:             {_below(metadata.paths)}",
        f"Bag size:          {size_text(metadata.bag_size)}",
        f"Storage id:        {metadata.storage_id}",
        f"ROS Distro:        {metadata.ros_distro or 'unknown'}",
        f"Duration:          {_seconds(metadata.duration_ns)}s",
        f"Start:             {_time(metadata.start_ns)}",
        f"End:               {_time(metadata.end_ns)}",
        f"Messages:          {sum(information.message_count for information in topics)}",
        f"Topic information: {_below(_topic_lines(topics, sizes))}",
        f"Service:           {len(events)}",
        f"Service information: {_below(_service_lines(events, sizes, calls), _INDENT + 2)}",
    ]
    end = "\n\n" if events else "\n"
    return "\n".join(lines) + end + action_text(actions, sizes, calls)


def _actions(topics: Sequence[TopicInformation]) -> dict[str, list[TopicInformation]]:
    found: dict[str, list[TopicInformation]] = {}
    for information in topics:
        name = action_name(information.topic.name)
        if name:
            found.setdefault(name, []).append(information)
    return found


def contributions(bag: Reader) -> tuple[dict[str, int], dict[str, tuple[int, int]]]:
    """Return the bytes of each topic, and the requests and responses of each service.

    Raises:
        BagReadError: A part of the bag is damaged.
    """
    sizes: Counter[str] = Counter()
    kinds: dict[str, Counter[int]] = {}
    events = {name for name, topic in bag.topics.items() if is_service_event(name, topic.type_name)}
    for message in bag.messages():
        sizes[message.topic] += len(message.data)
        if message.topic in events and len(message.data) > _EVENT_KIND:
            kinds.setdefault(message.topic, Counter())[message.data[_EVENT_KIND]] += 1
    # The client and the server may both report a call. Such a call is counted once.
    calls = {name: (max(k[0], k[1]), max(k[2], k[3])) for name, k in kinds.items()}
    return dict(sizes), calls


_EVENT_KIND = 4  # `event_type` is the first field of an event, after the 4 bytes of CDR's header


def _is_event(information: TopicInformation) -> bool:
    return is_service_event(information.topic.name, information.topic.type_name)


def _sorted(metadata: BagMetadata, sort: str) -> list[TopicInformation]:
    return sorted(metadata.topics, key=SORT_KEYS[sort])


def _topic_lines(topics: Sequence[TopicInformation], sizes: dict[str, int] | None) -> Iterable[str]:
    for information in topics:
        topic = information.topic
        size = "" if sizes is None else f"{_contribution(sizes, topic.name)} | "
        yield (
            f"Topic: {topic.name} | Type: {topic.type_name} | Count: {information.message_count} | "
            f"{size}Serialization Format: {topic.serialization_format}"
        )


def _service_lines(
    events: Sequence[TopicInformation],
    sizes: dict[str, int] | None,
    calls: dict[str, tuple[int, int]] | None,
) -> Iterable[str]:
    for information in events:
        topic = information.topic
        if calls is None:
            count = f"Event Count: {information.message_count}"
        else:
            requests, responses = calls.get(topic.name, (0, 0))
            count = f"Request Count: {requests} | Response Count: {responses}"
        size = "" if sizes is None else f"{_contribution(sizes, topic.name)} | "
        yield (
            f"Service: {service_name(topic.name)} | "
            f"Type: {topic.type_name.removesuffix(_EVENT_TYPE)} | {count} | "
            f"{size}Serialization Format: {topic.serialization_format}"
        )


def _contribution(sizes: dict[str, int], topic: str) -> str:
    return f"Size Contribution: {size_text(sizes.get(topic, 0))}"


def _below(lines: Iterable[str], indent: int = _INDENT) -> str:
    return f"\n{' ' * indent}".join(lines)


def _seconds(time_ns: int) -> str:
    seconds, rest = divmod(time_ns, S_TO_NS)
    return f"{seconds}.{rest:09}"


def _time(time_ns: int) -> str:
    # The day of the month has a space in front of a single digit, as with `%e` in C.
    seconds, rest = divmod(time_ns, S_TO_NS)
    try:
        local = time.localtime(seconds)
    except (OverflowError, ValueError, OSError):
        return f"({_seconds(time_ns)})"  # the system has no date for this time
    month = _MONTHS[local.tm_mon - 1]
    clock = f"{local.tm_hour:02}:{local.tm_min:02}:{local.tm_sec:02}.{rest:09}"
    return f"{month} {local.tm_mday:>2} {local.tm_year} {clock} ({_seconds(time_ns)})"


# The names are English in all languages of the system.
_MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")


_EVENT_TOPIC = "/_service_event"
_FEEDBACK_TYPE = "_FeedbackMessage"
_TOPICS = ("feedback", "status")
_SERVICES = ("send_goal", "cancel_goal", "get_result")


def action_name(topic: str) -> str:
    """Return the name of the action that a topic belongs to, or an empty text."""
    name, part, _ = topic.partition(ACTION_PART)
    return name if part else ""


def action_text(
    actions: Mapping[str, Sequence[TopicInformation]],
    sizes: dict[str, int] | None,
    calls: dict[str, tuple[int, int]] | None,
) -> str:
    """Return the lines about actions. They are the last lines of `ros2 bag info`.

    Args:
        actions: The topics of each action, by the action's name.
        sizes: Bytes of the messages of each topic, for `--verbose`.
        calls: Numbers of requests and responses of each service, for `--verbose`.
    """
    lines = [f"Actions:           {len(actions)}", "Action information: "]
    for name, topics in actions.items():
        lines += _lines(name, topics, sizes, calls)
    return "\n".join(lines) + "\n"


def _lines(
    name: str,
    topics: Sequence[TopicInformation],
    sizes: dict[str, int] | None,
    calls: dict[str, tuple[int, int]] | None,
) -> Iterator[str]:
    size = ""
    if sizes is not None:
        total = sum(sizes.get(information.topic.name, 0) for information in topics)
        size = f"Size Contribution: {size_text(total)} | "
    yield (
        f"  Action: {name} | Type: {_type(topics)} | Topics: 2 | Service: 3 | "
        f"{size}Serialization Format: {topics[0].topic.serialization_format}"
    )
    counts = {information.topic.name: information.message_count for information in topics}
    for part in _TOPICS:
        yield f"    Topic: {part} | Count: {counts.get(f'{name}{ACTION_PART}{part}', 0)}"
    for part in _SERVICES:
        topic = f"{name}{ACTION_PART}{part}{_EVENT_TOPIC}"
        if calls is None:
            yield f"    Service: {part} | Event Count: {counts.get(topic, 0)}"
        else:
            requests, responses = calls.get(topic, (0, 0))
            yield f"    Service: {part} | Request Count: {requests} | Response Count: {responses}"


def _type(topics: Sequence[TopicInformation]) -> str:
    """Return the type of an action. It is `unknown` if the feedback was not recorded."""
    names = (information.topic.type_name for information in topics)
    feedback = (name for name in names if name.endswith(_FEEDBACK_TYPE))
    return next((name.removesuffix(_FEEDBACK_TYPE) for name in feedback), "unknown")


_UNITS = ("B", "KiB", "MiB", "GiB", "TiB")


def size_text(size: int) -> str:
    """Return bytes as text with a unit, e.g. `228.5 KiB`."""
    number, index = float(size), 0
    while number >= 1024 and index < len(_UNITS) - 1:
        number, index = number / 1024, index + 1
    return f"{number:.1f} {_UNITS[index]}" if index else f"{size} B"
