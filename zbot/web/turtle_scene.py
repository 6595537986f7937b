"""The turtles' world in a page: asks a simulator what is new, and has the browser draw it."""

from __future__ import annotations

import base64
import time
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.interfaces import get_service
from zbot.web.turtle_remote import SCENE_TYPE

if TYPE_CHECKING:
    from zbot.executor.task import Future
    from zbot.node.client import Client
    from zbot.web.lease import Lease
    from zbot.web.panel import Frame
    from zbot.web.turtle_remote import Simulator

#: Seconds to leave a simulator alone that could not answer.
_REST_S = 0.5


class SeenTurtle(NamedTuple):
    """A turtle as it was last seen."""

    name: str
    x: float  #: metres from the left edge
    y: float  #: metres from the lower edge
    theta: float  #: rad
    pen: tuple[int, int, int]
    pen_width: int
    is_pen_down: bool


class Stage:
    """One browser's view of one simulator at a time. Its methods belong to NiceGUI's loop.

    Args:
        frame: The page, whose browser has the function `zbotTurtle.show`.

    Attributes:
        turtles: Who was there when the simulator last answered, by name.
        background: Red, green and blue.
    """

    def __init__(self, frame: Frame) -> None:
        self._frame = frame
        self._client: Lease[Client[Any, Any]] | None = None
        self._request: Any = get_service(SCENE_TYPE).Request()  # type: ignore[attr-defined] # of each
        self._asked: Future[Any] | None = None
        self._rest_until = 0.0
        self._shown: list[Any] = []
        self.turtles: dict[str, SeenTurtle] = {}
        self.background = (0, 0, 0)

    def look_at(self, simulator: Simulator | None) -> None:
        """Show another simulator, or nothing."""
        if self._client is not None:
            self._frame.drop(self._client)
        self._client = self._asked = None
        self._shown, self.turtles = [], {}
        self._request.run = self._request.until = 0
        if simulator is not None:
            reader = self._frame.system.reader(simulator.scene, SCENE_TYPE)
            self._client = self._frame.keep(reader)

    def update(self) -> None:
        """Show what the simulator answered, and ask again; for `Frame.live`."""
        if self._client is None or time.monotonic() < self._rest_until:
            return
        asked, self._asked = self._asked, None
        if asked is not None and not asked.is_over:
            self._asked = asked
            return
        if asked is not None and asked.exception() is not None:
            self._rest_until = time.monotonic() + _REST_S  # it is gone, or going
            return
        if asked is not None:
            self._show(asked.result())
        self._asked = self._client.entity.call_async(self._request)

    def _show(self, scene: Any) -> None:
        self._request.run, self._request.until = scene.run, scene.until
        self.turtles = {one.name: _seen(one) for one in scene.turtles}
        self.background = (scene.background.r, scene.background.g, scene.background.b)
        standing = [self.background, *self.turtles.values()]
        if standing == self._shown and not scene.lines and not scene.sheet:
            return
        self._shown = standing
        self._frame.call("zbotTurtle.show", _picture(scene, self.background, self.turtles))


def _seen(turtle: Any) -> SeenTurtle:
    pen = (turtle.pen.r, turtle.pen.g, turtle.pen.b)
    return SeenTurtle(
        turtle.name,
        round(turtle.x, 3),
        round(turtle.y, 3),
        round(turtle.theta, 4),
        pen,
        turtle.pen_width,
        turtle.is_pen_down,
    )


def _picture(
    scene: Any, background: tuple[int, int, int], turtles: dict[str, SeenTurtle]
) -> dict[str, Any]:
    """Return what the browser draws, in pixels and as values that JSON has."""
    picture: dict[str, Any] = {
        "background": background,
        "turtles": [[one.name, one.x, one.y, one.theta] for one in turtles.values()],
        "lines": [round(one, 2) for one in scene.lines],
        "pens": list(scene.pens),
    }
    if scene.sheet:
        picture["sheet"] = base64.b64encode(bytes(scene.sheet)).decode()
    return picture
