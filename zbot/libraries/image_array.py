"""Conversion between images and numpy arrays: `CvBridge` of ROS 2's `cv_bridge`.

This module needs numpy (`pip install "zbot[numpy]"`). Only Bayer patterns, YUV and compressed
images need OpenCV.
"""

from __future__ import annotations

import re
import sys
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError, described, require_numpy
from zbot.errors.installation import pip_install
from zbot.executor.errors import WrongObjectError

from sensor_msgs.msg import CompressedImage, Image

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from std_msgs.msg import Header

#: Generic encodings: bits, kind of number and channels, as in 8UC3, 32FC1, 16UC.
_GENERIC = re.compile(r"(8|16|32|64)(U|S|F)C([0-9]{0,3})\Z")
_KINDS = {"U": "u", "S": "i", "F": "f"}
#: Indices of red, green, blue and alpha in colour encodings.
_ORDERS = {"rgb": (0, 1, 2), "bgr": (2, 1, 0), "rgba": (0, 1, 2, 3), "bgra": (2, 1, 0, 3)}
_COLOR = re.compile(r"(rgba|bgra|rgb|bgr|mono)(8|16)\Z")
#: OpenCV's conversions to bgr8, for the encodings that numpy alone cannot convert.
_CV_TO_BGR = {
    "bayer_rggb8": "COLOR_BayerBG2BGR",
    "bayer_bggr8": "COLOR_BayerRG2BGR",
    "bayer_gbrg8": "COLOR_BayerGR2BGR",
    "bayer_grbg8": "COLOR_BayerGB2BGR",
    "yuv422": "COLOR_YUV2BGR_UYVY",
    "uyvy": "COLOR_YUV2BGR_UYVY",
    "yuv422_yuy2": "COLOR_YUV2BGR_YUY2",
    "yuyv": "COLOR_YUV2BGR_YUY2",
}
#: OpenCV's numbers of depths.
_DEPTHS = {"8U": 0, "8S": 1, "16U": 2, "16S": 3, "32S": 4, "32F": 5, "64F": 6}
# Weights of red, green and blue in grey, from ITU-R BT.601, as in OpenCV.
_LUMA = (0.299, 0.587, 0.114)
_USUAL_ENCODINGS = {"8UC1": "mono8", "8UC3": "bgr8", "8UC4": "bgra8", "16UC1": "mono16"}
_READERS: dict[type[Any], str] = {
    Image: "imgmsg_to_cv2",
    CompressedImage: "compressed_imgmsg_to_cv2",
}
_FILE_NAMES = {"jpg": "jpeg", "jpe": "jpeg", "tif": "tiff"}


class CvBridgeError(ZbotError, TypeError):
    """An image cannot be converted as requested."""


class NotAnImageError(CvBridgeError, WrongObjectError):
    """A function was given something else than an image (cv_bridge: AttributeError)."""


