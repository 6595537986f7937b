"""Geometry of calibrated cameras: ROS 2's package `image_geometry`.

This module needs numpy (`pip install "zbot[numpy]"`). Only `rectify_image` and `rectify_point` need
OpenCV. Methods have the names of ROS 2 Jazzy and later, and their older names.
"""

from __future__ import annotations

import copy
import math
from typing import TYPE_CHECKING, Any

from zbot.errors import WrongStateError, require_numpy
from zbot.errors.installation import pip_install

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from sensor_msgs.msg import CameraInfo

    Matrix = NDArray[np.float64]


def _opencv() -> Any:
    try:
        import cv2  # type: ignore[import-not-found,unused-ignore] # noqa: PLC0415 - optional
    except ImportError:
        text = f"rectifying needs OpenCV: {pip_install('opencv-python-headless')}"
        raise WrongStateError(text) from None
    return cv2


def _as_matrix(method: Callable[[PinholeCameraModel], Matrix | None]) -> Any:
    """Return a method with the older result, a `numpy.matrix`."""

    def older(self: PinholeCameraModel) -> Any:
        import numpy as np  # noqa: PLC0415 - part of an extra

        value = method(self)
        return None if value is None else np.asmatrix(value)

    older.__doc__ = "Return the same as a `numpy.matrix`."
    return older


