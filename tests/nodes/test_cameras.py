"""Tests of usb_cam, v4l2_camera, image_tools and image_proc. Files stand in for a webcam."""

from __future__ import annotations

import struct
import sys
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from tests.nodes.conftest import arrives
from zbot_nodes.cameras.cam2image import Cam2Image
from zbot_nodes.cameras.frame_source import CameraError, FrameSource
from zbot_nodes.cameras.rectify import Rectify
from zbot_nodes.cameras.showimage import ShowImage
from zbot_nodes.cameras.usb_cam import UsbCam
from zbot_nodes.cameras.v4l2_camera import V4l2Camera
from zbot_nodes.startup.program import ParameterError

from sensor_msgs.msg import CameraInfo, Image
from std_msgs.msg import Bool
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from tests.conftest import Start
    from tests.nodes.conftest import Bench
    from zbot.log.record import Record

np = pytest.importorskip("numpy")
cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")

BLUE, GREEN, RED = 200, 100, 10
CALIBRATION = """\
image_width: 64
image_height: 48
camera_name: default_cam
distortion_model: plumb_bob
camera_matrix: {rows: 3, cols: 3, data: [60, 0, 32, 0, 60, 24, 0, 0, 1]}
distortion_coefficients: {rows: 1, cols: 5, data: [-0.3, 0.1, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [60, 0, 32, 0, 0, 60, 24, 0, 0, 0, 1, 0]}
"""


def picture() -> Any:
    return np.full((48, 64, 3), (BLUE, GREEN, RED), np.uint8)


@pytest.fixture
def pictures(tmp_path: Path) -> str:
    folder = tmp_path / "pictures"
    folder.mkdir()
    for number in range(2):
        cv2.imwrite(str(folder / f"{number}.png"), picture())
    (folder / "notes.txt").write_text("no picture")
    return str(folder)


@pytest.fixture
def video(tmp_path: Path) -> str:
    path = str(tmp_path / "video.avi")
    writer = cv2.VideoWriter(path, cv2.VideoWriter_fourcc(*"MJPG"), 20, (64, 48))
    for _ in range(3):
        writer.write(picture())
    writer.release()
    return path


def test_a_video_and_a_folder_begin_again_at_their_end(video: str, pictures: str) -> None:
    for device in (video, pictures):
        source = FrameSource(device, 640, 480, 30.0)
        for _ in range(7):
            assert source.read().shape == (48, 64, 3)
        source.close()