class CvBridge:
    """Converter between image messages and arrays of shape (height, width[, channels]).

    Raises:
        MissingPackageError: numpy is not installed.
    """

    def __init__(self) -> None:
        require_numpy("cv_bridge")

    def imgmsg_to_cv2(self, img_msg: Image, desired_encoding: str = "passthrough") -> NDArray[Any]:
        """Return an image as an array.

        Args:
            img_msg: The image. Its pixels are copied only if they are converted.
            desired_encoding: For example `bgr8` or `mono8`. `passthrough` keeps the encoding.

        Raises:
            NotAnImageError: `img_msg` is not an `Image`.
            CvBridgeError: The encoding or conversion does not exist, or the image lacks data.
        """
        _check_message(self, Image, img_msg, "encoding")
        array = _pixels(img_msg)
        if desired_encoding in {"passthrough", img_msg.encoding}:
            return array
        return converted(array, img_msg.encoding, desired_encoding)

    def cv2_to_imgmsg(
        self, cvim: NDArray[Any], encoding: str = "passthrough", header: Header | None = None
    ) -> Image:
        """Return an array as an image.

        Args:
            cvim: Array of shape (height, width) or (height, width, channels).
            encoding: Encoding of the array, for example `bgr8` or `32FC1`. Nothing is converted.
            header: Header of the image.

        Raises:
            NotAnImageError: `cvim` is not an array.
            CvBridgeError: The shape or the type of the array does not fit the encoding.
        """
        _check_array(self, cvim)
        if cvim.ndim not in {2, 3}:
            raise CvBridgeError(f"an image has 2 or 3 dimensions, not {cvim.ndim}")
        channels = cvim.shape[2] if cvim.ndim == 3 else 1
        actual = self.dtype_with_channels_to_cvtype2(cvim.dtype, channels)
        if encoding == "passthrough":
            encoding = actual
        elif self.encoding_to_cvtype2(encoding) != actual:
            raise _wrong_encoding_error(encoding, actual, channels)
        order = cvim.dtype.byteorder
        image = Image(
            height=cvim.shape[0],
            width=cvim.shape[1],
            encoding=encoding,
            is_bigendian=int(order == ">" or (order == "=" and sys.byteorder == "big")),
            step=cvim.shape[1] * channels * cvim.dtype.itemsize,
            data=cvim.tobytes(),
        )
        if header is not None:
            image.header = header
        return image

    def compressed_imgmsg_to_cv2(
        self, cmprs_img_msg: CompressedImage, desired_encoding: str = "passthrough"
    ) -> NDArray[Any]:
        """Return a compressed image as an array, as OpenCV reads it or in the requested encoding.

        Raises:
            NotAnImageError: `cmprs_img_msg` is not a `CompressedImage`.
            CvBridgeError: OpenCV is not installed, or cannot read the image.
        """
        import numpy as np  # noqa: PLC0415 - part of an extra

        _check_message(self, CompressedImage, cmprs_img_msg, "data")
        cv2 = _opencv("images that are compressed")
        octets = np.frombuffer(bytes(cmprs_img_msg.data), np.uint8)
        array: NDArray[Any] | None = None
        if octets.size:  # otherwise OpenCV raises an error of its own
            array = cv2.imdecode(octets, cv2.IMREAD_UNCHANGED)
        if array is None:
            _check_message(self, CompressedImage, cmprs_img_msg, "format")
            raise CvBridgeError(f"cannot read the image as {cmprs_img_msg.format or 'any format'}")
        if desired_encoding == "passthrough":
            return array
        bits = 8 * array.dtype.itemsize
        name = {2: "mono", 3: "bgr", 4: "bgra"}[array.ndim if array.ndim == 2 else array.shape[2]]
        return converted(array, f"{name}{bits}", desired_encoding)

    def cv2_to_compressed_imgmsg(
        self, cvim: NDArray[Any], dst_format: str = "jpg", header: Header | None = None
    ) -> CompressedImage:
        """Return an array (grey or blue-green-red) as a compressed image, `jpg` or `png`.

        Raises:
            NotAnImageError: `cvim` is not an array.
            CvBridgeError: OpenCV is not installed, or cannot write this format.
        """
        _check_array(self, cvim)
        cv2 = _opencv("images that are compressed")
        is_written, octets = cv2.imencode(f".{dst_format}", cvim)
        if not is_written:
            raise CvBridgeError(f"OpenCV cannot write {dst_format!r}")
        image = CompressedImage(
            format=_FILE_NAMES.get(dst_format, dst_format), data=octets.tobytes()
        )
        if header is not None:
            image.header = header
        return image

    def encoding_to_dtype_with_channels(self, encoding: str) -> tuple[str, int]:
        """Return numpy's type name and the number of channels, e.g. ('uint8', 3) for `bgr8`."""
        code, channels = _layout(encoding)
        names = {"u": "uint", "i": "int", "f": "float"}
        return f"{names[code[0]]}{8 * int(code[1])}", channels

    def encoding_to_cvtype2(self, encoding: str) -> str:
        """Return OpenCV's type of an encoding, e.g. `8UC3` for `bgr8`."""
        code, channels = _layout(encoding)
        return _cv_type(code, channels)

    def dtype_with_channels_to_cvtype2(self, dtype: Any, n_channels: int) -> str:
        """Return OpenCV's type of an array, e.g. `8UC3`."""
        import numpy as np  # noqa: PLC0415 - part of an extra

        return _cv_type(np.dtype(dtype).str[1:], n_channels)

    def cvtype2_to_dtype_with_channels(self, cvtype: str) -> tuple[str, int]:
        """Return numpy's type name and the number of channels, e.g. ('uint8', 3) for `8UC3`."""
        return self.encoding_to_dtype_with_channels(cvtype)


def cvtColor2(  # noqa: N802 - ROS 2's name
    source: NDArray[Any], encoding_in: str, encoding_out: str
) -> NDArray[Any]:
    """Return an array in another encoding, e.g. `rgb8`.

    Raises:
        CvBridgeError: An encoding does not exist, or the conversion is not possible.
    """
    return source if encoding_in == encoding_out else converted(source, encoding_in, encoding_out)