class PinholeCameraModel:
    """Camera without distortion, or with distortion that can be removed (rectified).

    `from_camera_info` must be called first. Pixels are (u, v): to the right and down. Points are
    (x, y, z) in metres in the frame of the camera: to the right, down and forward.
    """

    def __init__(self) -> None:
        self._info: CameraInfo | None = None
        self.mapx: Any = None
        self.mapy: Any = None

    def from_camera_info(self, msg: CameraInfo) -> None:
        """Take the calibration, the binning and the region of interest of a message."""
        require_numpy("image_geometry")
        import numpy as np  # noqa: PLC0415 - part of an extra

        self._info = msg
        self._full_k = np.array(msg.k, np.float64).reshape(3, 3)
        self._full_p = np.array(msg.p, np.float64).reshape(3, 4)
        self._r = np.array(msg.r, np.float64).reshape(3, 3)
        self._d = np.array(msg.d, np.float64).reshape(-1, 1) if len(msg.d) else None
        self.binning_x, self.binning_y = max(1, msg.binning_x), max(1, msg.binning_y)
        self.raw_roi = copy.deepcopy(msg.roi)
        roi = self.raw_roi
        if not (roi.x_offset or roi.y_offset or roi.width or roi.height):
            roi.width, roi.height = msg.width, msg.height
        self._k: Matrix = self._full_k.copy()
        self._p: Matrix = self._full_p.copy()
        for matrix in (self._k, self._p):
            matrix[0, 2] -= roi.x_offset
            matrix[1, 2] -= roi.y_offset
            for row, binning in enumerate((self.binning_x, self.binning_y)):
                matrix[row, row] /= binning
                matrix[row, 2] /= binning

    def _camera_info(self) -> CameraInfo:
        if self._info is None:
            raise WrongStateError("the camera model is empty: call from_camera_info first")
        return self._info

    # -- pixels and points ---------------------------------------------------------------------

    def project_3d_to_pixel(self, point: Sequence[float]) -> tuple[float, float]:
        """Return the pixel of a point in the rectified image. It is NaN for a point at depth 0."""
        p = self.projection_matrix()
        u, v, w = p @ [point[0], point[1], point[2], 1.0]
        return (float(u / w), float(v / w)) if w else (math.nan, math.nan)

    def project_pixel_to_3d_ray(self, uv: Sequence[float]) -> tuple[float, float, float]:
        """Return the direction of a pixel of the rectified image, as a vector of length 1."""
        x, y = (uv[0] - self.cx()) / self.fx(), (uv[1] - self.cy()) / self.fy()
        length = math.sqrt(x * x + y * y + 1)
        return x / length, y / length, 1 / length

    def rectify_image(self, raw: Any, rectified: Any) -> None:
        """Write the rectified image of an array into another array of the same shape.

        Raises:
            WrongStateError: OpenCV is not installed, or there is no calibration yet.
        """
        cv2, size = _opencv(), self.full_resolution()
        self.mapx, self.mapy = cv2.initUndistortRectifyMap(
            self._k, self._d, self._r, self._p[:, :3], size, cv2.CV_32FC1
        )
        cv2.remap(raw, self.mapx, self.mapy, cv2.INTER_CUBIC, rectified)

    def rectify_point(self, uv_raw: Sequence[float]) -> Matrix:
        """Return the rectified pixel of a pixel.

        Raises:
            WrongStateError: OpenCV is not installed, or there is no calibration yet.
        """
        import numpy as np  # noqa: PLC0415 - part of an extra

        self._camera_info()
        pixel = np.array(uv_raw, np.float64).reshape(1, 1, 2)
        found = _opencv().undistortPoints(pixel, self._k, self._d, R=self._r, P=self._p)
        rectified: Matrix = found[0, 0]
        return rectified

    def get_delta_u(self, delta_x: float, z: float) -> float:
        """Return a length along x in metres at a depth as a number of pixels."""
        return self.fx() * delta_x / z if z else math.inf

    def get_delta_v(self, delta_y: float, z: float) -> float:
        """Return a length along y in metres at a depth as a number of pixels."""
        return self.fy() * delta_y / z if z else math.inf

    def get_delta_x(self, delta_u: float, z: float) -> float:
        """Return a number of pixels along u at a depth as a length in metres."""
        return z * delta_u / self.fx()

    def get_delta_y(self, delta_v: float, z: float) -> float:
        """Return a number of pixels along v at a depth as a length in metres."""
        return z * delta_v / self.fy()

    # -- calibration ---------------------------------------------------------------------------

    def intrinsic_matrix(self) -> Matrix:
        """Return K, for binning and region of interest."""
        self._camera_info()
        return self._k

    def distortion_coeffs(self) -> Matrix | None:
        """Return D as a column, or None for an image without distortion."""
        self._camera_info()
        return self._d

    def rotation_matrix(self) -> Matrix:
        """Return R, the rotation to the rectified image."""
        self._camera_info()
        return self._r

    def projection_matrix(self) -> Matrix:
        """Return P, for binning and region of interest."""
        self._camera_info()
        return self._p

    def full_intrinsic_matrix(self) -> Matrix:
        """Return K of the whole image."""
        self._camera_info()
        return self._full_k

    def full_projection_matrix(self) -> Matrix:
        """Return P of the whole image."""
        self._camera_info()
        return self._full_p

    def full_resolution(self) -> tuple[int, int]:
        """Return width and height of the whole image."""
        return self.width, self.height

    def cx(self) -> float:
        """Return u of the centre."""
        return float(self.projection_matrix()[0, 2])

    def cy(self) -> float:
        """Return v of the centre."""
        return float(self.projection_matrix()[1, 2])

    def fx(self) -> float:
        """Return the focal length along u in pixels."""
        return float(self.projection_matrix()[0, 0])

    def fy(self) -> float:
        """Return the focal length along v in pixels."""
        return float(self.projection_matrix()[1, 1])

    def tx(self) -> float:
        """Return the translation along x in P."""
        return float(self.projection_matrix()[0, 3])

    def ty(self) -> float:
        """Return the translation along y in P."""
        return float(self.projection_matrix()[1, 3])

    def fov_x(self) -> float:
        """Return the angle of view along u in radians."""
        return 2 * math.atan(self.width / (2 * self.fx()))

    def fov_y(self) -> float:
        """Return the angle of view along v in radians."""
        return 2 * math.atan(self.height / (2 * self.fy()))

    def get_tf_frame(self) -> str:
        """Return the frame of the camera."""
        return self._camera_info().header.frame_id

    width = property(lambda self: self._camera_info().width)
    height = property(lambda self: self._camera_info().height)
    stamp = property(lambda self: self._camera_info().header.stamp)
    tf_frame = property(get_tf_frame)
    resolution = property(full_resolution)

    # -- older names ---------------------------------------------------------------------------

    fromCameraInfo = from_camera_info
    project3dToPixel = project_3d_to_pixel
    projectPixelTo3dRay = project_pixel_to_3d_ray
    rectifyImage, rectifyPoint = rectify_image, rectify_point
    getDeltaU, getDeltaV = get_delta_u, get_delta_v
    getDeltaX, getDeltaY = get_delta_x, get_delta_y
    intrinsicMatrix = _as_matrix(intrinsic_matrix)
    distortionCoeffs = _as_matrix(distortion_coeffs)
    rotationMatrix = _as_matrix(rotation_matrix)
    projectionMatrix = _as_matrix(projection_matrix)
    fullIntrinsicMatrix = _as_matrix(full_intrinsic_matrix)
    fullProjectionMatrix = _as_matrix(full_projection_matrix)
    fullResolution = full_resolution
    Tx, Ty, fovX, fovY, tfFrame = tx, ty, fov_x, fov_y, get_tf_frame
    K, D = property(intrinsicMatrix), property(distortionCoeffs)
    R, P = property(rotationMatrix), property(projectionMatrix)
    full_K, full_P = property(fullIntrinsicMatrix), property(fullProjectionMatrix)


