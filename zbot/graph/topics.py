"""Topics and actions of a snapshot, with their nodes and problems, e.g. two types on one topic."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from zbot.errors.suggestion import KnownNames, question
from zbot.graph.filters import TF_TOPICS
from zbot.names import ACTION_PART
from zbot.wire.tokens import EndpointToken, EntityKind

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Mapping

    from zbot.graph.filters import Grouping
    from zbot.graph.snapshot import Snapshot

_TOPIC_KINDS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIPTION)
_ACTION_ENDS = ("_SendGoal", "_FeedbackMessage")
_IMAGE_FORMS = ("", "/compressed", "/compressedDepth", "/theora")  # the topics of image_transport
_ENOUGH_IMAGES = 3  # as in rqt_graph


class BoxKind(str, Enum):
    """Kind of a box in the drawing."""

    TOPIC = "topic"
    ACTION = "action"  #: all topics and services of an action, with edges from clients to servers
    TF = "tf"  #: `/tf` and `/tf_static`
    IMAGES = "images"  #: the raw and compressed topics of one image

    def key(self, name: str) -> str:
        """Return the box's key, unique in the drawing."""
        return f"{self.value[0]}:{name}" if self is not BoxKind.TF else f"g:{name}"


@dataclass(frozen=True, order=True)
class End:
    """Endpoint of a node on a topic. Clients of an action count as publishers."""

    node: str
    is_publisher: bool
    type_name: str


@dataclass(frozen=True)
class TopicView:
    """Topic or action with its endpoints and its problem, if any."""

    name: str
    ends: tuple[End, ...]
    kind: BoxKind = BoxKind.TOPIC
    has_clash: bool = False  #: whether nodes use different types and exchange no messages
    guess: str | None = None  #: a published topic with a similar name, if this one has no publisher
    problem: str | None = None  #: a sentence about the problem, if there is a problem
    stands_for: tuple[str, ...] = ()  #: the topics that this box replaces

    @property
    def key(self) -> str:
        """The key of the topic's box, unique in the drawing."""
        return self.kind.key(self.name)

    @cached_property
    def types(self) -> tuple[str, ...]:
        """The types in use, sorted."""
        return tuple(sorted({end.type_name for end in self.ends}))

    @cached_property
    def publishers(self) -> tuple[str, ...]:
        """Full names of the nodes that publish, sorted."""
        return tuple(sorted({end.node for end in self.ends if end.is_publisher}))

    @cached_property
    def subscriptions(self) -> tuple[str, ...]:
        """Full names of the nodes that subscribe, sorted."""
        return tuple(sorted({end.node for end in self.ends if not end.is_publisher}))

    @property
    def is_active(self) -> bool:
        """Whether the topic has publishers and subscriptions."""
        return bool(self.publishers and self.subscriptions)

    def among(self, nodes: Collection[str]) -> TopicView:
        """Return a copy with only the endpoints of the given nodes."""
        return replace(self, ends=tuple(end for end in self.ends if end.node in nodes))

    def receives(self, subscription: str, publisher: str) -> bool:
        """Return whether two nodes use the same type. A box of several topics returns True."""
        if not self.has_clash or self.stands_for:
            return True
        types = self._types_of(publisher, is_publisher=True)
        return not types.isdisjoint(self._types_of(subscription, is_publisher=False))

    def has_no_receiver(self, publisher: str) -> bool:
        """Return whether subscriptions exist, but all with other types than the publisher."""
        listening = self.subscriptions
        return bool(listening) and not any(
            self.receives(listener, publisher) for listener in listening
        )

    def receives_nothing(self, subscription: str) -> bool:
        """Return whether a node gets no messages: types differ, or the name is misspelled."""
        talking = self.publishers
        if not talking:
            return self.guess is not None
        return not any(self.receives(subscription, talker) for talker in talking)

    def _types_of(self, node: str, *, is_publisher: bool) -> set[str]:
        return {
            end.type_name
            for end in self.ends
            if end.node == node and end.is_publisher is is_publisher
        }


