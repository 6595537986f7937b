"""File with the calibration of a camera, in the form of ROS 2's camera_calibration."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from zbot.errors import ZbotError
from zbot.log.logger import get_logger
from zbot.text.yaml_reader import YamlError, read_yaml

from sensor_msgs.msg import CameraInfo

#: Matrices: their names in a file, the field of the message, and the number of rows and columns.
_MATRICES = (
    ("camera_matrix", "k", (3, 3)),
    ("rectification_matrix", "r", (3, 3)),
    ("projection_matrix", "p", (3, 4)),
)
_DISTORTION = "distortion_coefficients"
_MAX_PIXELS = 2**32 - 1


class CameraInfoError(ZbotError, ValueError):
    """A calibration of a camera cannot be used."""


def loadCalibrationFile(filename: str, cname: str) -> CameraInfo:
    """Return the calibration in a file. It is empty if the file is empty or does not exist.

    If the file is for a camera with another name than `cname`, the log warns.

    Raises:
        OSError: The file exists, but cannot be read.
        CameraInfoError: The file is not a calibration.
    """
    path = Path(filename)
    if not path.exists():
        return CameraInfo()
    try:
        name, info = read_calibration(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise CameraInfoError(f"cannot use the calibration file {filename}: {error}") from error
    if name not in {cname, ""}:
        text = f"[{cname}] does not match name {name} in file {filename}"
        get_logger("camera_info_manager").warning(text)
    return info


def read_calibration(text: str) -> tuple[str, CameraInfo]:
    """Return the name of the camera and the calibration in a text.

    Raises:
        CameraInfoError: The text is not a calibration.
    """
    try:
        values = read_yaml(text)
    except YamlError as error:
        raise CameraInfoError(str(error)) from error
    if values is None:
        return "", CameraInfo()
    if not isinstance(values, dict):
        raise CameraInfoError("write `camera_name:`, `image_width:` and so on")
    info = CameraInfo(
        width=_pixels(values, "image_width"),
        height=_pixels(values, "image_height"),
        distortion_model=str(values.get("distortion_model", "")),
        d=_numbers(values, _DISTORTION, 0),
    )
    for name, field, (rows, columns) in _MATRICES:
        setattr(info, field, _numbers(values, name, rows * columns))
    return str(values.get("camera_name", "")), info


def _pixels(values: dict[Any, Any], name: str) -> int:
    value = values.get(name)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= _MAX_PIXELS:
        raise CameraInfoError(f"{name} must be a number of pixels")
    return value


def _numbers(values: dict[Any, Any], name: str, count: int) -> list[float]:
    """Return the numbers of a matrix. `count` is how many it must have; 0: any number."""
    matrix = values.get(name)
    data = matrix.get("data") if isinstance(matrix, dict) else None
    try:
        found = [float(number) for number in data] if isinstance(data, list) else []
    except (TypeError, ValueError, OverflowError):
        found = []
    if not isinstance(data, list) or len(found) != (count or len(data)):
        raise CameraInfoError(f"{name} must have a list `data:` of {count or 'the'} numbers")
    return found


def saveCalibrationFile(ci: CameraInfo, filename: str, cname: str) -> bool:
    """Write a calibration into a file. Missing folders are made.

    Returns:
        Whether the file could be written. The log has the reason if not.
    """
    try:
        Path(filename).parent.mkdir(parents=True, exist_ok=True)
        Path(filename).write_text(calibration_text(ci, cname), encoding="utf-8")
    except OSError as error:
        text = f"cannot write the calibration file {filename}: {error.strerror or error}"
        get_logger("camera_info_manager").error(text)
        return False
    return True


def calibration_text(info: CameraInfo, name: str) -> str:
    """Return a calibration as YAML."""
    import yaml  # noqa: PLC0415 - takes 15 ms, and most programs save nothing

    values: dict[str, Any] = {
        "image_width": int(info.width),
        "image_height": int(info.height),
        "camera_name": name,
        "distortion_model": info.distortion_model,
        _DISTORTION: _matrix(info.d, 1, len(info.d)),
    }
    for key, field, (rows, columns) in _MATRICES:
        values[key] = _matrix(getattr(info, field), rows, columns)
    text: str = yaml.safe_dump(values, sort_keys=False, default_flow_style=None)
    return text


def _matrix(values: Any, rows: int, columns: int) -> dict[str, Any]:
    return {"rows": rows, "cols": columns, "data": [float(value) for value in values]}
