"""Service for web pages that show a turtlesim."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING

from turtlesim.msg import Color
from zbot_msgs.msg import SceneTurtle

if TYPE_CHECKING:
    from zbot_nodes.turtlesim.world import Turtle, TurtleWorld

    from zbot_msgs.srv import TurtleScene

#: Name of the service below the node's name. Names that begin with `_` are hidden.
SCENE = "~/_scene"


class Scene:
    """Server of the drawing and the turtles.

    A response has the lines that were drawn since `request.until`, or a picture of the whole
    drawing.

    Args:
        world: The world to show.
    """

    def __init__(self, world: TurtleWorld) -> None:
        self._world = world
        self._run = secrets.randbits(32)
        self.background = Color()

    def fill_response(
        self, request: TurtleScene.Request, response: TurtleScene.Response
    ) -> TurtleScene.Response:
        """Fill in a response."""
        drawing = self._world.drawing
        lines = drawing.since(request.until) if request.run == self._run else None
        if lines is None:
            response.sheet = drawing.picture()
        for line in lines or ():
            response.lines.extend(line[:4])
            response.pens.extend(line.pen[:4])
        response.run, response.until = self._run, drawing.until
        response.background = self.background
        response.turtles = [_seen(turtle) for turtle in self._world.turtles.values()]
        return response


def _seen(turtle: Turtle) -> SceneTurtle:
    pen = turtle.pen
    return SceneTurtle(
        name=turtle.name,
        x=turtle.x,
        y=turtle.y_up,
        theta=turtle.heading,
        pen=Color(r=pen.r, g=pen.g, b=pen.b),
        pen_width=pen.width,
        is_pen_down=pen.is_down,
    )
