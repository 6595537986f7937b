"""Program that runs one node until Ctrl-C."""

from __future__ import annotations

import sys
from contextlib import nullcontext
from typing import TYPE_CHECKING

import zbot

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager


class ParameterError(zbot.ZbotError, ValueError):
    """A parameter has a value that the node cannot use."""


def run_node(
    make: Callable[[], zbot.Node],
    *,
    around: Callable[[zbot.Node], AbstractContextManager[object]] = nullcontext,
) -> None:
    """Create a node and spin it until Ctrl-C.

    An error of the node's constructor, e.g. a parameter of the wrong type, ends the program with
    one sentence on stderr and exit code 1.

    Args:
        make: The node's class, or a function that returns the node.
        around: A function that returns the `with` block in which the node is spun.
    """
    with zbot.init():
        try:
            node = make()
        except zbot.ZbotError as error:
            sys.exit(f"error: {error}")
        with around(node):
            zbot.spin(node)
