"""Open zbot's 3D view with the displays of an `.rviz` file, as ROS 2's rviz2 does.

Run:   zbot run rviz2 rviz2 -d robot.rviz
Needs: pip install "zbot[view]"
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import zbot
from zbot.executor.spin_thread import SpinThread
from zbot.observer.serving.browser import has_desktop
from zbot.parameters.ros_args import remove_ros_args
from zbot.process.signals import install
from zbot.view.arrangement.arrangement import Arrangement
from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.rviz_file import read_rviz_file
from zbot.view.server.server import Content, serve

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Options of rviz2 with a value: the first two are used, the others change nothing here.
_FILE, _FRAME = ("-d", "--display-config"), ("-f", "--fixed-frame")
_WITH_VALUE = (*_FILE, *_FRAME, "-s", "--splash-screen", "-t", "--display-title-format")


class Options(NamedTuple):
    """Options of the command line."""

    file: str = ""
    fixed_frame: str = ""


def read_options(words: Sequence[str]) -> Options:
    """Return the options of a command line of rviz2. As in rviz2, a file needs no option."""
    found = Options()
    rest = list(words)
    while rest:
        name, equals, value = rest.pop(0).partition("=")
        if name in _WITH_VALUE and not equals:
            value = rest.pop(0) if rest else ""
        if name in _FILE:
            found = found._replace(file=value)
        elif name in _FRAME:
            found = found._replace(fixed_frame=value)
        elif not name.startswith("-"):
            found = found._replace(file=name)
    return found


def arrangement_of(options: Options, node: zbot.Node) -> Arrangement:
    """Return the displays of a file. As in rviz2, a missing file is no reason to end."""
    found = Arrangement(fixed_frame=options.fixed_frame)
    if options.file:
        try:
            found = read_rviz_file(Path(options.file))
        except ArrangementError as error:
            node.get_logger().error(f"{error}; the usual displays are shown")
    return replace(found, fixed_frame=options.fixed_frame or found.fixed_frame)


def main() -> None:
    """Run until Ctrl-C."""
    options = read_options(remove_ros_args()[1:])
    with zbot.init():
        install(calls_ok=False)
        node = zbot.Node("rviz2")
        log = node.get_logger()
        content = Content(arrangement=arrangement_of(options, node), node=node)
        with SpinThread(node, "rviz2"):
            serve(open_browser=has_desktop(), content=content, tell=log.info, warn=log.warning)


if __name__ == "__main__":
    main()