def find_topics(snapshot: Snapshot, nodes: Collection[str], grouping: Grouping) -> list[TopicView]:
    """Return the topics and, with `grouping.actions`, the actions of the nodes, sorted by name."""
    topics: dict[str, list[End]] = {}
    actions: dict[str, list[End]] = {}
    for token in snapshot.endpoints:
        node = token.full_node_name
        if node not in nodes:
            continue
        if grouping.actions and ACTION_PART in token.name:
            _add_action_end(actions, token, node)
        elif token.kind in _TOPIC_KINDS:
            end = End(node, token.kind is EntityKind.PUBLISHER, token.type_name)
            topics.setdefault(token.name, []).append(end)
    made = {topic.name: topic for topic in _with_problems(topics, BoxKind.TOPIC)}
    if grouping.tf:
        _join(made, "/tf", TF_TOPICS, BoxKind.TF)
    if grouping.images:
        _join_images(made)
    return sorted(
        [*made.values(), *_with_problems(actions, BoxKind.ACTION)],
        key=lambda topic: (topic.name, topic.kind),
    )


def _add_action_end(actions: dict[str, list[End]], token: EndpointToken, node: str) -> None:
    name = token.name.partition(ACTION_PART)[0]
    is_client = token.kind in {EntityKind.CLIENT, EntityKind.SUBSCRIPTION}
    for suffix in _ACTION_ENDS:
        if token.type_name.endswith(suffix):
            end = End(node, is_client, token.type_name.removesuffix(suffix))
            actions.setdefault(name, []).append(end)


def _with_problems(found: Mapping[str, list[End]], kind: BoxKind) -> Iterator[TopicView]:
    # The publishers offer a topic. The servers offer an action, and count as subscriptions here.
    offers = kind is BoxKind.TOPIC
    offered = {n for n, ends in found.items() if any(e.is_publisher is offers for e in ends)}
    known = KnownNames(offered)
    for name, ends in found.items():
        topic = TopicView(name, tuple(sorted(set(ends))), kind)
        guess = None if name in offered else known.nearest(name)
        has_clash = len(topic.types) > 1
        problem = _clash(topic) if has_clash else _typo(topic, guess)
        yield replace(topic, has_clash=has_clash, guess=guess, problem=problem)


def _clash(topic: TopicView) -> str:
    uses = []
    for type_name in topic.types:
        nodes = sorted({end.node for end in topic.ends if end.type_name == type_name})
        uses.append(f"{type_name} ({', '.join(nodes)})")
    number = "two" if len(uses) == 2 else str(len(uses))
    return f"{number} types on one topic exchange no messages: {', '.join(uses)}"


def _typo(topic: TopicView, guess: str | None) -> str | None:
    if guess is None:
        return None
    lack = "nobody serves" if topic.kind is BoxKind.ACTION else "nobody publishes"
    return f"{lack} {topic.name}{question([guess], '; ')}"


def _join(made: dict[str, TopicView], name: str, parts: Iterable[str], kind: BoxKind) -> None:
    present = [made[part] for part in sorted(parts) if part in made]
    if len(present) < 2:
        return
    for topic in present:
        del made[topic.name]
    made[name] = TopicView(
        name,
        tuple(sorted({end for topic in present for end in topic.ends})),
        kind,
        has_clash=any(topic.has_clash for topic in present),
        problem=next((topic.problem for topic in present if topic.problem), None),
        stands_for=tuple(topic.name for topic in present),
    )


def _join_images(made: dict[str, TopicView]) -> None:
    for name in [name for name in made if name.endswith("/compressed")]:
        stem = name.removesuffix("/compressed")
        forms = [stem + form for form in _IMAGE_FORMS if stem + form in made]
        if len(forms) >= _ENOUGH_IMAGES:
            _join(made, stem + "/image_topics", forms, BoxKind.IMAGES)
