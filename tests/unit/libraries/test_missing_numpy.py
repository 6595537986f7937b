"""What needs numpy says how to install it, in one sentence."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import pytest

from zbot.bag.columns import to_numpy
from zbot.errors import MissingPackageError
from zbot.libraries.camera_model import PinholeCameraModel
from zbot.libraries.cloud_transform import do_transform_cloud
from zbot.libraries.image_array import CvBridge
from zbot.libraries.laser_projection import LaserProjection
from zbot.libraries.point_cloud import create_cloud_xyz32, read_points

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, LaserScan, PointCloud2
from std_msgs.msg import Header

if TYPE_CHECKING:
    from collections.abc import Callable

CAMERA = CameraInfo()  # made here, because the first one imports numpy


@pytest.mark.parametrize(
    ("call", "user"),
    [
        (CvBridge, "cv_bridge"),
        (lambda: list(read_points(PointCloud2())), "point_cloud2"),
        (lambda: create_cloud_xyz32(Header(), [(1.0, 2.0, 3.0)]), "point_cloud2"),
        (lambda: LaserProjection().projectLaser(LaserScan()), "laser_geometry"),
        (lambda: PinholeCameraModel().from_camera_info(CAMERA), "image_geometry"),
        (lambda: do_transform_cloud(PointCloud2(), TransformStamped()), "tf2_sensor_msgs"),
        (lambda: to_numpy("bag", "/chatter"), r"to_numpy\(\)"),
    ],
)
def test_a_function_that_needs_numpy_says_how_to_install_it(
    monkeypatch: pytest.MonkeyPatch, call: Callable[[], Any], user: str
) -> None:
    monkeypatch.delitem(sys.modules, "numpy", raising=False)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    with pytest.raises(
        MissingPackageError, match=rf'^{user} needs numpy: .* -m pip install "zbot\[numpy'
    ):
        call()
