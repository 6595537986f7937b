"""Monitor, which hears all transforms of a domain, also those in namespaces."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from zbot.graph.snapshot import full_names
from zbot.names import is_hidden
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.tf2.broadcaster import TF_STATIC_TOPIC, TF_TOPIC
from zbot.tf2.buffer import Buffer
from zbot.tf2.diagnosis.diagnosis import Diagnosis
from zbot.tf2.diagnosis.link import is_static
from zbot.tf2.diagnosis.surroundings import CLOCK_TOPIC
from zbot.tf2.listener import TransformListener

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.clock import TimeJump
    from zbot.graph.snapshot import Snapshot
    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node

_DEPTH = 100
_LOOK_S = 1.0
_TYPE = "tf2_msgs/msg/TFMessage"


class TransformMonitor(TransformListener):
    """Listener that also says what is wrong with the transforms.

    The buffer gets the transforms of `/tf` and `/tf_static`. The diagnosis gets those of all topics
    with these names, e.g. `/robot1/tf`.

    Args:
        node: The node that subscribes. The caller spins it.
        buffer: The buffer. The default is a new one.

    Attributes:
        diagnosis: The diagnosis.
        has_listened: Whether transforms have had a second to come.
    """

    def __init__(self, node: Node, buffer: Buffer | None = None) -> None:
        self.diagnosis = Diagnosis(node.resolve_topic_name(TF_TOPIC))
        self._graph = node.context.graph
        self._graph.watch()
        self._topics: set[str] = set()
        super().__init__(Buffer() if buffer is None else buffer, node)
        self._timer = node.create_timer(_LOOK_S, self.look)
        self._look()
        self.has_listened = False

    def look(self) -> None:
        """Look for new topics of transforms, and for their nodes. A timer calls this."""
        self.has_listened = True
        self._look()

    def _look(self) -> None:
        snapshot = self._graph.snapshot()
        for topic, types in snapshot.topics():
            # A rule of the node may give the topic a name that has a subscription already.
            name = self.node.resolve_topic_name(topic)
            if _TYPE in types and _is_tf(topic) and name not in self._topics:
                profile = QoSProfile(depth=_DEPTH)
                if is_static(topic):
                    profile.durability = DurabilityPolicy.TRANSIENT_LOCAL
                self._subscribe(topic, _ignore, profile)
        self._note_endpoints(snapshot)

    def _note_endpoints(self, snapshot: Snapshot) -> None:
        topics, own = [*self._topics, CLOCK_TOPIC], self.node.get_fully_qualified_name()
        publishers = {name: sorted({*full_names(snapshot.publishers(name))}) for name in topics}
        listeners = {name: full_names(snapshot.subscriptions(name)) for name in topics}
        others = {
            topic: sorted({name for name in names if name != own and not is_hidden(name)})
            for topic, names in listeners.items()
        }
        self.diagnosis.set_endpoints(publishers, others)

    def _subscribe(self, topic: str, callback: Any, qos: QoSProfile | int) -> Any:
        name = self.node.resolve_topic_name(topic)
        self._topics.add(name)
        return super()._subscribe(topic, partial(self._take, name, callback), qos)

    def _take(
        self, topic: str, callback: Callable[[Any], object], message: Any, info: MessageInfo
    ) -> None:
        callback(message)
        gid = info["publisher_gid"]
        token = None if gid is None else self._graph.find(bytes(gid["data"]))
        name = "" if token is None else token.full_node_name
        self.diagnosis.add_message(
            message,
            topic,
            received_ns=info["received_timestamp"],
            sent_ns=info["source_timestamp"],
            publisher=name,
        )

    def _on_jump(self, jump: TimeJump) -> None:
        super()._on_jump(jump)
        self.diagnosis.clear()

    def explanation(self, target: str, source: str) -> str:
        """Return two lines that say why a transform is missing and what to do, or an empty text.

        The text begins with a line end. It is empty in the first second, in which nothing may have
        come yet.
        """
        found = self.diagnosis.why(target, source) if self.has_listened else None
        return "" if found is None else f"\n{found}"

    def unregister(self) -> None:
        """End the subscriptions. A second call is allowed."""
        self.node.destroy_timer(self._timer)
        super().unregister()


def _is_tf(topic: str) -> bool:
    return topic.endswith((TF_TOPIC, TF_STATIC_TOPIC))


def _ignore(_: Any) -> None:
    """Do nothing: the buffer does not get the transforms of other namespaces."""
