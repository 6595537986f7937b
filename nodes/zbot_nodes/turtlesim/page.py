"""Page of the turtle simulator. It opens in the browser of the user who started the simulator."""

from __future__ import annotations

from typing import TYPE_CHECKING
from urllib.parse import quote

from zbot_nodes.startup import page

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    import zbot


def shown(node: zbot.Node) -> AbstractContextManager[bool]:
    """Show a simulator in the browser during the `with` block, if the user has a desktop."""
    return page.shown(node, f"/turtle?node={quote(node.get_fully_qualified_name())}", "turtles")