def cvtColorForDisplay(  # noqa: N802, PLR0917 - ROS 2's name and arguments
    source: NDArray[Any],
    encoding_in: str,
    encoding_out: str,
    do_dynamic_scaling: bool = False,
    min_image_value: float = 0.0,
    max_image_value: float = 0.0,
    colormap: int = -1,
) -> NDArray[Any]:
    """Return an array as an image of 8 bits that a person can look at.

    Args:
        source: The array, e.g. depths.
        encoding_in: Its encoding, e.g. `32FC1`.
        encoding_out: `bgr8`, `rgb8`, `mono8` and so on. The empty text means `bgr8`.
        do_dynamic_scaling: Whether the smallest value becomes black, and the largest white.
        min_image_value: The value that becomes black. It is used if the next one is different.
        max_image_value: The value that becomes white.
        colormap: OpenCV's number of a colour map, or -1 for greys. Only scaled values have colours.

    Raises:
        CvBridgeError: The conversion is not possible.
    """
    import numpy as np  # noqa: PLC0415 - part of an extra

    target = encoding_out or "bgr8"
    match = _COLOR.match(target)
    if match is None or match[2] != "8":
        raise CvBridgeError(f"{target!r} is no encoding of 8 bits: use bgr8, rgb8 or mono8")
    low, high = min_image_value, max_image_value
    if do_dynamic_scaling:
        finite = source[np.isfinite(source)]
        low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
        if low == high:
            middle = np.full(source.shape[:2], 128, np.uint8)
            return cvtColor2(middle, "mono8", target)
    if low == high:
        return cvtColor2(
            source, {"8UC1": "mono8", "16UC1": "mono16"}.get(encoding_in, encoding_in), target
        )
    if _layout(encoding_in)[1] != 1:
        raise CvBridgeError("only images with one channel can be scaled")
    grey = _cast(np.nan_to_num(np.rint((source - low) * (255.0 / (high - low)))), "u1")
    if colormap == -1:
        return cvtColor2(grey, "mono8", target)
    colored = _opencv("colour maps").applyColorMap(grey, colormap)
    colored[np.isnan(source)] = 0
    return cvtColor2(colored, "bgr8", target)


def getCvType(encoding: str) -> int:  # noqa: N802 - ROS 2's name
    """Return OpenCV's number of an encoding's type, e.g. 16 (`cv2.CV_8UC3`) for `bgr8`.

    Raises:
        CvBridgeError: The encoding does not exist.
    """
    is_without_channels = _DEPTHS.get(encoding) is not None  # e.g. 8U
    code, channels = _layout(f"{encoding}C1" if is_without_channels else encoding)
    depth = _DEPTHS[_cv_type(code, channels).partition("C")[0]]
    return depth + 8 * (channels - 1)


def _check_bridge(bridge: object) -> None:
    if not isinstance(bridge, CvBridge):  # e.g. `CvBridge.imgmsg_to_cv2(message, "bgr8")`
        raise NotAnImageError("CvBridge is a class: write CvBridge(), with parentheses")


def _check_message(bridge: object, kind: type[Any], message: object, field: str) -> None:
    """Check that a message has a field, whatever its class is."""
    _check_bridge(bridge)
    if hasattr(message, field) and not isinstance(message, type):
        return
    given, right = described(message).partition(":")[0], _READERS.get(type(message))
    advice = f": write {right}()" if right else ""
    raise NotAnImageError(
        f"{_READERS[kind]} needs a message of the type {kind.__name__}, not {given}{advice}"
    )


def _check_array(bridge: object, array: object) -> None:
    import numpy as np  # noqa: PLC0415 - part of an extra

    _check_bridge(bridge)
    if not isinstance(array, np.ndarray):
        given = f"a {type(array).__name__}"
        if array is None:
            given = "None, which cv2.imread() and read() return if there is no image"
        raise NotAnImageError(f"give an image as a numpy array, not {given}")


def _wrong_encoding_error(encoding: str, actual: str, channels: int) -> CvBridgeError:
    dtype, wanted = CvBridge().encoding_to_dtype_with_channels(encoding)
    usual = _USUAL_ENCODINGS.get(actual, actual)
    advice = f"image.astype(numpy.{dtype})" if wanted == channels else f"the encoding {usual!r}"
    return CvBridgeError(
        f"encoding specified as {encoding}, but image has the type {actual}: write {advice}"
    )


def _layout(encoding: str) -> tuple[str, int]:
    """Return numpy's code of a value and the number of channels, e.g. ('u1', 3) for `bgr8`."""
    if not isinstance(encoding, str):
        raise CvBridgeError(f"an encoding is a text, e.g. 'bgr8', not {described(encoding)}")
    if match := _GENERIC.match(encoding):
        bits, kind, channels = match.groups()
        return f"{_KINDS[kind]}{int(bits) // 8}", int(channels or 1)
    if match := _COLOR.match(encoding):
        return f"u{int(match[2]) // 8}", len(_ORDERS.get(match[1], "1"))
    if encoding.startswith("bayer_"):
        return ("u2" if encoding.endswith("16") else "u1"), 1
    if encoding in _CV_TO_BGR:
        return "u1", 2
    raise CvBridgeError(f"unknown encoding {encoding!r}: use bgr8, rgb8, mono8, 32FC1 ...")


