"""Tests of the scene that the page requests from turtlesim."""

from __future__ import annotations

import struct
import zlib

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot_nodes.turtlesim.drawing import Drawing, Line, Pen, png
from zbot_nodes.turtlesim.scene import Scene
from zbot_nodes.turtlesim.world import SIZE, TurtleWorld

from zbot_msgs.srv import TurtleScene

LINE = Line(10, 20, 30, 20, Pen(1, 2, 3, 4))


@pytest.fixture
def world() -> TurtleWorld:
    return TurtleWorld()


@pytest.fixture
def scene(world: TurtleWorld) -> Scene:
    return Scene(world)


def ask(scene: Scene, last: TurtleScene.Response | None = None) -> TurtleScene.Response:
    request = TurtleScene.Request(run=last.run, until=last.until) if last else TurtleScene.Request()
    return scene.fill_response(request, TurtleScene.Response())


def pixels(file: bytes) -> list[bytes]:
    """Return the rows of a PNG file as zbot writes it."""
    assert file.startswith(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
    begin = file.index(b"IDAT") + 4
    (size,) = struct.unpack(">I", file[begin - 8 : begin - 4])
    rows = zlib.decompress(file[begin : begin + size])
    width = struct.unpack(">I", file[16:20])[0] * 4 + 1
    return [rows[row + 1 : row + width] for row in range(0, len(rows), width)]


def test_the_first_request_gets_the_picture(scene: Scene, world: TurtleWorld) -> None:
    world.drawing.add(LINE)
    answer = ask(scene)
    rows = pixels(bytes(answer.sheet))
    assert len(rows) == 500
    assert rows[20][20 * 4 : 21 * 4] == bytes((1, 2, 3, 255))
    assert rows[100] == bytes((255, 255, 255, 0)) * 500
    assert not answer.lines


def test_a_later_request_gets_only_new_lines(scene: Scene, world: TurtleWorld) -> None:
    first = ask(scene)
    assert not ask(scene, first).lines
    world.drawing.add(LINE)
    answer = ask(scene, first)
    assert (answer.lines.tolist(), answer.pens.tolist()) == ([10, 20, 30, 20], [1, 2, 3, 4])
    assert not answer.sheet
    assert not ask(scene, answer).lines


def test_a_cleared_sheet_is_sent_as_a_picture(scene: Scene, world: TurtleWorld) -> None:
    first = ask(scene)
    world.clear()
    wiped = ask(scene, first)
    assert wiped.sheet
    assert not ask(scene, wiped).sheet
    world.reset()
    assert ask(scene, wiped).sheet


def test_a_request_for_another_simulator_gets_the_picture(scene: Scene) -> None:
    other = ask(Scene(TurtleWorld()))
    assert ask(scene, other).sheet


def test_more_lines_than_are_kept_are_sent_as_a_picture() -> None:
    drawing = Drawing()
    until = drawing.until
    drawing.add(LINE)
    assert drawing.since(until) == [LINE]
    for _ in range(drawing.lines.maxlen or 0):
        drawing.add(LINE)
    assert drawing.since(until) is None
    assert len(drawing.since(until + 1) or ()) == drawing.lines.maxlen


def test_turtles_are_sent_with_their_pens(scene: Scene, world: TurtleWorld) -> None:
    eve = world.spawn(1.0, 2.0, 0.5, "eve")
    assert eve is not None
    eve.set_pen(9, 8, 7, 6, 1)
    one, two = ask(scene).turtles
    assert (one.name, one.pen.r, one.pen_width, one.is_pen_down) == ("turtle1", 179, 3, True)
    assert (one.x, one.y) == pytest.approx((SIZE / 2, SIZE / 2))
    assert two.name == "eve"
    assert (two.x, two.y, two.theta) == pytest.approx((1.0, 2.0, 0.5))
    assert not two.is_pen_down


def test_a_png_has_its_checksums() -> None:
    file = png(1, 1, b"\1\2\3\4")
    assert file[12:16] == b"IHDR"
    assert struct.unpack(">I", file[29:33])[0] == zlib.crc32(file[12:29])
    assert pixels(file) == [b"\1\2\3\4"]
