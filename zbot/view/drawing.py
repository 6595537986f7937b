"""Drawing of shapes with viser. No other module of the view draws in the scene."""

from __future__ import annotations

import io
from dataclasses import dataclass, field, replace
from functools import singledispatchmethod
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.tf2.rigid import Rigid, normalized
from zbot.view.axes_model import axes_glb
from zbot.view.budget import MOVE_BYTES, size_of
from zbot.view.camera import ANGLE, camera_at
from zbot.view.colors import same
from zbot.view.errors import DisplayError
from zbot.view.level_of_detail import FEW_TRIANGLES, centre_and_radius, levels
from zbot.view.shape import (
    Arrows,
    Axes,
    Copies,
    Frustum,
    Gizmo,
    Item,
    Label,
    Lines,
    Mesh,
    Note,
    Picture,
    Plane,
    Points,
    Shape,
)
from zbot.view.tools.ray import Ray

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.tf2.rigid import Quaternion, Vector
    from zbot.view.camera import Camera
    from zbot.view.shape import Color

# Shadows and light from an environment cost more than all else where WebGL runs in software.
_UNSHADED: dict[str, Any] = {"cast_shadow": False, "receive_shadow": False}
# viser's pictures have y downwards.
_DOWNWARDS = Rigid(rotation=(1.0, 0.0, 0.0, 0.0))
_FRUSTUM_SIZE = 0.3
_ROOT = "/scene"
_LONGEST_LABEL = 2000
_LARGEST_HALF = 65_000.0
#: With 0.6 pixels and one sample for each (`software_webgl`), a thinner line can miss all samples.
_THINNEST_PX = 1.7


@dataclass
class _Node:
    """Node of the scene with the shapes of one item."""

    path: str
    handle: Any
    is_reused: bool  #: whether there were other nodes or shapes at its paths
    item: Item | None = None
    shapes: list[tuple[Shape, Any]] = field(default_factory=list)
    pose: Rigid = field(default_factory=Rigid)


