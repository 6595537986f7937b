"""Source of images: a webcam, a video file, or a folder of pictures. It needs OpenCV."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.errors import MissingPackageError
from zbot.log import get_logger

if TYPE_CHECKING:
    from collections.abc import Iterator

_NUMBER = re.compile(r"(?:/dev/video)?([0-9]{1,3})\Z")
_PICTURES = frozenset((".bmp", ".jpeg", ".jpg", ".pgm", ".png", ".ppm", ".tif", ".tiff", ".webp"))


class CameraError(zbot.ZbotError):
    """A camera, a video or a folder of pictures cannot be used."""


def opencv() -> Any:
    """Return OpenCV's module `cv2`.

    Raises:
        MissingPackageError: OpenCV is not installed.
    """
    # OpenCV would print lines of its own about a missing camera.
    os.environ.setdefault("OPENCV_LOG_LEVEL", "SILENT")
    try:
        import cv2  # noqa: PLC0415 - an extra, and takes a second to import
    except ImportError:
        raise MissingPackageError("a camera", "OpenCV", "camera") from None
    return cv2


class FrameSource:
    """Images, one after the other. A video and a folder begin again at their end.

    Args:
        device: `/dev/video0`, `0`, the path of a video file, or the path of a folder of pictures.
        width: Wanted width of a webcam's images in pixels.
        height: Wanted height.
        rate_hz: Wanted images per second of a webcam.

    Raises:
        MissingPackageError: OpenCV is not installed.
        CameraError: There is no such camera or file, or it has no image.
    """

    def __init__(self, device: str, width: int, height: int, rate_hz: float) -> None:
        self._cv2 = opencv()
        self._device = device
        self._capture: Any = None
        self._pictures: Iterator[Any] | None = None
        self._unreadable: set[Path] = set()
        path = Path(device).expanduser()
        if _NUMBER.match(device):
            self._open_webcam(device, width, height, rate_hz)
        elif path.is_dir():
            self._pictures = self._endless(path)
        else:
            self._open_video(path)
        self._first = self._next()
        if self._first is None:
            raise CameraError(f"{device} gives no image: {_no_image(device)}")

    def read(self) -> Any:
        """Return the next image as an array (height, width, 3) of blue, green and red, or None.

        None means that the camera gives no images any more, e.g. because it was unplugged.
        """
        if self._first is not None:
            frame, self._first = self._first, None
            return frame
        return self._next()

    def close(self) -> None:
        """Let other programs use the camera."""
        if self._capture is not None:
            self._capture.release()

    def _open_webcam(self, device: str, width: int, height: int, rate_hz: float) -> None:
        cv2 = self._cv2
        match = _NUMBER.match(device)
        assert match is not None
        self._capture = cv2.VideoCapture(int(match[1]))
        if not self._capture.isOpened():
            raise CameraError(_closed_camera(int(match[1])))
        self._capture.set(cv2.CAP_PROP_FRAME_WIDTH, width)
        self._capture.set(cv2.CAP_PROP_FRAME_HEIGHT, height)
        self._capture.set(cv2.CAP_PROP_FPS, rate_hz)
        self._capture.set(cv2.CAP_PROP_BUFFERSIZE, 1)  # the newest image, not an old one

    def _open_video(self, path: Path) -> None:
        if not path.is_file():
            raise CameraError(f"there is no camera, no video and no folder of pictures {path}")
        self._capture = self._cv2.VideoCapture(str(path))
        if not self._capture.isOpened():
            raise CameraError(f"{path} is no video that OpenCV can read")

    def _endless(self, folder: Path) -> Iterator[Any]:
        """Yield the pictures of a folder again and again, without those that cannot be read."""
        has_any = True
        while has_any:
            has_any = False
            found = sorted(path for path in folder.iterdir() if path.suffix.lower() in _PICTURES)
            for path in found:
                picture = self._picture(path)
                if picture is not None:
                    has_any = True
                    yield picture

    def _picture(self, path: Path) -> Any:
        import numpy as np  # noqa: PLC0415 - an extra

        # On Windows, `imread` opens no path with letters such as ü. `error` means that the file is
        # empty, or that the picture is too large.
        picture = None
        with contextlib.suppress(OSError, self._cv2.error):
            data = np.frombuffer(path.read_bytes(), np.uint8)
            picture = self._cv2.imdecode(data, self._cv2.IMREAD_COLOR)
        if picture is None and path not in self._unreadable:
            self._unreadable.add(path)
            get_logger("zbot.camera").warning(f"{path} is left out: OpenCV cannot read it")
        return picture

    def _next(self) -> Any:
        if self._pictures is not None:
            return next(self._pictures, None)
        is_read, frame = self._capture.read()
        if not is_read and not _NUMBER.match(self._device):
            self._capture.set(self._cv2.CAP_PROP_POS_FRAMES, 0)
            is_read, frame = self._capture.read()
        return frame if is_read else None


def _no_image(device: str) -> str:
    if _NUMBER.match(device):
        return "another program may use the camera"
    return "it needs pictures such as .png and .jpg, or a video"


def _closed_camera(number: int) -> str:
    """Return why a camera does not open, and what to do."""
    advice = "plug it in, or try another number; a video file or a folder of pictures works too"
    if not sys.platform.startswith("linux"):
        return f"the camera {number} does not open: close other programs that use it, or {advice}"
    path = f"/dev/video{number}"
    try:
        os.close(os.open(path, os.O_RDWR))
    except OSError as error:
        if error.errno in {errno.EACCES, errno.EPERM}:
            return (
                f"you may not use {path}: type `sudo usermod -a -G video $USER`, then log out and "
                "log in again"
            )
        if error.errno == errno.ENOENT:
            return f"there is no camera {path}: {advice}"
    return f"the camera {path} does not open: close other programs that use it"