def huge_picture() -> bytes:
    """Return a small file of a picture that would need 15 GB."""
    size = struct.pack(">IIBBBBB", 70_000, 70_000, 8, 2, 0, 0, 0)
    parts = ((b"IHDR", size), (b"IDAT", zlib.compress(b"")), (b"IEND", b""))
    chunks = (
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in parts
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def test_pictures_are_read_from_any_folder_without_damaged_ones(
    pictures: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, logged: list[Record]
) -> None:
    monkeypatch.setattr(cv2, "imread", lambda *_: None)  # it is so in such a folder on Windows
    folder = Path(pictures).rename(tmp_path / "Jürgen")
    damaged = {"00.png": b"", "01.jpg": b"no picture", "2.png": b"\x89PNG", "4.png": huge_picture()}
    for name, content in damaged.items():
        (folder / name).write_bytes(content)
    (folder / "3.png").mkdir()
    source = FrameSource(str(folder), 640, 480, 30.0)
    for _ in range(5):
        assert source.read()[0, 0].tolist() == [BLUE, GREEN, RED]
    assert len([record for record in logged if "is left out" in record.message]) == 5


def test_a_webcam_that_gives_no_more_images_is_opened_again(
    bench: Bench, video: str, monkeypatch: pytest.MonkeyPatch, logged: list[Record]
) -> None:
    node = bench.run(UsbCam, {"video_device": video})
    images = bench.watch(Image, "/image_raw")
    assert arrives(lambda: images)
    assert isinstance(node, UsbCam)
    with monkeypatch.context() as patch:
        patch.setattr(FrameSource, "read", lambda _: None)
        assert arrives(lambda: any("gives no images" in record.message for record in logged))
    assert arrives(lambda: any(record.message == "the camera is back" for record in logged))


def test_usb_cam_publishes_images_with_their_calibration(
    bench: Bench, video: str, tmp_path: Path
) -> None:
    file = tmp_path / "camera.yaml"
    file.write_text(CALIBRATION)
    parameters = {"video_device": video, "camera_info_url": f"file://{file}", "framerate": 50.0}
    bench.run(UsbCam, parameters)
    images, infos = bench.watch(Image, "/image_raw"), bench.watch(CameraInfo, "/camera_info")
    assert arrives(lambda: images and infos)
    image = images[-1]
    assert (image.width, image.height, image.encoding, image.step) == (64, 48, "rgb8", 192)
    assert image.header.frame_id == "default_cam"
    assert abs(image.data[0] - RED) < 20  # the video is compressed
    assert abs(image.data[2] - BLUE) < 20
    assert infos[-1].k[0] == 60.0
    stamps = {info.header.stamp.nanosec for info in infos}
    assert arrives(lambda: any(image.header.stamp.nanosec in stamps for image in images))


def test_the_service_set_capture_stops_the_images(bench: Bench, video: str) -> None:
    bench.run(UsbCam, {"video_device": video})
    images = bench.watch(Image, "/image_raw")
    assert arrives(lambda: images)
    stopped = bench.call(SetBool, "/set_capture", SetBool.Request(data=False))
    assert (stopped.success, stopped.message) == (True, "Stop Capturing")
    count = len(images)
    bench.call(SetBool, "/set_capture", SetBool.Request(data=True))
    assert arrives(lambda: len(images) > count + 1)


def test_v4l2_camera_has_the_parameters_of_its_package(bench: Bench, pictures: str) -> None:
    parameters = {
        "video_device": pictures,
        "output_encoding": "mono8",
        "time_per_frame": [1, 50],
        "camera_frame_id": "eye",
    }
    bench.run(V4l2Camera, parameters)
    images, infos = bench.watch(Image, "/image_raw"), bench.watch(CameraInfo, "/camera_info")
    assert arrives(lambda: images and infos)
    assert (images[-1].encoding, images[-1].step) == ("mono8", 64)
    assert images[-1].header.frame_id == "eye"
    assert (infos[-1].width, infos[-1].k[0]) == (64, 0.0)


@pytest.mark.parametrize(
    ("make", "parameters", "told"),
    [
        (UsbCam, {"framerate": 0.0}, "framerate must be above 0"),
        (UsbCam, {"image_width": 0}, "width of images must be above 0"),
        (V4l2Camera, {"output_encoding": "yuv"}, "output_encoding must be one of"),
        (V4l2Camera, {"image_size": [640]}, "image_size must be two numbers above 0"),
        (Cam2Image, {"reliability": "good"}, "reliability must be reliable or best_effort"),
        (Rectify, {"interpolation": 9}, "interpolation must be 0 to 4"),
    ],
)
def test_a_wrong_parameter_is_named(
    bench: Bench, make: Any, parameters: dict[str, Any], told: str
) -> None:
    with pytest.raises(ParameterError, match=told):
        bench.run(make, parameters)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the sentence is that of Linux")
def test_a_missing_camera_is_one_sentence(start: Start) -> None:
    device = ("--ros-args", "-p", "video_device:=/dev/video97")
    program = start("zbot", "run", "usb_cam", "usb_cam_node_exe", *device)
    assert program.wait() == 1
    assert program.output.splitlines()[-1].startswith("error: there is no camera /dev/video97: ")
    assert "Traceback" not in program.output


def test_what_is_no_video_is_named(tmp_path: Path) -> None:
    text = tmp_path / "a.mp4"
    text.write_text("no video")
    empty = tmp_path / "empty"
    empty.mkdir()
    (empty / "a.png").write_text("no picture")
    for device, told in (
        (str(text), "no video that OpenCV can read"),
        (str(empty), "it needs pictures such as .png"),
        (str(tmp_path / "no"), "there is no camera, no video and no folder"),
    ):
        with pytest.raises(CameraError, match=told):
            FrameSource(device, 640, 480, 30.0)


def test_cam2image_has_a_picture_without_a_camera_and_mirrors_it(bench: Bench) -> None:
    node = bench.run(Cam2Image, {"burger_mode": True, "frequency": 50.0})
    images = bench.watch(Image, "/image")
    assert arrives(lambda: len(images) > 1)
    assert (images[-1].width, images[-1].height, images[-1].encoding) == (320, 240, "bgr8")
    assert bytes(images[0].data) != bytes(images[1].data)
    bench.publisher(Bool, "/flip_image").publish(Bool(data=True))
    assert isinstance(node, Cam2Image)
    assert arrives(lambda: node.is_flipped)


def test_images_are_seen_in_another_process(start: Start, pictures: str) -> None:
    camera = ("image_tools", "cam2image", "--ros-args", "-p", f"video_device:={pictures}")
    start("zbot", "run", *camera).wait_for("Publishing image #1")
    shown = start("zbot", "run", "image_tools", "showimage")
    shown.wait_for("Received image #camera_frame")


def test_showimage_receives_images(bench: Bench, logged: list[Record]) -> None:
    bench.run(ShowImage, {"show_image": False})
    bench.publisher(Image, "/image").publish(Image())
    assert arrives(lambda: any(record.message == "Received image #" for record in logged))


def rectifier(bench: Bench, info: CameraInfo) -> tuple[Any, list[Image]]:
    bench.run(Rectify)
    rectified = bench.watch(Image, "/image_rect")
    bench.publisher(CameraInfo, "/camera_info").publish(info)
    return bench.publisher(Image, "/image"), rectified


def lines() -> Image:
    """Return a picture with a straight line near its left edge."""
    array = np.zeros((48, 64), np.uint8)
    array[:, 8] = 255
    return Image(width=64, height=48, encoding="mono8", step=64, data=array.tobytes())


def calibrated(*distortion: float) -> CameraInfo:
    info = CameraInfo(width=64, height=48, distortion_model="plumb_bob", d=list(distortion))
    info.k = [60.0, 0.0, 32.0, 0.0, 60.0, 24.0, 0.0, 0.0, 1.0]
    info.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    info.p = [60.0, 0.0, 32.0, 0.0, 0.0, 60.0, 24.0, 0.0, 0.0, 0.0, 1.0, 0.0]
    return info


def published(publisher: Any, image: Image, heard: list[Image]) -> bool:
    """Publish until an image is rectified: the calibration may come after the first image."""

    def is_heard() -> bool:
        publisher.publish(image)
        return bool(heard)

    return arrives(is_heard)


def test_rectify_takes_the_distortion_out(bench: Bench) -> None:
    publisher, rectified = rectifier(bench, calibrated(-0.3, 0.1, 0.0, 0.0, 0.0))
    image = lines()
    assert published(publisher, image, rectified)
    assert (rectified[0].width, rectified[0].encoding) == (64, "mono8")
    raw = np.frombuffer(bytes(image.data), np.uint8).reshape(48, 64)
    matrix = np.array([[60.0, 0, 32], [0, 60.0, 24], [0, 0, 1]])
    expected = cv2.undistort(raw, matrix, np.array([-0.3, 0.1, 0, 0, 0]))
    found = np.frombuffer(bytes(rectified[0].data), np.uint8).reshape(48, 64)
    assert np.abs(expected.astype(int) - found.astype(int)).mean() < 2
    assert not np.array_equal(found, raw)


def test_an_image_without_distortion_stays(bench: Bench) -> None:
    publisher, rectified = rectifier(bench, calibrated(0.0, 0.0, 0.0, 0.0, 0.0))
    assert published(publisher, lines(), rectified)
    assert rectified[0].data == lines().data


def test_a_camera_without_calibration_is_named(bench: Bench, logged: list[Record]) -> None:
    publisher, _ = rectifier(bench, CameraInfo(width=64, height=48))

    def is_named() -> bool:
        publisher.publish(lines())
        return any("the camera is not calibrated" in record.message for record in logged)

    assert arrives(is_named)
