"""Page of the turtle simulator. It opens in the browser of the user who started the simulator."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING
from urllib.parse import quote

from zbot.web.browser import has_desktop, open_page
from zbot.web.page_discovery import running_page
from zbot.web.page_process import PageProcess, is_installed

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zbot

NO_BROWSER = "--no-browser"
_HOW_TO_GET = "The turtles can be seen in a browser: pip install 'zbot[web]'"


@contextmanager
def shown(node: zbot.Node) -> Iterator[None]:
    """Show a simulator in the browser during the `with` block, if the user has a desktop.

    If a page on this machine already shows the domain, this page is used. Otherwise a new page is
    served. The option `--no-browser` or the variable `$ZBOT_NO_BROWSER` prevents both.
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
    with PageProcess(path):
        yield
