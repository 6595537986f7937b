"""Scene of a turtle simulator in a page, with turtles, lines and background."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.interfaces import get_service
from zbot.threads.deadline import Deadline
from zbot.web.panels.turtle.turtle_control import SCENE_TYPE

if TYPE_CHECKING:
    from zbot.executor.task import Future
    from zbot.node.client import Client
    from zbot.observer.shared_entities import EntityReference
    from zbot.web.page.panel import Page
    from zbot.web.panels.turtle.turtle_control import Simulator

#: Seconds between a failed request and the next request.
_RETRY_S = 0.5


class SeenTurtle(NamedTuple):
    """Turtle in the last response of the simulator."""

    name: str
    x: float  #: metres from the left edge
    y: float  #: metres from the lower edge
    theta: float  #: rad
    pen: tuple[int, int, int]
    pen_width: int
    is_pen_down: bool


class SceneView:
    """View that shows one simulator in one page. Call its methods in NiceGUI's loop.

    Args:
        page: The page, whose browser has the function `zbotTurtle.show`.

    Attributes:
        turtles: The turtles in the last response, by name.
        background: The red, green and blue of the background.
    """

    def __init__(self, page: Page) -> None:
        self._page = page
        self._client: EntityReference[Client[Any, Any]] | None = None
        self._request: Any = get_service(SCENE_TYPE).Request()  # type: ignore[attr-defined] # each service has it
        self._asked: Future[Any] | None = None
        self._pause = Deadline(0)
        self._shown: list[Any] = []
        self.turtles: dict[str, SeenTurtle] = {}
        self.background = (0, 0, 0)

    def look_at(self, simulator: Simulator | None) -> None:
        """Show another simulator, or no simulator if it is None."""
        if self._client is not None:
            self._page.drop(self._client)
        self._client = self._asked = None
        self._shown, self.turtles = [], {}
        self._request.run = self._request.until = 0
        if simulator is not None:
            reader = self._page.system.reader(simulator.scene, SCENE_TYPE)
            self._client = self._page.keep(reader)

    def update(self) -> None:
        """Show the simulator's response and send the next request. `Page.live` calls it."""
        if self._client is None or not self._pause.is_over:
            return
        asked, self._asked = self._asked, None
        if asked is not None and not asked.is_over:
            self._asked = asked
            return
        if asked is not None and asked.exception() is not None:
            self._pause = Deadline(_RETRY_S)  # the simulator has probably ended
            return
        if asked is not None:
            self._show(asked.result())
        self._asked = self._client.entity.call_server_async(self._request)

    def _show(self, scene: Any) -> None:
        self._request.run, self._request.until = scene.run, scene.until
        self.turtles = {turtle.name: _seen(turtle) for turtle in scene.turtles}
        self.background = (scene.background.r, scene.background.g, scene.background.b)
        standing = [self.background, *self.turtles.values()]
        if standing == self._shown and not scene.lines and not scene.sheet:
            return
        self._shown = standing
        self._page.call("zbotTurtle.show", _picture(scene, self.background, self.turtles))


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
    """Return the arguments of `zbotTurtle.show`, as JSON values."""
    picture: dict[str, Any] = {
        "background": background,
        "turtles": [[turtle.name, turtle.x, turtle.y, turtle.theta] for turtle in turtles.values()],
        "lines": [round(number, 2) for number in scene.lines],
        "pens": list(scene.pens),
    }
    if scene.sheet:
        picture["sheet"] = base64.b64encode(bytes(scene.sheet)).decode()
    return picture
