"""Shapes are drawn with viser, and only what has changed is sent."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.unit.view.messages import MESSAGES, cloud
from zbot.tf2.rigid import Rigid
from zbot.view.displays import DISPLAYS
from zbot.view.displays.image import Image
from zbot.view.displays.point_cloud import PointCloud2
from zbot.view.displays.tf import TF
from zbot.view.frames import Tree
from zbot.view.shape import Item, Mesh, Note, Picture, Points

from sensor_msgs.msg import CameraInfo

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.view.drawing import Drawing

PLATE = Mesh(np.eye(3, dtype=np.float32), np.array([[0, 1, 2]], np.uint32), (1, 2, 3))


@pytest.fixture(scope="module")
def server() -> Iterator[Any]:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    from zbot.view.server.viser_server import viser_server  # noqa: PLC0415 - the extra

    with viser_server(lambda _: True) as made:
        yield made


@pytest.fixture
def drawing(server: Any) -> Iterator[Drawing]:
    from zbot.view.drawing import Drawing  # noqa: PLC0415 - the extra

    yield Drawing(server)
    server.scene.reset()


def handle(drawing: Drawing, path: str) -> Any:
    return drawing._scene.get_handle_by_name(f"/scene{path}")


@pytest.mark.parametrize("name", MESSAGES)
def test_the_shapes_of_each_display_are_drawn(drawing: Drawing, name: str) -> None:
    display = next(kind for kind in DISPLAYS if kind.name == name)("/topic")
    if isinstance(display, Image):
        display.take(CameraInfo(height=200, k=[100.0, 0, 0, 0, 100.0, 0, 0, 0, 1]))
    display.take(MESSAGES[name])
    for key, item in display.items.items():
        drawing.draw(name, key, item)
        drawn = [shape for shape in item.shapes if not isinstance(shape, (Note, Picture))]
        for place in range(len(drawn)):
            assert handle(drawing, f"/{name}/1/{place}") is not None
        drawing.place(name, key, Rigid((1, 2, 3)))
        assert handle(drawing, f"/{name}/1").position == pytest.approx((1, 2, 3))
        drawing.erase(name, key)
        assert handle(drawing, f"/{name}/1") is None


def test_frames_are_moved_without_new_axes(drawing: Drawing) -> None:
    display = TF("/tf")
    for x in (1.0, 2.0):
        display.follow(Tree({"base": "odom"}, {"odom": Rigid(), "base": Rigid((x, 0, 0))}))
        drawing.draw("TF", "", display.items[""])
        axes = handle(drawing, "/TF/1/0")
        assert axes.batched_positions[1].tolist() == [x, 0, 0]
    first = handle(drawing, "/TF/1/0")
    display.follow(Tree({"base": "odom"}, {"odom": Rigid(), "base": Rigid((3, 0, 0))}))
    drawing.draw("TF", "", display.items[""])
    assert handle(drawing, "/TF/1/0") is first


def test_a_cloud_of_another_size_is_changed_in_place(drawing: Drawing) -> None:
    display = PointCloud2("/cloud")
    for count in (1, 3, 2):
        display.take(cloud([(1, 2, 3, 0)] * count))
        drawing.draw("cloud", "", display.items[""])
        assert handle(drawing, "/cloud/1/0").points.shape == (count, 3)
        assert handle(drawing, "/cloud/1/0").colors.shape == (count, 3)


def test_an_item_without_a_pose_is_hidden(drawing: Drawing) -> None:
    drawing.draw("a", "", Item("map", 0, ()))
    for pose in (None, Rigid(), None):
        drawing.place("a", "", pose)
        assert handle(drawing, "/a/1").visible is (pose is not None)


def test_erased_items_leave_nothing_behind(server: Any, drawing: Drawing) -> None:
    def draw_and_erase(number: int) -> None:
        points = Points(np.zeros((1, 3), np.float32), np.zeros((1, 3), np.uint8))
        drawing.draw("a", str(number), Item("map", 0, (points,)))
        drawing.place("a", str(number), Rigid((number, 0, 0)))
        drawing.erase("a", str(number))

    buffer = server._websock_server._broadcast_buffer
    draw_and_erase(0)
    count = len(buffer.message_from_id)
    for number in range(1, 10):
        draw_and_erase(number)
    assert len(buffer.message_from_id) == count


def test_an_item_at_the_path_of_an_erased_item_sends_its_pose(
    server: Any, drawing: Drawing
) -> None:
    drawing.draw("a", "far", Item("map", 0, (PLATE,)))
    drawing.place("a", "far", Rigid((9, 9, 9)))
    drawing.erase("a", "far")
    drawing.draw("a", "here", Item("map", 0, (PLATE,)))
    drawing.place("a", "here", Rigid())
    sent = list(server._websock_server._broadcast_buffer.message_from_id.values())
    for path in ("/scene/a/1", "/scene/a/1/0"):
        poses = [
            list(getattr(message, name))
            for message in sent
            for name in ("wxyz", "position")
            if getattr(message, "name", "") == path and hasattr(message, name)
        ]
        assert sorted(poses) == [[0, 0, 0], [1, 0, 0, 0]]


def test_only_the_guard_reaches_visers_server() -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    import viser  # noqa: PLC0415 - the extra
    from websockets.exceptions import ConnectionClosed  # noqa: PLC0415 - viser has it
    from websockets.sync.client import connect  # noqa: PLC0415 - as above

    from zbot.view.server.viser_server import viser_server  # noqa: PLC0415 - as above

    own: set[int] = set()
    protocol: Any = f"viser-v{viser.__version__}"
    with viser_server(own.__contains__) as server:
        server.scene.add_frame("/secret")
        address = f"ws://127.0.0.1:{server.get_port()}"
        with connect(address, subprotocols=[protocol]) as stranger:
            with pytest.raises(ConnectionClosed) as closed:
                stranger.recv(timeout=10)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 1008
        assert server.request_share_url() is None


def test_viser_prints_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    from zbot.view.server.viser_server import viser_server  # noqa: PLC0415 - the extra

    with contextlib.suppress(KeyboardInterrupt), viser_server(lambda _: True):
        raise KeyboardInterrupt
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("has_levels", [True, False])
def test_a_large_surface_of_a_file_gets_simpler_from_afar(
    drawing: Drawing, has_levels: bool
) -> None:
    places = np.random.default_rng(1).uniform(10, 12, (6000, 3)).astype(np.float32)
    faces = np.arange(6000, dtype=np.uint32).reshape(2000, 3)
    mesh = Mesh(places, faces, (1, 2, 3), 0.5, Rigid((1, 0, 0)), has_levels)
    drawing.draw("a", "", Item("map", 0, (mesh,)))
    drawn = handle(drawing, "/a/1/0")
    assert hasattr(drawn, "lod") is has_levels
    assert (drawn.position.tolist(), drawn.opacity) == ([1, 0, 0], 0.5)
    if has_levels:
        assert [round(part * 2000) for _, part in drawn.lod] == [500, 150]
        assert (drawn.vertices + drawn.batched_positions) == pytest.approx(places, abs=1e-5)
