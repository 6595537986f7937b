"""Web page of a node. It opens in the browser of the user who started the node."""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING

from zbot.errors.installation import pip_install
from zbot.observer.serving.browser import has_desktop, open_page
from zbot.web.server.page_discovery import running_page
from zbot.web.server.page_process import PageProcess, is_installed

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zbot

NO_BROWSER = "--no-browser"


@contextmanager
def shown(node: zbot.Node, path: str, what: str) -> Iterator[bool]:
    """Show a panel of the page in the browser during the `with` block, if the user has a desktop.

    If a page on this machine already shows the domain, this page is used. Otherwise a new page is
    served. With the option `--no-browser` or the variable `$ZBOT_NO_BROWSER`, no panel is shown.
    The value after `as` is whether a panel is shown.

    Args:
        node: A node of the domain. No executor spins it yet.
        path: The path and the query of the panel.
        what: What the panel shows, e.g. `turtles`.
    """
    if NO_BROWSER in sys.argv or os.environ.get("ZBOT_NO_BROWSER"):
        yield False
        return
    if not is_installed() or not has_desktop():
        how = f"Here is no desktop for a browser: `zbot web` prints the address of the {what}"
        get = f"The {what} can be seen in a browser: {pip_install('zbot[web]')}"
        node.get_logger().info(how if is_installed() else get)
        yield False
        return
    address = running_page(node)
    if address is not None:
        open_page(address + path)
        yield True
        return
    with PageProcess(path):
        yield True
