"""Showing the turtles to whoever started them, in the browser."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING
from urllib.parse import quote

from zbot.web.announcement import running_page
from zbot.web.browser import has_desktop, open_page
from zbot.web.companion import Companion, is_installed

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zbot

NO_BROWSER = "--no-browser"
_HOW_TO_GET = "The turtles can be seen in a browser: pip install 'zbot[web]'"


@contextmanager
def shown(node: zbot.Node) -> Iterator[None]:
    """Show a simulator in the browser meanwhile, unless nobody is there or wants to see it.

    A page of this machine that shows the domain already is used; otherwise one is served. The
    option `--no-browser` and `$ZBOT_NO_BROWSER` prevent it.
    """
    if NO_BROWSER in sys.argv or not has_desktop():
        yield
        return
    if not is_installed():
        node.get_logger().info(_HOW_TO_GET)
        yield
        return
    path = f"/turtle?node={quote(node.get_fully_qualified_name())}"
    address = running_page(node)
    if address is not None:
        open_page(address + path)
        yield
        return
    with Companion(path):
        yield