class Drawing:
    """Scene in the browsers of all users.

    Args:
        server: The `viser.ViserServer`.
        is_thrifty: Whether points are sent with less precision: half of the bytes.

    Attributes:
        sent: About how many bytes have been sent for shapes and their poses.
    """

    def __init__(self, server: Any, *, is_thrifty: bool = False) -> None:
        self.sent = 0.0
        self._precision = "float16" if is_thrifty else "float32"
        self._server = server
        self._scene = server.scene
        self._nodes: dict[tuple[str, str], _Node] = {}
        self._count = 0
        self._free: dict[str, list[str]] = {}  #: paths of erased items, by display
        self._back = Rigid()
        self._root = self._scene.add_frame(_ROOT, show_axes=False)
        server.initial_camera.position = (-2.4, -2.4, 2.0)
        self._scene.configure_default_lights(True, cast_shadow=False)
        self._scene.configure_environment_map(None)
        self._scene.add_light_ambient("/light", intensity=1.2)

    def set_background(self, color: Color) -> None:
        """Fill the space behind the scene with a colour."""
        self._scene.set_background_image(same(color, 2, 2), format="png")

    def look(self, camera: Camera) -> None:
        """Place the camera in all browsers, also in those that open the view later."""
        cameras = [client.camera for client in self._server.get_clients().values()]
        for one in (self._server.initial_camera, *cameras):
            one.position = camera.position
            one.look_at = camera.focus
            one.fov = ANGLE

    def look_from(self, yaw: float, pitch: float) -> None:
        """Turn the camera in all browsers around the point that it looks at."""
        for client in self._server.get_clients().values():
            camera = client.camera
            present = camera_at(_vector(camera.position), _vector(camera.look_at))
            camera.position = replace(present, yaw=yaw, pitch=pitch).position
            camera.look_at = present.focus

    def centre(self) -> None:
        """Let the camera in all browsers look at the origin of the frame that it follows."""
        for client in self._server.get_clients().values():
            camera = client.camera
            camera.position, camera.look_at = camera.position - camera.look_at, (0.0, 0.0, 0.0)

    @property
    def camera(self) -> Camera | None:
        """The camera of one of the browsers, or None if there is no browser."""
        for client in self._server.get_clients().values():
            return camera_at(_vector(client.camera.position), _vector(client.camera.look_at))
        return None

    def follow(self, pose: Rigid) -> None:
        """Move the scene so that a pose in the fixed frame is where the camera's frame is.

        The camera of a browser belongs to its user, so the scene moves instead of the camera.
        """
        back = pose.inverse()
        if back != self._back:
            self._back = back
            self._root.position, self._root.wxyz = back.translation, _wxyz(back.rotation)

    def listen(self, click: Callable[[Ray], None] | None) -> None:
        """Call a function at each click, with a ray in the fixed frame, or at none.

        The function is called in a thread of viser.
        """
        self._scene.remove_click_callback()
        if click is not None:
            self._scene.on_click()(
                lambda event: click(
                    Ray(event.ray_origin, event.ray_direction).seen_from(self._back)
                )
            )

    def atomic(self) -> Any:
        """Return a context. Browsers show all changes that are made in it at once."""
        return self._server.atomic()

    def draw(self, display: str, name: str, item: Item) -> None:
        """Draw an item in place of the previous item of the same name. Its pose is unchanged.

        Args:
            display: A name for the display in the tree of the scene.
            name: The name of the item in its display.
            item: The item. If it is the same object as before, nothing is sent.
        """
        key = (display, name)
        node = self._nodes.get(key)
        if node is None:
            path, is_reused = self._free_path(display)
            handle = self._scene.add_frame(path, show_axes=False, visible=False)
            node = self._nodes[key] = _Node(path, handle, is_reused)
            if is_reused:
                _tell_pose(handle)
        if node.item is item:
            return
        node.item = item
        self.sent += size_of(item)
        new = [shape for shape in item.shapes if not isinstance(shape, (Picture, Note))]
        for place, shape in enumerate(new):
            self._put(node, place, shape)
        for _, handle in node.shapes[len(new) :]:
            handle.remove()
        del node.shapes[len(new) :]
        node.is_reused = True

    def _free_path(self, display: str) -> tuple[str, bool]:
        """Return a path for a new node, and whether another node had it before."""
        # viser keeps a message for each path that was removed and not used again.
        if free := self._free.get(display):
            return free.pop(), True
        self._count += 1
        return f"{_ROOT}/{display.replace('/', ' ').strip() or 'display'}/{self._count}", False

    def _put(self, node: _Node, place: int, shape: Shape) -> None:
        known = node.shapes[place] if place < len(node.shapes) else None
        if known is not None and known[0] is shape:
            return
        handle = None if known is None else self._changed(known, shape)
        if handle is None:
            if known is not None:
                known[1].remove()
            handle = self._add(shape, f"{node.path}/{place}")
            if node.is_reused:
                _tell_pose(handle)
        node.shapes[place : place + 1] = [(shape, handle)]

    @staticmethod
    def _changed(known: tuple[Shape, Any], shape: Shape) -> Any:
        """Change a shape that often changes. Return its handle, or None if it must be new."""
        old, handle = known
        if isinstance(shape, Points) and isinstance(old, Points):
            handle.points, handle.colors = _in_range(shape), shape.colors
            handle.point_size, handle.point_shape = shape.size, shape.shape
        elif isinstance(shape, Lines) and isinstance(old, Lines):
            handle.points, handle.colors = shape.ends, shape.colors
            handle.thickness = max(shape.width_px, _THINNEST_PX)
        elif isinstance(shape, Axes) and isinstance(old, Axes) and old.length == shape.length:
            handle.batched_wxyzs, handle.batched_positions = _arrays(shape)
        else:
            return None
        return handle

    def place(self, display: str, name: str, pose: Rigid | None) -> None:
        """Move an item to a pose in the fixed frame, or hide it if the pose is None."""
        node = self._nodes.get((display, name))
        if node is None:
            return
        node.handle.visible = pose is not None
        if pose is not None and pose != node.pose:
            node.pose = pose
            self.sent += MOVE_BYTES
            node.handle.position = pose.translation
            node.handle.wxyz = _wxyz(pose.rotation)

    def names(self, display: str) -> list[str]:
        """Return the names of a display's items."""
        return [name for its_display, name in self._nodes if its_display == display]

    def erase(self, display: str, name: str) -> None:
        """Remove an item."""
        node = self._nodes.pop((display, name))
        node.handle.remove()
        # What a user drags keeps its path: the next messages of the browser must move nothing else.
        if not any(isinstance(shape, Gizmo) for shape, _ in node.shapes):
            self._free.setdefault(display, []).append(node.path)

    @singledispatchmethod
    def _add(self, shape: Any, path: str) -> Any:
        raise DisplayError(f"a {type(shape).__name__} cannot be drawn at {path}")

    @_add.register
    def _(self, shape: Points, path: str) -> Any:
        return self._scene.add_point_cloud(
            path,
            _in_range(shape),
            shape.colors,
            point_size=shape.size,
            point_shape=shape.shape,
            precision=self._precision,
            point_shading="flat",
        )

    @_add.register
    def _(self, shape: Lines, path: str) -> Any:
        return self._scene.add_line_segments(
            path,
            shape.ends,
            shape.colors,
            thickness=max(shape.width_px, _THINNEST_PX),
            thickness_units="screen",
        )

    @_add.register
    def _(self, shape: Arrows, path: str) -> Any:
        return self._scene.add_arrows(
            path,
            shape.ends,
            shape.colors,
            shaft_radius=shape.shaft_radius,
            head_radius=shape.head_radius,
            head_length=shape.head_length,
        )

    @_add.register
    def _(self, shape: Axes, path: str) -> Any:
        rotations, positions = _arrays(shape)
        model = axes_glb(shape.length, shape.length / 30)
        return self._scene.add_batched_glb(
            path, model, rotations, positions, lod="off", **_UNSHADED
        )

    @_add.register
    def _(self, shape: Mesh, path: str) -> Any:
        if shape.has_levels and len(shape.faces) > FEW_TRIANGLES:
            return self._add_detailed(shape, path)
        return self._scene.add_mesh_simple(
            path,
            shape.vertices,
            shape.faces,
            color=shape.color,
            opacity=None if shape.opacity >= 1 else shape.opacity,
            position=shape.pose.translation,
            wxyz=_wxyz(shape.pose.rotation),
            **_UNSHADED,
        )

    def _add_detailed(self, shape: Mesh, path: str) -> Any:
        """Add a surface with many triangles: one copy of itself, as only copies get simpler."""
        centre, radius = centre_and_radius(shape)  # the distance of a copy is that of its origin
        return self._scene.add_batched_meshes_simple(
            path,
            shape.vertices - np.array(centre, np.float32),
            shape.faces,
            np.array([[1, 0, 0, 0]], np.float32),
            np.array([centre], np.float32),
            batched_colors=shape.color,
            opacity=None if shape.opacity >= 1 else shape.opacity,
            position=shape.pose.translation,
            wxyz=_wxyz(shape.pose.rotation),
            lod=levels(len(shape.faces), radius) or "off",
            **_UNSHADED,
        )

    @_add.register
    def _(self, shape: Copies, path: str) -> Any:
        count = len(shape.positions)
        return self._scene.add_batched_meshes_simple(
            path,
            shape.vertices,
            shape.faces,
            np.tile(np.array([1, 0, 0, 0], np.float32), (count, 1)),
            shape.positions,
            batched_scales=shape.scales,
            batched_colors=shape.colors,
            opacity=None if shape.opacity >= 1 else shape.opacity,
            lod="off",
            **_UNSHADED,
        )

    @_add.register
    def _(self, shape: Label, path: str) -> Any:
        options: dict[str, Any] = {"font_screen_scale": 0.7}
        if shape.height:
            options = {"font_size_mode": "scene", "font_scene_height": shape.height}
        text = shape.text[:_LONGEST_LABEL]
        return self._scene.add_label(
            path, text, position=shape.position, anchor="bottom-center", **options
        )

    @_add.register
    def _(self, shape: Plane, path: str) -> Any:
        pose = shape.pose @ _DOWNWARDS
        return self._scene.add_image(
            path,
            shape.pixels,
            shape.width,
            shape.height,
            format="png",
            position=pose.translation,
            wxyz=_wxyz(pose.rotation),
            **_UNSHADED,
        )

    @_add.register
    def _(self, shape: Frustum, path: str) -> Any:
        pixels = _pixels(shape.picture)
        return self._scene.add_camera_frustum(
            path,
            shape.vertical_angle,
            pixels.shape[1] / pixels.shape[0],
            scale=_FRUSTUM_SIZE,
            image=pixels,
            format="jpeg",
            **_UNSHADED,
        )

    @_add.register
    def _(self, shape: Gizmo, path: str) -> Any:
        handle = self._scene.add_transform_controls(
            path,
            scale=shape.scale,
            active_axes=shape.axes,
            disable_axes=not shape.has_arrows,
            disable_sliders=not shape.has_squares,
            disable_rotations=not shape.has_rings,
            depth_test=False,
        )

        # A coroutine: viser calls functions in several threads, so out of order.
        async def tell(event: Any) -> None:
            w, x, y, z = (float(part) for part in handle.wxyz)
            shape.moved(event.phase, Rigid(_vector(handle.position), normalized((x, y, z, w))))

        handle.on_update(tell)
        return handle