class StereoCameraModel:
    """Two cameras side by side, whose images are rectified. Points are in the left camera's frame.

    `from_camera_info` must be called first.
    """

    def __init__(self) -> None:
        self.left, self.right = PinholeCameraModel(), PinholeCameraModel()

    def from_camera_info(self, left_msg: CameraInfo, right_msg: CameraInfo) -> None:
        """Take the calibrations of both cameras."""
        self.left.from_camera_info(left_msg)
        self.right.from_camera_info(right_msg)

    @property
    def Q(self) -> Matrix:
        """The matrix that turns u, v, disparity and 1 into a point."""
        import numpy as np  # noqa: PLC0415 - part of an extra

        right = self.right
        q = np.zeros((4, 4))
        q[0, 0] = q[1, 1] = 1.0
        q[:3, 3] = -right.cx(), -right.cy(), right.fx()
        q[3, 2] = -right.fx() / right.tx()
        return q

    def project_3d_to_pixel(self, point: Sequence[float]) -> tuple[tuple[float, float], ...]:
        """Return the pixels of a point in the left and in the right image."""
        return self.left.project_3d_to_pixel(point), self.right.project_3d_to_pixel(point)

    def project_pixel_to_3d(
        self, left_uv: Sequence[float], disparity: float
    ) -> tuple[float, float, float]:
        """Return the point at a pixel of the left image. It is (0, 0, 0) without a disparity."""
        x, y, z, w = self.Q @ [left_uv[0], left_uv[1], disparity, 1.0]
        return (float(x / w), float(y / w), float(z / w)) if w else (0.0, 0.0, 0.0)

    def get_z(self, disparity: float) -> float:
        """Return the depth in metres for a disparity in pixels."""
        return -self.right.tx() / disparity if disparity else math.inf

    def get_disparity(self, z: float) -> float:
        """Return the disparity in pixels for a depth in metres."""
        return -self.right.tx() / z if z else math.inf

    def get_tf_frame(self) -> str:
        """Return the frame of the points."""
        return self.left.get_tf_frame()

    def get_left_camera(self) -> PinholeCameraModel:
        """Return the left camera."""
        return self.left

    def get_right_camera(self) -> PinholeCameraModel:
        """Return the right camera."""
        return self.right

    fromCameraInfo, tfFrame = from_camera_info, get_tf_frame
    project3dToPixel, projectPixelTo3d = project_3d_to_pixel, project_pixel_to_3d
    getZ, getDisparity = get_z, get_disparity
