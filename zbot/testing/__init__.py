"""Fixtures of pytest for tests of nodes. Each test has a domain of its own.

    from std_msgs.msg import String
    from talker import Talker

    def test_it_says_hello(node, received):
        node(Talker)
        [message] = received("chatter", String)
        assert message.data == "hello"

pytest finds the fixtures by itself if zbot is installed. The classes below are those of the
fixtures, for type hints.
"""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names

if TYPE_CHECKING:
    from zbot.testing.fixtures import Call as Call
    from zbot.testing.fixtures import NodeFactory as NodeFactory
    from zbot.testing.fixtures import Received as Received
    from zbot.testing.fixtures import SpinUntil as SpinUntil
    from zbot.testing.fixtures import Start as Start
    from zbot.testing.program import Program as Program

__all__ = ["Call", "NodeFactory", "Program", "Received", "SpinUntil", "Start"]

# pytest imports this package at each start: it loads nothing until a test uses a fixture.
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "zbot.testing.fixtures": "Call NodeFactory Received SpinUntil Start",
        "zbot.testing.program": "Program",
    },
)
