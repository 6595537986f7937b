"""Text about the actions in a bag, as `ros2 bag info` prints it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.bag.size_text import size_text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from zbot.bag.metadata import TopicInformation

_PART = "/_action/"
_EVENT_TOPIC = "/_service_event"
_FEEDBACK_TYPE = "_FeedbackMessage"
_TOPICS = ("feedback", "status")
_SERVICES = ("send_goal", "cancel_goal", "get_result")


def action_name(topic: str) -> str:
    """Return the name of the action that a topic belongs to, or an empty text."""
    name, part, _ = topic.partition(_PART)
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
        total = sum(sizes.get(one.topic.name, 0) for one in topics)
        size = f"Size Contribution: {size_text(total)} | "
    yield (
        f"  Action: {name} | Type: {_type(topics)} | Topics: 2 | Service: 3 | "
        f"{size}Serialization Format: {topics[0].topic.serialization_format}"
    )
    counts = {one.topic.name: one.message_count for one in topics}
    for part in _TOPICS:
        yield f"    Topic: {part} | Count: {counts.get(f'{name}{_PART}{part}', 0)}"
    for part in _SERVICES:
        topic = f"{name}{_PART}{part}{_EVENT_TOPIC}"
        if calls is None:
            yield f"    Service: {part} | Event Count: {counts.get(topic, 0)}"
        else:
            requests, responses = calls.get(topic, (0, 0))
            yield f"    Service: {part} | Request Count: {requests} | Response Count: {responses}"


def _type(topics: Sequence[TopicInformation]) -> str:
    """Return the type of an action. It is `unknown` if the feedback was not recorded."""
    names = (one.topic.type_name for one in topics)
    feedback = (one for one in names if one.endswith(_FEEDBACK_TYPE))
    return next((one.removesuffix(_FEEDBACK_TYPE) for one in feedback), "unknown")
