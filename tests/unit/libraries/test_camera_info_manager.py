from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.libraries.camera_calibration import (
    CameraInfoError,
    loadCalibrationFile,
    saveCalibrationFile,
)
from zbot.libraries.camera_info_manager import (
    CameraInfoManager,
    CameraInfoMissingError,
    URL_empty,
    URL_file,
    URL_invalid,
    URL_package,
    genCameraName,
    parseURL,
    resolveURL,
)

from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext

FILE = """image_width: 640
image_height: 480
camera_name: left
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0, 0, 0, 0.5]}
camera_matrix: {rows: 3, cols: 3, data: [300, 0, 320, 0, 200, 240, 0, 0, 1]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [300, 0, 320, 0, 0, 200, 240, 0, 0, 0, 1, 0]}
"""


@pytest.fixture(autouse=True)
def _home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_HOME", str(tmp_path / "home"))


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("driver", context=make_context())


def test_a_calibration_is_loaded_from_a_file(node: zbot.Node, tmp_path: Path) -> None:
    (tmp_path / "left.yaml").write_text(FILE)
    manager = CameraInfoManager(node, "left", f"file://{tmp_path}/${{NAME}}.yaml")
    manager.loadCameraInfo()
    info = manager.getCameraInfo()
    assert manager.isCalibrated()
    assert (info.width, info.height, info.distortion_model) == (640, 480, "plumb_bob")
    assert (info.k[4], info.d[4], info.p[6]) == (200.0, 0.5, 240.0)


def test_a_calibration_is_used_only_after_it_was_loaded(node: zbot.Node) -> None:
    manager = CameraInfoManager(node)
    with pytest.raises(CameraInfoMissingError, match=r"call loadCameraInfo\(\) first"):
        manager.isCalibrated()
    manager.loadCameraInfo()
    assert not manager.isCalibrated()
    assert manager.setCameraName("other")
    with pytest.raises(CameraInfoMissingError):
        manager.getCameraInfo()


def test_a_calibration_that_was_set_is_saved(node: zbot.Node, tmp_path: Path) -> None:
    (tmp_path / "left.yaml").write_text(FILE)
    info = loadCalibrationFile(str(tmp_path / "left.yaml"), "left")
    manager = CameraInfoManager(node, "left", namespace="stereo")
    assert node.resolve_service_name(manager.svc.srv_name) == "/stereo/set_camera_info"
    request, response = SetCameraInfo.Request(camera_info=info), SetCameraInfo.Response()
    assert manager.setCameraInfo(request, response).success
    assert loadCalibrationFile(str(tmp_path / "home/camera_info/left.yaml"), "left") == info


def test_a_calibration_that_cannot_be_saved_is_an_answer(
    node: zbot.Node, tmp_path: Path, logged: list[Any]
) -> None:
    (tmp_path / "home").write_text("a file, not a folder")
    request, response = SetCameraInfo.Request(), SetCameraInfo.Response()
    assert not CameraInfoManager(node).setCameraInfo(request, response).success
    assert response.status_message == "Error storing camera calibration."
    assert any("cannot write the calibration file" in record.message for record in logged)


def test_the_file_of_another_camera_is_named(tmp_path: Path, logged: list[Any]) -> None:
    (tmp_path / "left.yaml").write_text(FILE)
    loadCalibrationFile(str(tmp_path / "left.yaml"), "right")
    assert any("[right] does not match name left" in record.message for record in logged)


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("image_width: 640", "image_width: wide", "image_width must be a number of pixels"),
        ("0, 0, 1]}\nrect", "0, 0]}\nrect", "camera_matrix must have a list `data:` of 9 numbers"),
        ("distortion_coefficients", "d", "distortion_coefficients must have a list"),
        ("image_width: 640", "image_width: [", "line "),
    ],
)
def test_a_wrong_file_is_refused_with_the_reason(
    tmp_path: Path, old: str, new: str, reason: str
) -> None:
    path = tmp_path / "left.yaml"
    path.write_text(FILE.replace(old, new, 1))
    with pytest.raises(CameraInfoError, match=f"left.yaml: {reason}"):
        loadCalibrationFile(str(path), "left")


def test_an_empty_file_is_an_empty_calibration(tmp_path: Path) -> None:
    (tmp_path / "empty.yaml").write_text("")
    assert loadCalibrationFile(str(tmp_path / "empty.yaml"), "left") == CameraInfo()
    assert saveCalibrationFile(CameraInfo(), str(tmp_path / "empty.yaml"), "left")
    assert loadCalibrationFile(str(tmp_path / "empty.yaml"), "left") == CameraInfo()


@pytest.mark.parametrize(
    ("url", "kind"),
    [
        ("", URL_empty),
        ("file:///a/b.yaml", URL_file),
        ("PACKAGE://robot/b.yaml", URL_package),
        ("package://robot", URL_invalid),
        ("package://robot/", URL_invalid),
        ("http://a/b", URL_invalid),
    ],
)
def test_urls_have_kinds(url: str, kind: int) -> None:
    assert parseURL(url) == kind


def test_wrong_urls_are_refused(node: zbot.Node) -> None:
    manager = CameraInfoManager(node)
    assert not manager.setURL("http://a/b")
    assert manager.setURL("package://no_such_package/b.yaml")
    with pytest.raises(CameraInfoMissingError, match="no package for the calibration"):
        manager.loadCameraInfo()
    manager = CameraInfoManager(node, url="camera.yaml", namespace="other")
    with pytest.raises(CameraInfoError, match="write file:///PATH or package://PACKAGE/PATH"):
        manager.loadCameraInfo()


def test_variables_of_urls_are_replaced(tmp_path: Path, logged: list[Any]) -> None:
    assert resolveURL("file://${ROS_HOME}/${NAME}", "left") == f"file://{tmp_path}/home/left"
    assert resolveURL("file:///$a${LENS}", "left") == "file:///$a${LENS}"
    assert any("unknown variable ${LENS}" in record.message for record in logged)


def test_names_of_cameras_have_letters_digits_and_underscores(node: zbot.Node) -> None:
    assert genCameraName("My cam-1") == "My_cam_1"
    assert genCameraName("") == "_"
    manager = CameraInfoManager(node)
    assert [manager.setCameraName(name) for name in ("", "a b", "a_1")] == [False, False, True]
    assert str(manager) == "[a_1]"