def _tell_pose(handle: Any) -> None:
    """Send the pose of a new node also if it is viser's default.

    A browser that has not read the removal of a former node with this path keeps its pose.
    """
    position, wxyz = tuple(handle.position), tuple(handle.wxyz)
    handle.position, handle.wxyz = (1.0, 2.0, 3.0), (0.5, 0.5, 0.5, 0.5)  # only a change is sent
    handle.position, handle.wxyz = position, wxyz


def _wxyz(rotation: Quaternion) -> tuple[float, float, float, float]:
    x, y, z, w = rotation
    return w, x, y, z


def _vector(array: Any) -> Vector:
    x, y, z = (float(part) for part in array)
    return x, y, z


def _arrays(axes: Axes) -> tuple[Any, Any]:
    rotations = np.array([_wxyz(pose.rotation) for pose in axes.poses], np.float32)
    positions = np.array([pose.translation for pose in axes.poses], np.float32)
    return rotations, positions


def _in_range(shape: Points) -> Any:
    """Return positions that numbers of 2 bytes can hold."""
    return np.clip(shape.positions, -_LARGEST_HALF, _LARGEST_HALF)


def _pixels(picture: Picture) -> Any:
    from PIL import Image  # noqa: PLC0415 - only pictures need it

    try:
        image = Image.open(io.BytesIO(picture.data))
        image.draft("RGB", (320, 240))  # a JPEG is read faster when it is small
        image.thumbnail((320, 320))
        return np.asarray(image.convert("RGB"))
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise DisplayError(f"the picture cannot be read: {error}") from error
