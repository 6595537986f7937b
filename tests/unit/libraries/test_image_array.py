"""Tests of the conversion between images and arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from zbot.libraries.image_array import CvBridge, CvBridgeError, cvtColorForDisplay, getCvType

from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Header

if TYPE_CHECKING:
    from collections.abc import Callable

np = pytest.importorskip("numpy")
BRIDGE = CvBridge()
RGB = np.array([[[255, 0, 10], [1, 2, 3]]], np.uint8)


@pytest.mark.parametrize(
    ("shape", "dtype", "encoding", "as_passed"),
    [
        ((2, 3, 3), "uint8", "bgr8", "8UC3"),
        ((2, 3, 4), "uint8", "rgba8", "8UC4"),
        ((2, 3), "uint8", "mono8", "8UC1"),
        ((2, 3), "uint16", "mono16", "16UC1"),
        ((2, 3), "float32", "32FC1", "32FC1"),
        ((2, 3, 2), "float64", "64FC2", "64FC2"),
        ((2, 3), "uint8", "bayer_rggb8", "8UC1"),
    ],
)
def test_an_array_survives_the_message(
    shape: tuple[int, ...], dtype: str, encoding: str, as_passed: str
) -> None:
    array = np.arange(np.prod(shape)).reshape(shape).astype(dtype)
    image = BRIDGE.cv2_to_imgmsg(array, encoding, header=Header(frame_id="camera"))
    assert (image.height, image.width, image.encoding) == (2, 3, encoding)
    assert image.step * image.height == len(image.data) == array.nbytes
    assert image.header.frame_id == "camera"
    back = BRIDGE.imgmsg_to_cv2(image)
    assert back.dtype == array.dtype
    assert back.tolist() == array.tolist()
    assert BRIDGE.cv2_to_imgmsg(array).encoding == as_passed


@pytest.mark.parametrize(
    ("source", "target", "expected"),
    [
        ("rgb8", "bgr8", [[[10, 0, 255], [3, 2, 1]]]),
        ("bgr8", "rgba8", [[[10, 0, 255, 255], [3, 2, 1, 255]]]),
        ("rgb8", "mono8", [[77, 2]]),
        ("bgr8", "mono8", [[32, 2]]),
        ("rgb8", "rgb16", [[[65535, 0, 2570], [257, 514, 771]]]),
        ("rgb8", "8UC3", RGB.tolist()),
    ],
)
def test_colors_are_converted(source: str, target: str, expected: Any) -> None:
    image = BRIDGE.cv2_to_imgmsg(RGB, source)
    assert BRIDGE.imgmsg_to_cv2(image, target).tolist() == expected


def test_grey_becomes_color_and_wide_becomes_narrow() -> None:
    grey = BRIDGE.cv2_to_imgmsg(np.array([[0, 65535, 32768]], np.uint16), "mono16")
    assert BRIDGE.imgmsg_to_cv2(grey, "mono8").tolist() == [[0, 255, 128]]
    assert BRIDGE.imgmsg_to_cv2(grey, "bgr8").tolist() == [[[0] * 3, [255] * 3, [128] * 3]]
    depth = BRIDGE.cv2_to_imgmsg(np.array([[-1.0, 300.0]], np.float32), "32FC1")
    assert BRIDGE.imgmsg_to_cv2(depth, "8UC1").tolist() == [[0, 255]]


def test_padding_and_byte_order_are_those_of_the_image() -> None:
    data = bytes([0, 1, 9, 0, 2, 9])
    image = Image(height=2, width=1, encoding="16UC1", is_bigendian=1, step=3, data=data)
    assert BRIDGE.imgmsg_to_cv2(image).tolist() == [[1], [2]]


@pytest.mark.parametrize(
    ("encoding", "target", "sentence"),
    [
        ("8UC3", "bgr8", "8UC3 cannot be converted to bgr8"),
        ("rgb8", "8UC1", "rgb8 cannot be converted to 8UC1"),
        ("rgb8", "purple8", "unknown encoding 'purple8'"),
    ],
)
def test_an_impossible_conversion_is_refused(encoding: str, target: str, sentence: str) -> None:
    image = BRIDGE.cv2_to_imgmsg(RGB, encoding)
    with pytest.raises(CvBridgeError, match=sentence):
        BRIDGE.imgmsg_to_cv2(image, target)


def test_an_array_of_another_type_than_the_encoding_is_refused() -> None:
    with pytest.raises(CvBridgeError, match="mono8, but image has the type 8UC3"):
        BRIDGE.cv2_to_imgmsg(RGB, "mono8")
    with pytest.raises(TypeError, match="numpy array, not a list"):
        BRIDGE.cv2_to_imgmsg([[1]])  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("array", "encoding", "sentence"),
    [
        (np.zeros((4, 4, 3)), "bgr8", r"64FC3: write image\.astype\(numpy\.uint8\)"),
        (np.zeros((4, 4), np.uint8), "bgr8", "8UC1: write the encoding 'mono8'"),
        (np.zeros((4, 4, 4), np.uint8), "rgb8", "8UC4: write the encoding 'bgra8'"),
        (np.zeros(4), "bgr8", "2 or 3 dimensions, not 1"),
        (RGB, 1, r"an encoding is a text, e\.g\. 'bgr8', not int: 1"),
    ],
)
def test_an_array_that_does_not_fit_is_told_with_what_to_write(
    array: Any, encoding: Any, sentence: str
) -> None:
    with pytest.raises(CvBridgeError, match=sentence):
        BRIDGE.cv2_to_imgmsg(array, encoding)


@pytest.mark.parametrize(
    ("convert", "sentence"),
    [
        (lambda b: b.imgmsg_to_cv2(CompressedImage()), r"write compressed_imgmsg_to_cv2\(\)"),
        (lambda b: b.imgmsg_to_cv2(Image), "type Image, not the class Image"),
        (lambda b: b.compressed_imgmsg_to_cv2(Image()), r"write imgmsg_to_cv2\(\)"),
        (lambda b: b.compressed_imgmsg_to_cv2(None), "type CompressedImage, not None"),
        (lambda b: b.cv2_to_imgmsg(None, "bgr8"), r"not None, which cv2\.imread\(\)"),
        (lambda b: b.cv2_to_compressed_imgmsg(None), r"not None, which cv2\.imread\(\)"),
        (lambda _: CvBridge.imgmsg_to_cv2(Image(), "bgr8"), r"write CvBridge\(\), with"),  # type: ignore[arg-type]
        (lambda _: CvBridge.cv2_to_imgmsg(RGB, "bgr8"), r"write CvBridge\(\), with"),  # type: ignore[arg-type]
    ],
)
def test_what_is_not_an_image_is_refused(convert: Callable[[Any], object], sentence: str) -> None:
    with pytest.raises(CvBridgeError, match=sentence) as raised:
        convert(BRIDGE)
    assert isinstance(raised.value, AttributeError)


def test_a_compressed_image_without_data_is_refused() -> None:
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    with pytest.raises(CvBridgeError, match="cannot read the image as jpeg"):
        BRIDGE.compressed_imgmsg_to_cv2(CompressedImage(format="jpeg"))


def test_an_image_that_is_too_short_is_refused() -> None:
    image = Image(height=2, width=2, encoding="rgb8", step=6, data=b"abc")
    with pytest.raises(CvBridgeError, match="needs 12 bytes, but it has 3"):
        BRIDGE.imgmsg_to_cv2(image)


def test_compressed_images_without_opencv_name_the_package_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "cv2", None)
    with pytest.raises(CvBridgeError, match="pip install opencv-python-headless"):
        BRIDGE.compressed_imgmsg_to_cv2(CompressedImage(format="jpeg"))


def test_a_compressed_image_is_read_back() -> None:
    pytest.importorskip("cv2", reason="OpenCV is not installed")
    array = np.full((4, 4, 3), 100, np.uint8)
    image = BRIDGE.cv2_to_compressed_imgmsg(array, "png")
    assert image.format == "png"
    assert BRIDGE.compressed_imgmsg_to_cv2(image, "mono8").tolist() == [[100] * 4] * 4


@pytest.mark.parametrize(
    ("encoding", "number"),
    [
        ("8UC1", 0),
        ("8U", 0),
        ("mono16", 2),
        ("bgr8", 16),
        ("rgba8", 24),
        ("32FC4", 29),
        ("64FC1", 6),
    ],
)
def test_types_have_the_numbers_of_opencv(encoding: str, number: int) -> None:
    assert getCvType(encoding) == number


def test_depths_are_shown_as_greys() -> None:
    depths = np.array([[0.0, 1.0], [np.nan, 5.0]], np.float32)
    fixed = cvtColorForDisplay(depths, "32FC1", "mono8", min_image_value=0, max_image_value=2)
    assert fixed.tolist() == [[0, 128], [0, 255]]
    scaled = cvtColorForDisplay(depths, "32FC1", "", do_dynamic_scaling=True)
    assert scaled.tolist() == [[[0] * 3, [51] * 3], [[0] * 3, [255] * 3]]


def test_equal_values_are_shown_as_a_middle_grey() -> None:
    equal = np.ones((1, 2), np.float32)
    assert cvtColorForDisplay(equal, "32FC1", "mono8", True).tolist() == [[128, 128]]


def test_colours_are_shown_as_they_are() -> None:
    blue = np.array([[[255, 0, 0]]], np.uint8)
    assert cvtColorForDisplay(blue, "bgr8", "rgb8").tolist() == [[[0, 0, 255]]]
    wide = np.array([[65535, 0]], np.uint16)
    assert cvtColorForDisplay(wide, "16UC1", "mono8").tolist() == [[255, 0]]


@pytest.mark.parametrize(
    ("encoding", "target", "reason"),
    [("bgr8", "bgr16", "no encoding of 8 bits"), ("bgr8", "mono8", "only images with one channel")],
)
def test_what_cannot_be_shown_is_refused(encoding: str, target: str, reason: str) -> None:
    with pytest.raises(CvBridgeError, match=reason):
        cvtColorForDisplay(np.zeros((1, 1, 3), np.uint8), encoding, target, max_image_value=9.0)
