"""Display Image: the picture of a camera, beside the scene and in what the camera sees."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.observer.image_encoder import IMAGE_TYPES, ImageError, encode_jpeg, media_type
from zbot.view.displays.display import Display, Setting, item
from zbot.view.errors import DisplayError
from zbot.view.shape import Frustum, Item, Picture

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Shape

_MOST_BYTES = 20_000_000
_CAMERA_INFO = "CameraInfo"


class Image(Display):
    """Picture of a camera. With a CameraInfo, the pyramid that the camera sees is drawn too."""

    name = "Image"
    types = IMAGE_TYPES
    settings = (Setting("in the scene", True),)

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._angle = 0.0  # vertical angle of view in rad; 0 if it is unknown

    @property
    def more_topics(self) -> Sequence[str]:
        """The topic of the camera's data: `camera_info` beside the topic of the pictures."""
        base = self.topic.removesuffix("/compressed").rpartition("/")[0]
        return (f"{base}/camera_info",)

    def take(self, message: Any) -> None:
        """Show a picture, or keep the angle of view of a CameraInfo."""
        if type(message).__name__ == _CAMERA_INFO:
            self._angle = vertical_angle(message)
            return
        self.notice = ""
        shapes = self.shapes(message)
        is_placed = any(isinstance(shape, Frustum) for shape in shapes)
        self.items = {"": item(message.header, shapes) if is_placed else Item("", 0, tuple(shapes))}

    def shapes(self, message: Any) -> list[Shape]:
        """Return the picture, and the pyramid if the angle of view is known."""
        data, media = encoded(message)
        picture = Picture(data, media)
        if not self._angle or not self.values["in the scene"]:
            return [picture]
        return [picture, Frustum(picture, self._angle)]


def encoded(message: Any) -> tuple[bytes, str]:
    """Return the bytes of a picture that browsers can show, and their media type.

    Raises:
        DisplayError: The picture cannot be shown.
    """
    if len(message.data) > _MOST_BYTES:
        raise DisplayError(f"the picture has {len(message.data)} bytes: the limit is {_MOST_BYTES}")
    try:
        if hasattr(message, "format"):
            data = bytes(message.data)
            return data, media_type(data)
        return encode_jpeg(message), "image/jpeg"
    except ImageError as error:
        raise DisplayError(str(error)) from error


def vertical_angle(info: Any) -> float:
    """Return the vertical angle of view of a `CameraInfo` in rad, or 0 if it is not calibrated."""
    focal = info.k[4]
    if not (math.isfinite(focal) and focal > 0 and info.height):
        return 0.0
    return 2 * math.atan2(info.height / 2, focal)
