from __future__ import annotations

import math

import pytest

from zbot.errors import WrongStateError
from zbot.libraries.camera_model import PinholeCameraModel, StereoCameraModel

from sensor_msgs.msg import CameraInfo

np = pytest.importorskip("numpy")


def info(baseline: float = 0.0) -> CameraInfo:
    """Return a camera of 640x480 with focal lengths of 300 and 200 pixels."""
    message = CameraInfo(width=640, height=480, d=[0.1, 0.0, 0.0, 0.0, 0.0])
    message.header.frame_id = "camera"
    message.k = [300.0, 0.0, 320.0, 0.0, 200.0, 240.0, 0.0, 0.0, 1.0]
    message.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    message.p = [300.0, 0.0, 320.0, -300.0 * baseline, 0.0, 200.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0]
    return message


@pytest.fixture
def camera() -> PinholeCameraModel:
    made = PinholeCameraModel()
    made.fromCameraInfo(info())
    return made


def test_a_point_has_a_pixel_and_a_pixel_has_a_direction(camera: PinholeCameraModel) -> None:
    assert camera.project_3d_to_pixel((1.0, -0.5, 2.0)) == (470.0, 190.0)
    ray = camera.project_pixel_to_3d_ray((470.0, 190.0))
    assert [2.0 * part / ray[2] for part in ray] == pytest.approx([1.0, -0.5, 2.0])
    assert math.hypot(*ray) == pytest.approx(1.0)
    assert all(math.isnan(part) for part in camera.project3dToPixel((1.0, 1.0, 0.0)))


def test_lengths_and_pixels_are_converted_at_a_depth(camera: PinholeCameraModel) -> None:
    assert (camera.get_delta_u(1.0, 2.0), camera.getDeltaV(1.0, 2.0)) == (150.0, 100.0)
    assert (camera.get_delta_x(150.0, 2.0), camera.getDeltaY(100.0, 2.0)) == (1.0, 1.0)
    assert camera.get_delta_u(1.0, 0.0) == math.inf


@pytest.mark.filterwarnings("ignore:the matrix subclass")  # ROS 2 returns this type
def test_the_calibration_has_old_and_new_names(camera: PinholeCameraModel) -> None:
    assert (camera.fx(), camera.fy(), camera.cx(), camera.cy()) == (300.0, 200.0, 320.0, 240.0)
    assert camera.fov_x() == pytest.approx(2 * math.atan(320 / 300))
    assert (camera.tfFrame(), camera.fullResolution()) == ("camera", (640, 480))
    assert isinstance(camera.K, np.matrix)
    assert (camera.intrinsic_matrix() == camera.K).all()
    assert camera.distortion_coeffs().shape == (5, 1)  # type: ignore[union-attr]


def test_binning_and_region_change_the_calibration() -> None:
    message = info()
    message.binning_x, message.binning_y = 2, 4
    message.roi.x_offset, message.roi.y_offset, message.roi.width = 20, 40, 100
    camera = PinholeCameraModel()
    camera.from_camera_info(message)
    assert (camera.fx(), camera.fy(), camera.cx(), camera.cy()) == (150.0, 50.0, 150.0, 50.0)
    assert camera.full_intrinsic_matrix()[0, 0] == 300.0


def test_a_disparity_is_a_depth() -> None:
    stereo = StereoCameraModel()
    left_info, right_info = info(), info(baseline=0.1)
    for message in (left_info, right_info):
        message.p[5] = 300.0
    stereo.fromCameraInfo(left_info, right_info)
    left, right = stereo.project_3d_to_pixel((0.3, 0.2, 2.0))
    disparity = left[0] - right[0]
    assert disparity == pytest.approx(15.0)
    assert stereo.projectPixelTo3d(left, disparity) == pytest.approx((0.3, 0.2, 2.0))
    assert (stereo.get_z(15.0), stereo.getDisparity(2.0)) == pytest.approx((2.0, 15.0))
    assert stereo.getZ(0.0) == math.inf


def test_an_empty_model_says_what_to_call() -> None:
    with pytest.raises(WrongStateError, match="call from_camera_info first"):
        PinholeCameraModel().fx()
