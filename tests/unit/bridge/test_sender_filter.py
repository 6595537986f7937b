from __future__ import annotations

from zbot.bridge.sender_filter import SenderFilter

NODE, BRIDGE, NEW = b"node", b"bridge", b"new"


class Topic:
    """Topic whose senders a test tells."""

    def __init__(self) -> None:
        self.now_s = 0.0
        self.known = {NODE: False, BRIDGE: True}
        self.passed: list[bytes] = []
        self.lines: list[str] = []
        self.filter = SenderFilter(
            "/scan", self.is_of_bridge, self.passed.append, self, lambda: self.now_s
        )
        self.take, self.release = self.filter.take, self.filter.release

    def is_of_bridge(self, _name: str, sender: bytes) -> bool | None:
        return self.known.get(sender)

    def warning(self, message: str) -> None:
        self.lines.append(message)


def test_messages_of_bridges_are_left_out() -> None:
    topic = Topic()
    topic.take(NODE, b"1")
    topic.take(BRIDGE, b"2")
    assert topic.passed == [b"1"]


def test_messages_wait_in_their_order_until_their_sender_is_known() -> None:
    topic = Topic()
    topic.take(NEW, b"1")
    topic.release()
    assert topic.passed == []
    topic.known[NEW] = False
    topic.take(NEW, b"2")
    assert topic.passed == [b"1", b"2"]


def test_messages_of_an_unknown_bridge_are_never_passed_on() -> None:
    topic = Topic()
    topic.take(NEW, b"1")
    topic.known[NEW] = True
    topic.release()
    topic.take(NEW, b"2")
    assert topic.passed == []


def test_an_unknown_sender_does_not_delay_others() -> None:
    topic = Topic()
    topic.take(NEW, b"1")
    topic.take(NODE, b"2")
    assert topic.passed == [b"2"]


def test_a_sender_that_stays_unknown_is_delayed_only_at_first() -> None:
    topic = Topic()
    topic.take(NEW, b"1")
    topic.now_s = 3.0
    topic.release()
    topic.take(NEW, b"2")
    assert topic.passed == [b"1", b"2"]
    topic.known[NEW] = True
    topic.take(NEW, b"3")
    assert topic.passed == [b"1", b"2"]


def test_the_oldest_messages_are_dropped_if_too_many_bytes_wait() -> None:
    topic = Topic()
    pictures = [bytes([number]) * 9_000_000 for number in range(4)]
    for picture in pictures:
        topic.take(NEW, picture)
    topic.known[NEW] = False
    topic.release()
    assert topic.passed == pictures[2:]
    assert len(topic.lines) == 1
