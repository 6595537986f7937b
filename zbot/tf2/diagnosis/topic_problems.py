"""Problems of the topics of transforms: nobody publishes, or nobody listens."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.tf2.diagnosis import advice
from zbot.tf2.diagnosis.problem import Cause, Problem

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.tf2.diagnosis.forest import Forest
    from zbot.tf2.diagnosis.surroundings import Surroundings

_MOST_NAMED = 3  #: frames that a sentence names


def of_topic(forest: Forest, heard: Forest, surroundings: Surroundings) -> Iterator[Problem]:
    """Yield the problems of a topic and of its static twin.

    Args:
        forest: The frames of the topic.
        heard: The frames that the program hears, which may be those of another topic.
        surroundings: The nodes on the topics, and the topic.
    """
    silent = surroundings.silent_nodes(forest.links)
    if silent:
        text = f"{' and '.join(silent)} can publish on {surroundings.topic}, but nothing has come"
        is_warning = bool(heard.links)
        yield Problem(Cause.SILENT_PUBLISHER, text, advice.wake(silent), (), is_warning=is_warning)
    known = set(heard.frames)
    frames = [name for name in forest.frames if name not in known]
    if frames and not surroundings.all_listeners:
        named = " and ".join(f"`{name}`" for name in frames[:_MOST_NAMED])
        text = f"{named} are on {surroundings.topic}, where nobody listens"
        yield Problem(Cause.NAMESPACE, text, advice.remap(surroundings.topic), tuple(frames))


def of_silence(surroundings: Surroundings) -> Iterator[Problem]:
    """Yield the problem that nobody publishes transforms, if no node could."""
    if not any(surroundings.publishers.get(topic) for topic in surroundings.topics):
        text = f"nobody publishes on {' and '.join(surroundings.topics)}"
        yield Problem(Cause.NO_PUBLISHER, text, advice.start_robot(surroundings.topic), ())