def _cv_type(code: str, channels: int) -> str:
    letters = {kind: letter for letter, kind in _KINDS.items()}
    if code[0] not in letters:
        raise CvBridgeError(f"an image cannot have values of the type {code!r}")
    return f"{8 * int(code[1:])}{letters[code[0]]}C{channels}"


def _pixels(image: Image) -> NDArray[Any]:
    import numpy as np  # noqa: PLC0415 - part of an extra

    code, channels = _layout(image.encoding)
    dtype = np.dtype((">" if image.is_bigendian else "<") + code)
    row = image.width * channels * dtype.itemsize
    step = max(image.step, row)
    needed = (image.height - 1) * step + row if image.height else 0
    if len(image.data) < needed:
        raise CvBridgeError(
            f"an image of {image.width}x{image.height} in {image.encoding} needs {needed} bytes, "
            f"but it has {len(image.data)}"
        )
    shape = (image.height, image.width, channels)
    strides = (step, channels * dtype.itemsize, dtype.itemsize)
    array: NDArray[Any] = np.ndarray(shape, dtype, memoryview(image.data), 0, strides)
    array = array.astype(dtype.newbyteorder("="), copy=False)
    return array[:, :, 0] if channels == 1 else array


def converted(array: NDArray[Any], source: str, target: str) -> NDArray[Any]:
    """Return an image in another encoding. Colours and grey are scaled to the new number of bits.

    Raises:
        CvBridgeError: An encoding does not exist, or the conversion is not possible.
    """
    (_, have), (code, want) = _layout(source), _layout(target)
    if source in _CV_TO_BGR:
        cv2 = _opencv(f"images in {source}")
        array, source = cv2.cvtColor(array, getattr(cv2, _CV_TO_BGR[source])), "bgr8"
    origin, goal = _COLOR.match(source), _COLOR.match(target)
    if origin and goal:
        return _scaled(_recolored(array, origin[1], goal[1]), code)
    if goal or have != want:
        raise CvBridgeError(
            f"an image in {source} cannot be converted to {target}: use 'passthrough', or "
            "an encoding of the same kind"
        )
    return _cast(array, code)


def _recolored(array: NDArray[Any], source: str, target: str) -> NDArray[Any]:
    import numpy as np  # noqa: PLC0415 - part of an extra

    if source == target:
        return array
    if target == "mono":
        grey = sum(
            weight * array[:, :, place].astype(np.float64)
            for weight, place in zip(_LUMA, _ORDERS[source][:3], strict=True)
        )
        return _cast(np.rint(grey), array.dtype.str[1:])
    channels = {
        place: array if source == "mono" else array[:, :, _ORDERS[source][color]]
        for color, place in enumerate(_ORDERS[target][:3])
    }
    if len(target) == 4:
        opaque = np.full(array.shape[:2], np.iinfo(array.dtype).max, array.dtype)
        channels[3] = array[:, :, 3] if len(source) == 4 and source != "mono" else opaque
    return np.dstack([channels[place] for place in sorted(channels)])


def _scaled(array: NDArray[Any], code: str) -> NDArray[Any]:
    """Convert values from 8 to 16 bits (255 becomes 65535) or from 16 to 8 bits."""
    import numpy as np  # noqa: PLC0415 - part of an extra

    if array.dtype.itemsize == int(code[1]):
        return array
    factor = 65535 / 255 if code == "u2" else 255 / 65535
    return _cast(np.rint(array * factor), code)


def _cast(array: NDArray[Any], code: str) -> NDArray[Any]:
    import numpy as np  # noqa: PLC0415 - part of an extra

    dtype: np.dtype[Any] = np.dtype(code)
    if dtype.kind == "f":
        return array.astype(dtype, copy=False)
    limits = np.iinfo(dtype)
    clipped: NDArray[Any] = np.clip(array, limits.min, limits.max)
    return clipped.astype(dtype)


def _opencv(purpose: str) -> Any:
    try:
        import cv2  # type: ignore[import-not-found,unused-ignore] # noqa: PLC0415 - optional
    except ImportError:
        text = f"{purpose} need OpenCV: {pip_install('opencv-python-headless')}"
        raise CvBridgeError(text) from None
    return cv2
